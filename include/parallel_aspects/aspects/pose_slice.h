// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_POSE_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_POSE_SLICE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace parallel_aspects {

/// A two-dimensional slice through the poses of a task space, for drawing:
///  - SE2: x, y [m] at one phi [rad];
///  - T3: x, y [m] at one z [m];
///  - SO3: the tilt (theta cos(azimuth), theta sin(azimuth)) [rad] of the platform's z axis, within the disc
///  of
///    radius pi, at one torsion [rad] (the tilt and torsion of Bonev, Zlatanov and Gosselin, 2002);
///  - T2: x, y [m], all there is;
///  - every task space: the free coordinates of a `MapSlice` that leaves two of them.
class PoseSlice {
 public:
  /// `level`: phi, z or torsion; unused in T2. Not for SE3.
  PoseSlice(TaskSpace space, double level) noexcept : space_(space), level_(level) {}

  /// The free coordinates of `slice`, which are two.
  PoseSlice(const Manipulator& manipulator, const MapSlice& slice);

  /// The slice that holds a pose.
  static PoseSlice through(TaskSpace space, const Pose& pose) noexcept;

  /// phi or torsion [rad], or z [m].
  double level() const noexcept { return level_; }

  /// The pose at this point of the slice [m or rad].
  Pose pose(const Eigen::Vector2d& point) const noexcept;

  /// Where in its own slice a pose lies.
  static Eigen::Vector2d point(TaskSpace space, const Pose& pose) noexcept;

  /// Whether the slice reaches this far: angles to half a turn, SO3 over its disc, else everywhere.
  bool holds(const Eigen::Vector2d& point) const noexcept;

  /// The joint that is held, where one is.
  std::optional<HeldJoint> held_joint() const noexcept { return slice_ ? slice_->joint : std::nullopt; }

  /// "phi = 0.3 rad", for people; empty in T2.
  std::string text() const;

 private:
  bool turns(std::size_t coordinate) const noexcept;

  TaskSpace space_;
  double level_ = 0.0;
  std::optional<MapSlice> slice_{};
  std::optional<AnchorCircle> circle_{};  // where a joint is held
};

/// What slices of the map can show: bounds in the coordinates of `PoseSlice` [m or rad], of all aspects.
Eigen::AlignedBox2d slice_bounds(const AspectMap& map);

/// The same of the free coordinates of `slice`, which are two, through a map that has them.
Eigen::AlignedBox2d slice_bounds(const AspectMap& map, const MapSlice& slice);

/// How far apart two slices are, the short way round where the level is an angle [m or rad].
double level_difference(TaskSpace space, double a, double b) noexcept;

/// A slice of SO3 or SE3 in which the platform turns by phi from the orientation that is held, about an axis
/// through its operational point: x, y or z of the task frame, or own-x, own-y or own-z of the platform.
/// Roll, pitch and yaw are all held, and up to two positions may be free; else as `make_slice`.
MapSlice make_rotation_slice(TaskSpace space, const std::vector<HeldCoordinate>& held,
                             const std::string& axis, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_POSE_SLICE_H
