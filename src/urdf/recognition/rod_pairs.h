// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_ROD_PAIRS_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_ROD_PAIRS_H

#include "urdf/closing/chain.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Why a platform turns though legs hold it by rods in pairs, as those of a Delta: the pair whose ends are
/// farthest from a parallelogram, or that all are parallelograms which are turned against each other. Nothing
/// where no leg has a pair of rods. `size`: of the robot [m].
std::optional<std::string> reason_to_turn(const std::vector<LegChains>& legs, double size);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_ROD_PAIRS_H
