// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_POSE_H
#define PARALLEL_ASPECTS_MODEL_POSE_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parallel_aspects {

/// The motions that the platform can make in the task frame.
enum class TaskSpace {
  T1,   ///< translations along the x axis: x
  T2,   ///< translations in the x-y plane: x, y
  SE2,  ///< motions of the x-y plane: x, y, phi about z
  T3,   ///< translations in space: x, y, z
  SO3,  ///< rotations about the origin of the task frame
  SE3,  ///< all rigid motions
  R1,   ///< turns about the z axis, which one passive revolute joint leaves: theta
  R2,   ///< what a passive chain of two revolute joints leaves: theta1, theta2 (see `HingePair`)
};

/// The passive chain of R2. The first joint turns about the z axis of the task frame. Where its angle is 0,
/// the axis of the second joint goes through the point (offset, 0, 0) and is the z axis turned by `twist`
/// about x. The platform frame has its origin in that point of the second axis and its z along it; where both
/// angles are 0 its x axis is that of the task frame. So
///
///     X(theta1, theta2) = Rz(theta1) Tx(offset) Rx(twist) Rz(theta2)
///
/// (Denavit and Hartenberg). The axes meet where `offset` is 0.
struct HingePair {
  double offset = 0.0;  ///< along the common normal of the axes [m], of any sign
  double twist = std::numeric_limits<double>::quiet_NaN();  ///< between the axes, between 0 and pi [rad]

  /// The sine of `twist` is larger: nearer to parallel, the two angles are hardly apart from each other.
  static constexpr double least_sine = 1e-2;
};

/// A task space, and what has to be known to move in it. A task space alone will do, but for R2: there every
/// pose that is made without its chain is not a number.
struct Motions {
  TaskSpace space = TaskSpace::T2;  ///< which motions
  HingePair hinges{};               ///< of R2

  Motions() = default;  ///< T2

  /// Any task space but R2.
  Motions(TaskSpace of) noexcept : space(of) {}  // NOLINT: a task space alone says it

  /// R2.
  Motions(TaskSpace of, const HingePair& pair) noexcept : space(of), hinges(pair) {}
};

/// Number of degrees of freedom: 1, 2, 3, 3, 3, 6, 1, 2. Equals the number of legs of a fully parallel
/// manipulator.
std::size_t degrees_of_freedom(TaskSpace space) noexcept;

/// "T1", "T2", "SE2", "T3", "SO3", "SE3", "R1" or "R2".
std::string_view name(TaskSpace space) noexcept;

/// The task space of that name; nothing for any other text.
std::optional<TaskSpace> task_space_named(std::string_view text) noexcept;

/// Names of the pose coordinates, in the order of `pose_coordinates`: x, y, z [m], phi [rad], qx, qy, qz, qw,
/// theta, theta1, theta2 [rad].
const std::vector<std::string>& coordinate_names(TaskSpace space);

/// How many of the degrees of freedom are rotations; they come first in a twist and in the columns of A.
std::size_t rotational_degrees_of_freedom(TaskSpace space) noexcept;

/// Whether the platform can turn (SE2, SO3, SE3, R1, R2).
bool has_rotation(TaskSpace space) noexcept;

/// Whether positions are among the pose coordinates (all but SO3, R1, R2).
bool has_translation(TaskSpace space) noexcept;

/// Whether poses are angles of passive revolute joints (R1, R2).
bool has_hinges(TaskSpace space) noexcept;

/// Unit of a volume in the space of poses: "m", "m^2", "m^2 rad", "m^3", "rad^3", "m^3 rad^3", "rad" or
/// "rad^2".
std::string_view measure_unit(TaskSpace space) noexcept;

/// No task space has more degrees of freedom, so no fully parallel manipulator has more legs.
inline constexpr int max_legs = 6;

/// One number a leg, or one a degree of freedom of the platform. Never allocates.
using TaskVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_legs, 1>;

/// Actuated joint values q, in the order of the legs; rad for actuated revolute joints, m for prismatic ones.
using JointVector = TaskVector;

/// Square matrix over the legs and degrees of freedom. Never allocates.
using TaskMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_legs, max_legs>;

/// X of the paper: where the platform frame stands in the task frame.
///
/// The platform frame has its origin at the operational point. In a task space without rotation its axes stay
/// parallel to those of the task frame; in SO3 and R1 its origin stays at that of the task frame. In R2 it is
/// where `HingePair` says.
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
std::optional<Pose> pose_from_coordinates(const Motions& motions, const PoseCoordinates& coordinates);

/// The pose reached from `pose` by the small motion `twist` = (w, v): rotation vector [rad] in the task
/// frame, then displacement of the operational point [m]; only the parts that the task space moves, so
/// `degrees_of_freedom(space)` numbers. In R2 these are the changes of both angles [rad].
Pose displaced(const Motions& motions, const Pose& pose, const TaskVector& twist);

/// The pose at t (0 to 1) on the segment from one pose to another: the position runs straight, the quaternion
/// runs straight the short way and is normalised. So it is rational in t, and stays in each task space that
/// holds both ends, but R2.
Pose pose_between(const Pose& from, const Pose& to, double t) noexcept;

/// The same in every task space: in R2 both angles run evenly, the short way.
Pose pose_between(const Motions& motions, const Pose& from, const Pose& to, double t) noexcept;

/// The quaternion (x, y, z, w) of `to`, on the side of that of `from`.
Eigen::Vector4d nearer_quaternion(const Pose& from, const Pose& to) noexcept;

/// "x 4.5, y 8" and so on, for messages to people.
std::string to_string(TaskSpace space, const Pose& pose);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_POSE_H
