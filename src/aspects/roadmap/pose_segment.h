// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SEGMENT_H
#define PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SEGMENT_H

#include "interval/nonsingular.h"
#include "interval/path_form.h"
#include "interval/rotation_rows.h"
#include "legs/determinant.h"
#include "legs/hinges.h"
#include "legs/link_points.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Enclosures of the poses of a segment (see `pose_between`). A quaternion stands for its direction, so it
/// need not be of unit length to the last digit; in R2 poses stand for their angles.
class PoseSegment {
 public:
  /// Position [m] and rows of the rotation matrix.
  using Placement = HingePlacement<PathForm>;

  /// Both poses must be finite, and their quaternions about unit length. Needs a live `RoundingUpward`.
  PoseSegment(const Motions& motions, const Pose& from, const Pose& to) noexcept;

  /// Encloses the poses of a part of the segment; false, and nothing, where the part is too long for it.
  /// Needs a live `RoundingUpward`.
  bool place(const PathForm& t, Placement& placement) const noexcept;

 private:
  bool place_by_hinges(const PathForm& t, Placement& placement) const noexcept;

  Motions motions_;
  std::array<Interval, 2> angles_, turns_;  // of R2, at the start and from there to the end [rad]
  Spatial<Interval> position_, travel_;
  std::array<Interval, 4> quaternion_, quaternion_change_;  // x, y, z, w
};

/// The legs on a part of a segment of poses, in one working mode, as `MarginTests` asks for them. All of it
/// is referred to.
template <std::size_t D>
struct MarginLegs {
  const std::vector<SpatialLeg>& legs;
  const SquareArray<PathForm>& rows;                             ///< of A, longer by `scale`
  const std::array<Spatial<PathForm>, max_legs>& displacements;  ///< of the anchors from the base points
  const std::array<Spatial<PathForm>, max_legs>& rods;           ///< u, longer by `scale`
  const RotationRows<PathForm>& rotation;                        ///< of the platform

  const std::array<PathForm, max_legs>& row(std::size_t j, int) const { return rows[j]; }
  PathForm scale(std::size_t j) const { return legs[j].scale(displacements[j]); }

  PathForm squared_rod(std::size_t j) const {
    PathForm sum = square(rods[j][0]);
    for (std::size_t i = 1; i < D; ++i) sum = sum + square(rods[j][i]);
    return sum;
  }

  Point<PathForm, D> turned(const Point<Interval, D>& direction) const {
    Point<PathForm, D> result;
    for (std::size_t i = 0; i < D; ++i) {
      result[i] = direction[0] * rotation[i][0];
      for (std::size_t k = 1; k < D; ++k) result[i] = result[i] + direction[k] * rotation[i][k];
    }
    return result;
  }

  PathForm determinant() const {
    switch (legs.size()) {
      case 1:
        return determinant_of_first<1>();
      case 2:
        return determinant_of_first<2>();
      case 3:
        return determinant_of_first<3>();
      default:
        return determinant_of_first<max_legs>();
    }
  }

 private:
  template <std::size_t N>
  PathForm determinant_of_first() const {
    std::array<Row<PathForm, N>, N> matrix;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = 0; k < N; ++k) matrix[i][k] = rows[i][k];
    return determinant_of(matrix);
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SEGMENT_H
