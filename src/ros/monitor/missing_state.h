// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_MISSING_STATE_H
#define PARALLEL_ASPECTS_ROS_MONITOR_MISSING_STATE_H

#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "ros/joint_states/joint_name_watch.h"
#include "ros/messages/conversions.h"

#include <ros/time.h>

#include <string>

namespace parallel_aspects {

/// What is wrong with the stamp of a message that comes at `now`, or empty. `last`: stamp of the one before,
/// zero where messages may overtake one another.
std::string fault_of_stamp(const ros::Time& stamp, const ros::Time& last, const ros::Time& now,
                           double timeout);

/// That messages hold some of the actuated joints, and make no configuration yet. `missing`: what is.
std::string some_joints(const std::string& missing);

/// That it is not known where tracking starts: `why`, if there is more to say, and what to do. `read_only`:
/// whether the node refuses set_assembly_mode.
Status not_started_status(const std::string& why, bool read_only);

/// Why these actuated joints do not start near a pose, which is called `place`. `uncertainty`: of merged
/// actuated joints.
std::string why_not_near(const Manipulator& manipulator, const JointVector& q, const Pose& pose,
                         double tolerance, const std::string& place, const JointVector& uncertainty);

/// Why they do not start with a sign of det A.
std::string why_not_with_sign(const Manipulator& manipulator, const JointVector& q, int determinant_sign,
                              const JointVector& uncertainty);

/// That the robot is in more than one assembly mode, as far as is known. `start`: why it could not start as
/// configured; empty where it did, or nothing is configured.
Status ambiguous_status(Ambiguity ambiguity, const JointVector& uncertainty, const std::string& start,
                        bool read_only);

/// That measured passive joints contradict the pose.
Status inconsistent_status(const Mechanism& mechanism, const PassiveResidual& residual);

/// That nothing usable came for `timeout` [s], and which joints came since.
Status silent_status(double timeout, const JointNameWatch& names);

/// That some of the actuated joints do not come any more. `overdue`: which, and for how long.
/// `names`: what came since the last usable sample.
Status overdue_status(const std::string& overdue, const JointNameWatch& names);

/// That nothing did while the clock stood still.
Status halted_status(double timeout);

/// That the process itself stood still for so long [s].
Status paused_status(double pause);

/// That what comes is older than that.
Status late_status(double timeout);

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

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_MISSING_STATE_H
