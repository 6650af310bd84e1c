// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_GATE_LINE_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_GATE_LINE_H

#include "draw/page/page_elements.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects::tools {

/// The circle of a node [px].
struct NodeCircle {
  PagePoint middle = PagePoint::Zero();
  double radius = 0.0;
};

/// A cubic Bezier curve: its ends, with its control points between them. Straight where these lie on the
/// chord.
struct GateLine {
  std::array<PagePoint, 4> points;

  PagePoint at(double share) const;
  bool is_straight() const;
};

/// The least bent line between the middles of two circles that stays within the bounds and clear of every
/// other circle, so that it does not read as if these were joined. Empty where none of those that are tried
/// does.
std::optional<GateLine> line_between(const std::vector<NodeCircle>& circles, std::size_t first,
                                     std::size_t second, const Eigen::AlignedBox2d& bounds);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_GATE_LINE_H
