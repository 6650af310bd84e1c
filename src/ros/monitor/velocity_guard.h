// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_VELOCITY_GUARD_H
#define PARALLEL_ASPECTS_ROS_MONITOR_VELOCITY_GUARD_H

#include "parallel_aspects/motion/motion_guard.h"
#include "ros/parameters/node_options.h"

#include <parallel_aspects/GuardState.h>
#include <parallel_aspects/Status.h>

#include <Eigen/Core>
#include <ros/time.h>

#include <geometry_msgs/TwistStamped.h>
#include <memory>
#include <optional>
#include <std_msgs/Float64MultiArray.h>
#include <string>

namespace parallel_aspects {

/// A commanded twist along the axes of the base frame.
struct TurnedTwist {
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< of the reference point [m/s]
  std::string fault;                                  ///< why it is not known; empty where it is
};

/// The twist of a message whose axes `to_base` turns into those of the base frame.
TurnedTwist turned_twist(const geometry_msgs::Twist& twist, const Eigen::Matrix3d& to_base);

/// What goes out for a command.
struct GuardedCommand {
  geometry_msgs::TwistStamped twist;             ///< as the command, scaled
  std_msgs::Float64MultiArray joint_velocities;  ///< of the actuated joints
  std::string warning;                           ///< to log; empty where the command was used
};

/// What is known of the robot when a command comes.
struct KnownToGuard {
  const TrackedState& tracked;
  ProvedDistances proved;
  Status status;    ///< OK, or why nothing is known
  ros::Time epoch;  ///< what the tracker's times count from
};

/// Guards commands as messages bring them. Knows no topics and no tf. Not thread-safe.
class VelocityGuard {
 public:
  /// `options` must have passed `problems_of`.
  VelocityGuard(std::shared_ptr<const Manipulator> manipulator, const NodeOptions& options);

  GuardedCommand guard(const geometry_msgs::TwistStamped& command, const TurnedTwist& turned,
                       const KnownToGuard& known, const ros::Time& now, const ros::SteadyTime& wall);

  /// Zero, once, when the last command has become old by the wall clock.
  std::optional<GuardedCommand> expire(const KnownToGuard& known, const ros::Time& now,
                                       const ros::SteadyTime& wall);

  void set_thresholds(const DistanceThresholds::Options& thresholds) noexcept;

  /// As if no command had come: time began anew.
  void forget();

  const GuardState& state() const noexcept { return state_; }

 private:
  std::string fault_of(const geometry_msgs::TwistStamped& command, const TurnedTwist& turned,
                       const ros::Time& now) const;
  std::string fault_of_components(const Eigen::Vector3d& angular, const Eigen::Vector3d& linear) const;
  TaskVector task_twist(const TurnedTwist& turned, const Pose& pose) const;
  std::string message_of(const GuardedMotion& motion) const;
  GuardedCommand halted(const std_msgs::Header& header, double time, GuardReason reason,
                        const std::string& message);
  GuardedCommand scaled(const geometry_msgs::TwistStamped& command, const GuardedMotion& motion);
  std_msgs::Float64MultiArray array_of(const JointVector& velocities) const;

  const std::shared_ptr<const Manipulator> manipulator_;
  const double timeout_;                   // of commands [s]
  const Eigen::Vector3d reference_point_;  // in the platform frame [m]
  MotionGuard guard_;
  GuardState state_;
  ros::SteadyTime came_;  // when the last command did; zero for never, or when it was reported as old
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_VELOCITY_GUARD_H
