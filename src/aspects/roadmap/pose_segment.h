// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SEGMENT_H
#define PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SEGMENT_H

#include "interval/path_form.h"
#include "interval/rotation_rows.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/model/pose.h"

#include <array>

namespace parallel_aspects {

/// Enclosures of the poses of a segment (see `pose_between`). A quaternion stands for its direction, so it
/// need not be of unit length to the last digit.
class PoseSegment {
 public:
  /// Position [m] and rows of the rotation matrix.
  struct Placement {
    Spatial<PathForm> position;
    RotationRows<PathForm> rotation;
  };

  /// Both poses must be finite, and their quaternions about unit length. Needs a live `RoundingUpward`.
  PoseSegment(const Pose& from, const Pose& to) noexcept;

  /// Encloses the poses of a part of the segment; false, and nothing, where the part is too long for it.
  /// Needs a live `RoundingUpward`.
  bool place(const PathForm& t, Placement& placement) const noexcept;

 private:
  Spatial<Interval> position_, travel_;
  std::array<Interval, 4> quaternion_, quaternion_change_;  // x, y, z, w
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ROADMAP_POSE_SEGMENT_H
