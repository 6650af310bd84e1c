// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_POSE_H
#define PARALLEL_ASPECTS_MODEL_POSE_H

#include "parallel_aspects/model/task_space.h"
#include "parallel_aspects/model/vectors.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace parallel_aspects {

/// X of the paper: where the platform frame stands in the task frame.
///
/// The platform frame has its origin at the operational point. In a task space without rotation its axes stay
/// parallel to those of the task frame; in SO3 its origin stays at that of the task frame.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< operational point [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< unit quaternion

  /// The pose in the x-y plane: x, y [m], turned by `phi` about z [rad].
  static Pose planar(double x, double y, double phi = 0.0);

  /// A point fixed in the platform, given in the platform frame [m], seen in the task frame [m].
  Eigen::Vector3d transform(const Eigen::Vector3d& point) const { return position + orientation * point; }
};

/// Coordinates of a pose, as named by `coordinate_names(space)`.
using PoseCoordinates = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 7, 1>;

/// The coordinates of `pose` in `space`; what `space` does not move is left out.
PoseCoordinates pose_coordinates(TaskSpace space, const Pose& pose);

/// The pose with these coordinates; its quaternion is normalised.
/// Nothing when the count is wrong, a coordinate is not finite or the quaternion is zero.
std::optional<Pose> pose_from_coordinates(TaskSpace space, const PoseCoordinates& coordinates);

/// The pose reached from `pose` by the small motion `twist` = (w, v): rotation vector [rad] in the task
/// frame, then displacement of the operational point [m]; only the parts that `space` moves, so
/// `degrees_of_freedom(space)` numbers.
Pose displaced(TaskSpace space, const Pose& pose, const TaskVector& twist);

/// The pose at t (0 to 1) on the segment from one pose to another: the position runs straight, the quaternion
/// runs straight the short way and is normalised. So it is rational in t, and stays in each task space that
/// holds both ends.
Pose pose_between(const Pose& from, const Pose& to, double t) noexcept;

/// The quaternion (x, y, z, w) of `to`, on the side of that of `from`.
Eigen::Vector4d nearer_quaternion(const Pose& from, const Pose& to) noexcept;

/// "x 4.5, y 8" and so on, for messages to people.
std::string to_string(TaskSpace space, const Pose& pose);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_POSE_H
