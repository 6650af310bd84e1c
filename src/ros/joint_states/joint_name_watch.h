// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_NAME_WATCH_H
#define PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_NAME_WATCH_H

#include "parallel_aspects/urdf/mechanism.h"

#include <sensor_msgs/JointState.h>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Compares the joints that arrive with those that are actuated, while no sample can be used: wrong names are
/// the commonest reason why none can. What it keeps is bounded, whatever arrives.
class JointNameWatch {
 public:
  explicit JointNameWatch(const Mechanism& mechanism);

  /// Whether the message names a joint that was not heard of before.
  bool hear(const sensor_msgs::JointState& message);

  /// Begins anew, as after a sample that could be used.
  void forget() noexcept;

  /// Whether joints have arrived, but not all that are actuated.
  bool lacks_an_actuated_joint() const;

  /// Which joints are expected; begins "joint".
  std::string expectation() const;

  /// Which joints are expected, which have arrived, and which of these may be meant; begins "joint".
  std::string comparison() const;

  /// The message, and the guess where there is one.
  std::string with_guess(const std::string& message) const;

 private:
  /// "did you mean 'crank_1_joint' by 'crank1_joint'?" with every actuated joint that has not arrived; empty
  /// where nothing that has looks like one and is no joint of the robot.
  std::string guess() const;

  std::vector<std::string> expected_, arriving_;
  std::vector<std::string> own_;  // all joints of the robot, none of which is meant by another
  bool more_arrive_ = false;      // than there is room for
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_NAME_WATCH_H
