// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_HELD_JOINT_H
#define PARALLEL_ASPECTS_ASPECTS_HELD_JOINT_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>

namespace parallel_aspects {

/// A pose counts as one of a slice with a joint held if the rod of its leg has its length to within this [m].
inline constexpr double held_joint_tolerance = 1e-6;

/// Where the anchor of a leg of SE2 moves while the actuated joint of the leg is held: on a circle in the
/// plane, about the proximal point.
struct AnchorCircle {
  Eigen::Vector2d center;  ///< c(q), in the task frame [m]
  double radius = 0.0;     ///< length of the rod, seen in the plane [m]
  Eigen::Vector2d anchor;  ///< in the platform frame [m]

  /// From the center to the anchor.
  Eigen::Vector2d rod(const Pose& pose) const noexcept;

  /// Of the anchor from the circle [m]; negative inside.
  double distance(const Pose& pose) const noexcept;

  /// With the rod in this direction, and the platform at this angle [rad].
  Pose pose(double direction, double phi) const noexcept;

  /// The pose of the circle with the rod in the same direction and the platform at the same angle.
  Pose nearest(const Pose& pose) const noexcept;
};

/// The leg whose actuated joint has this name.
std::optional<std::size_t> leg_of_joint(const Manipulator& manipulator, const std::string& joint);

/// Of the leg whose joint is held.
AnchorCircle circle_of_anchor(const Manipulator& manipulator, const HeldJoint& joint) noexcept;

/// Why a map can not hold the joint there; empty where it can.
std::string find_held_joint_problem(const Manipulator& manipulator, const HeldJoint& joint);

/// Why the joint of a leg of SE2 or SO3 can not be held there; empty where it can. `holder` begins the
/// message.
std::string find_held_value_problem(const Manipulator& manipulator, const HeldJoint& joint,
                                    const std::string& holder = "The slice");

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_HELD_JOINT_H
