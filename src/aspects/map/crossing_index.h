// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_CROSSING_INDEX_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_CROSSING_INDEX_H

#include "parallel_aspects/aspects/neighbours.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>

namespace parallel_aspects {

/// `GateCrossing::index` of a crossing that begins there, of B_jj = 0 of a leg or of det A = 0: the least
/// index of other singularities and of what is left to limits; -1 where a leg does not reach.
double crossing_index(const Manipulator& robot, const Pose& pose, const WorkingMode& mode, Crossing crossing,
                      std::size_t leg);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_CROSSING_INDEX_H
