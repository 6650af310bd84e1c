// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STARS_FOLDED_LEG_H
#define PARALLEL_ASPECTS_ASPECTS_STARS_FOLDED_LEG_H

#include "aspects/boxes/box_stage.h"
#include "aspects/boxes/charts.h"
#include "aspects/stars/stars.h"

#include <array>

namespace parallel_aspects {

/// Of a box near poses in which a leg with crank and rod of one length is folded, its anchor at its base
/// point: proves that all that S(signs, sign) has there is connected, and gives a pose of it. B_jj^2 vanishes
/// there as a sum of two squares, so that no other star does; docs/maps.md, "Folded legs", has the proof.
/// Nothing is known where no leg folds near the box, or where the robot has limits or other constraints
/// there.
Stars find_stars_about_fold(const ChartBox<SE2Chart>& at, const Box& region, const std::array<int, 3>& signs,
                            int sign) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STARS_FOLDED_LEG_H
