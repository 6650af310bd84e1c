// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_SAMPLE_AGE_H
#define PARALLEL_ASPECTS_ROS_MONITOR_SAMPLE_AGE_H

#include "ros/joint_states/joint_name_watch.h"
#include "ros/messages/conversions.h"

#include <ros/time.h>

namespace parallel_aspects {

/// How old the last usable sample of joint_states is, and why it is too old. Time is that of the stamps; the
/// wall clock tells a clock that stands still, and a process that did.
class SampleAge {
 public:
  /// `timeout`: from which age on a sample is too old [s].
  explicit SampleAge(double timeout) : timeout_(timeout) {}

  double timeout() const noexcept { return timeout_; }

  /// A usable sample with this stamp came at `now`.
  void take(const ros::Time& stamp, const ros::Time& now);

  /// The process runs. To be called more often than once in the timeout: a longer gap between calls is taken
  /// to mean that this process was stopped.
  void beat(const ros::SteadyTime& wall);

  /// Looks at how long none came by the wall clock. As often as `beat`, which it includes.
  void look(const ros::SteadyTime& wall);

  /// As if none had ever come: time began anew.
  void forget() noexcept;

  const ros::Time& stamp() const noexcept { return stamp_; }  ///< of the last one; zero for none
  bool halted() const noexcept { return halted_; }  ///< whether none came for the timeout, by the wall clock
  bool too_old(const ros::Time& now) const;

  /// How long ago the last one came [s].
  double silence(const ros::Time& now) const;

  /// Why it is too old, where it is. `names`: what came since.
  Status status(const ros::Time& now, const JointNameWatch& names) const;

 private:
  double timeout_;
  ros::Time stamp_, came_;  // of the last one, and when it came; zero for none
  bool fresh_ = false;      // whether one came since the last `look`
  bool halted_ = false;
  ros::SteadyTime looked_, beaten_;  // when a sample was last seen by `look`; the last beat
  ros::SteadyTime resumed_;          // when the process last went on after a pause; zero for never
  double paused_ = 0.0;              // for how long [s]
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_SAMPLE_AGE_H
