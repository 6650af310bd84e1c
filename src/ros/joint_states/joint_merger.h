// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_MERGER_H
#define PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_MERGER_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"
#include "ros/joint_states/publisher_watch.h"

#include <ros/time.h>

#include <array>
#include <memory>
#include <optional>

namespace parallel_aspects {

/// From one time to another [s]. A ros::Duration would throw for stamps that are absurd enough.
double seconds_between(const ros::Time& from, const ros::Time& to) noexcept;

/// Values of all actuated joints at one time.
struct MergedJoints {
  ros::Time stamp;
  JointVector q;            ///< in the order of the legs [rad or m]
  JointVector uncertainty;  ///< how far each actuated joint may be from there [rad or m]
};

/// Makes configurations of messages that hold some of the actuated joints each. Values with different stamps
/// are not one configuration. So all joints are interpolated, on a straight path, to the latest time that two
/// samples of every joint bracket. An actuated joint may be off that path by as much as
/// between two samples (by `path_bend` times an eighth of the larger of the last two differences of its
/// steps), and by no more than lies within its velocity limit of both values.
class JointMerger {
 public:
  /// `window`: two values that are farther apart are not joined [s].
  JointMerger(std::shared_ptr<const Manipulator> manipulator, const SampleOptions& options, double window);

  /// A message with these actuated joints; other entries of `q` are not read. A configuration that is newer
  /// than the one before, where that makes one. Values that are not newer than those before change nothing.
  std::optional<MergedJoints> add(const ros::Time& stamp, const JointSet& named_joints, const JointVector& q);

  void forget() noexcept;

 private:
  struct Value {
    ros::Time stamp;
    double position = 0.0;  // with whole turns added [rad or m]
  };
  /// The last values of one actuated joint, the newest first.
  struct History {
    std::array<Value, 16> values;
    std::size_t count = 0;
    void push(const Value& value) noexcept;
    double bend(std::size_t newer) const noexcept;
  };

  void remember(const ros::Time& stamp, const JointSet& named_joints, const JointVector& q);
  bool bracketed(MergedJoints& merged) const;
  bool interpolate(const History& history, double fastest, const ros::Time& stamp, double& position,
                   double& uncertainty) const;
  double fastest(std::size_t leg) const;

  std::shared_ptr<const Manipulator> manipulator_;
  SampleOptions options_;
  double window_;
  std::array<History, max_legs> histories_;
  ros::Time last_;  // of the last configuration; zero for none
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_JOINT_STATES_JOINT_MERGER_H
