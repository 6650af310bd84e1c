// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/sample_age.h"

#include "ros/joint_states/joint_merger.h"
#include "ros/monitor/state_messages.h"

namespace parallel_aspects {

void SampleAge::take(const ros::Time& stamp, const ros::Time& now) {
  stamp_ = stamp;
  came_ = now;
  fresh_ = true;
  halted_ = false;
}

void SampleAge::beat(const ros::SteadyTime& wall) {
  const double pause = beaten_.isZero() ? 0.0 : (wall - beaten_).toSec();
  beaten_ = wall;
  if (!(pause > timeout_)) return;
  resumed_ = wall;
  paused_ = pause;
}

void SampleAge::look(const ros::SteadyTime& wall) {
  beat(wall);
  if (fresh_) looked_ = wall;
  fresh_ = false;
  halted_ = (wall - looked_).toSec() > timeout_;
}

void SampleAge::forget() noexcept { stamp_ = came_ = ros::Time(); }

double SampleAge::silence(const ros::Time& now) const { return seconds_between(came_, now); }

bool SampleAge::too_old(const ros::Time& now) const {
  return !stamp_.isZero() && (halted_ || silence(now) > timeout_ || seconds_between(stamp_, now) > timeout_);
}

// What came while this process stood still waited for it, so that says nothing of the clocks of others.
Status SampleAge::status(const ros::Time& now, const JointNameWatch& names) const {
  const bool just_resumed = !resumed_.isZero() && (beaten_ - resumed_).toSec() <= timeout_;
  if (just_resumed) return paused_status(paused_);
  const bool arrive = silence(now) <= timeout_;
  if (arrive && seconds_between(stamp_, came_) > timeout_) return late_status(timeout_);
  if (arrive && seconds_between(stamp_, now) <= timeout_) return halted_status(timeout_);
  return silent_status(timeout_, names);
}

}  // namespace parallel_aspects
