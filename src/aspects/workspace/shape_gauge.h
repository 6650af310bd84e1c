// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_GAUGE_H
#define PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_GAUGE_H

#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/regular_workspace.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// A regular shape as the unit ball of a norm of displacements: the shape of size s about a center holds what
/// is at a distance of s or less from it. So distances bound sizes, and the largest shape about a center
/// changes by no more than the center moves.
///
/// Coordinates are multiplied by scales; those of one group count by their Euclidean norm, and the largest
/// group counts. Other coordinates of boxes than the first `dimension()` are not looked at.
class ShapeGauge {
 public:
  ShapeGauge(const WorkspaceQuestion& question, std::size_t dimension);

  std::size_t dimension() const noexcept { return dimension_; }

  /// An upper bound of the distance of the nearest point of the box, and little more than it. This and what
  /// follows needs a live `RoundingUpward`.
  double distance(const MapPoint& center, const Box& box) const noexcept;

  /// A lower bound of it.
  double distance_at_least(const MapPoint& center, const Box& box) const noexcept;

  /// The farthest that a point of the box is from its middle.
  double half_extent(const Box& box) const noexcept;

  /// How large a shape about `center` may be without leaving the box: upper and lower bounds.
  double room(const MapPoint& center, const Box& box) const noexcept;
  double room_at_least(const MapPoint& center, const Box& box) const noexcept;

  /// Extent of the shape of size 1 along coordinate i, from its center.
  double reach(std::size_t i) const noexcept { return 1.0 / scale_[i]; }

 private:
  template <class Scalar>
  Scalar norm(const std::array<Scalar, max_map_dimension>& displacement) const noexcept;

  std::size_t dimension_;
  std::array<double, max_map_dimension> scale_{};
  std::array<std::size_t, max_map_dimension> group_{};
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_GAUGE_H
