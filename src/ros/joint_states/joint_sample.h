// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_SAMPLE_H
#define PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_SAMPLE_H

#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "ros/joint_states/publisher_watch.h"

#include <memory>
#include <sensor_msgs/JointState.h>
#include <string>
#include <vector>

namespace parallel_aspects {

enum class SampleStatus {
  usable,   ///< `q` is filled; `message` may name a joint that was ignored
  partial,  ///< holds some of the actuated joints, the others are not a number; `message` says which are
            ///< missing
  foreign,  ///< holds none of the actuated joints, so it is another robot's, or of passive joints alone
  invalid,  ///< cannot be used; `message` says why
};

struct JointSample {
  SampleStatus status = SampleStatus::invalid;
  std::string message;
  JointSet named_joints;     ///< which ones the message names
  JointVector q;             ///< in the order of the legs [rad or m]
  Eigen::VectorXd readings;  ///< of every joint, as `joint_readings`; only where usable
};

/// What a message says of every joint of the URDF, in the order of `Mechanism::joint_names()`: not a number
/// where it says nothing or nothing finite [rad or m].
Eigen::VectorXd joint_readings(const Mechanism& mechanism, const sensor_msgs::JointState& message);

/// Finds the actuated joints of one robot in joint_states, in whatever order they come.
class JointSampleReader {
 public:
  explicit JointSampleReader(std::shared_ptr<const Mechanism> mechanism);

  JointSample read(const sensor_msgs::JointState& message) const;

 private:
  JointSample read(const sensor_msgs::JointState& message, const JointSet& named_joints) const;

  std::shared_ptr<const Mechanism> mechanism_;
};

/// The values of exactly these actuated joints, as a service request names them.
JointSample actuated_values(const Manipulator& manipulator, const std::vector<std::string>& names,
                            const std::vector<double>& positions);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_SAMPLE_H
