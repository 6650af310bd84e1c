// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_EXACT_CORNERS_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_EXACT_CORNERS_H

#include "aspects/tree/pose_tree.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

// Widths of regions are multiples of one unit, at most 2^23 of them. Divided 2^28 times a corner then needs
// 23 + 28 = 51 bits of the 53 that a double has, and a center one more.
inline constexpr int bits_of_corners = 23;

/// That unit, of an interval whose ends are this far from zero at the most. It is as fine as it can be: the
/// region is then cut alike in every unit of length.
inline double unit_of_corners(double farthest) noexcept {
  return std::ldexp(1.0, std::ilogb(farthest) + 1 - bits_of_corners);
}

/// Whether all corners of boxes are exact in an interval: its width is a multiple of the unit, and its ends
/// of the edges of the smallest boxes.
inline bool has_exact_corners(double lower, double upper) noexcept {
  const double unit = unit_of_corners(std::max(std::abs(lower), std::abs(upper)));
  const double edge = std::ldexp(unit, -static_cast<int>(PoseTree::deepest_level));
  return std::isnormal(edge) && std::remainder(lower, edge) == 0.0 && std::remainder(upper, edge) == 0.0 &&
         std::remainder(upper - lower, unit) == 0.0;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_EXACT_CORNERS_H
