// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H

#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/uniqueness.h"

#include <memory>

namespace parallel_aspects {

/// Of legs of any kind, but elbows, with one joint held. The map, of this slice, tells the aspects of
/// solutions; without one none are known.
SolutionNumbers find_solution_numbers(const Manipulator& manipulator, const HeldJoint& held,
                                      std::shared_ptr<const AspectMap> map, const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H
