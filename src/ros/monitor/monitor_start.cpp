// SPDX-License-Identifier: BSD-3-Clause
//
// How the monitor learns the assembly mode, by its configuration or a statement, and forgets it.
// How the monitor follows in which uniqueness domains the robot is, from where tracking began.
#include "ask/question_parts.h"
#include "ros/joint_states/joint_merger.h"
#include "ros/messages/configurations.h"
#include "ros/messages/hazard_messages.h"
#include "ros/monitor/missing_state.h"
#include "ros/monitor/robot_monitor.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

Pose start_pose(const Manipulator& manipulator, const std::vector<double>& coordinates) {
  const Eigen::Map<const Eigen::VectorXd> values(coordinates.data(),
                                                 static_cast<Eigen::Index>(coordinates.size()));
  return pose_from_coordinates(manipulator.motions(), values).value_or(Pose{});
}

}  // namespace

// Only the first sample may start: a later one could lie near the start pose in another assembly mode.
Status RobotMonitor::start_as_configured(double time, const JointVector& q) {
  const Manipulator& manipulator = *mechanism_->manipulator();
  if (clock_went_back_)
    return not_started_status("The clock went backwards, so how the robot moved meanwhile is not known",
                              read_only_);
  std::string why;
  if (start_.pose) {
    const Pose pose = start_pose(manipulator, *start_.pose);
    if (tracker_.start_near(time, q, pose, start_tolerance_, last_uncertainty_)) return {};
    why = why_not_near(manipulator, q, pose, start_tolerance_, "start/pose", last_uncertainty_);
  } else if (start_.determinant_sign) {
    if (tracker_.start_with_sign(time, q, *start_.determinant_sign, last_uncertainty_)) return {};
    why = why_not_with_sign(manipulator, q, *start_.determinant_sign, last_uncertainty_);
  }
  return not_started_status(why, read_only_);
}

// Whether the stated start did not fit, and nothing was known since.
bool RobotMonitor::failed_start() const {
  return (start_.pose || start_.determinant_sign) && not_started_.code != Status::OK;
}

Status RobotMonitor::start_near(const Pose& pose, const ros::Time& now, const StatedSigns& stated) {
  return start_by(now, stated, [&](Tracker& tracker, double time, const JointVector& q) {
    return tracker.start_near(time, q, pose, start_tolerance_, last_uncertainty_)
               ? std::string()
               : why_not_near(*mechanism_->manipulator(), q, pose, start_tolerance_, "that pose",
                              last_uncertainty_);
  });
}

Status RobotMonitor::start_with_sign(const StatedSigns& stated, const ros::Time& now) {
  return start_by(now, stated, [&](Tracker& tracker, double time, const JointVector& q) {
    return tracker.start_with_sign(time, q, stated.determinant_sign, last_uncertainty_)
               ? std::string()
               : why_not_with_sign(*mechanism_->manipulator(), q, stated.determinant_sign, last_uncertainty_);
  });
}

// `start` says why it could not, or nothing. It starts a copy, which is dropped where it shows a
// contradiction.
template <class Start>
Status RobotMonitor::start_by(const ros::Time& now, const StatedSigns& stated, const Start& start) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!last_q_ || age_.too_old(now))
    return make_status(Status::NO_JOINT_STATES,
                       "No present joint values are known; publish joint_states first.");
  Tracker tracker = tracker_;
  const std::string why_not = start(tracker, seconds_between(epoch_, age_.stamp()), *last_q_);
  if (why_not.empty()) {
    const Manipulator& robot = *mechanism_->manipulator();
    std::vector found{ask::configuration_of(robot, tracker.state().pose, tracker.state().q)};
    const std::string why = ask::keep_stated(robot, stated.mode, stated.determinant_sign, found);
    if (!why.empty()) return make_status(Status::NO_SOLUTION, why);
  }
  meanwhile_.end();
  tracker_ = std::move(tracker);
  if (!tracker_.state().followed() || why_not.empty()) status_ = status_of_tracker();
  if (!why_not.empty()) return make_status(Status::NO_SOLUTION, why_not);
  stated_anew_ = true;
  note_start(Beginning::stated);
  keep_transitions();
  return {};
}

// A simulation that begins anew starts as configured; a clock that was set back says nothing of the robot.
void RobotMonitor::forget() {
  clock_went_back_ = !ros::Time::isSimTime();
  publishers_.forget_claims();
  meanwhile_.end();
  tracker_.stop();
  tracking_start_.reset();
  lost_start_.reset();
  hazards_.forget();
  if (guard_) guard_->forget();
  merger_.forget();
  not_started_ = {};
  age_.forget();
  last_refused_ = waiting_since_ = ros::Time();
  came_.fill({});
  last_q_.reset();
  status_ =
      make_status(Status::NO_JOINT_STATES, "Time went backwards; no usable joint_states have arrived since.");
}

void RobotMonitor::set_domains(const KnownDomains& known) {
  if (!domains_.use(known)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  uniqueness_ = unknown_domains(known.known);
}

UniquenessState RobotMonitor::uniqueness() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tracking_start_ ? uniqueness_ : unknown_domains(uniqueness_.known);
}

// Where tracking began, or the assembly mode was stated since. It begins anew after a loss, but where the
// assembly mode was found to be the same.
void RobotMonitor::note_start(Beginning how) {
  const TrackedState& tracked = tracker_.state();
  if (!tracked.followed()) {
    if (tracking_start_) lost_start_ = std::exchange(tracking_start_, std::nullopt);
    return;
  }
  if (tracking_start_ && how != Beginning::stated) return;
  const auto lost = std::exchange(lost_start_, std::nullopt);
  if (lost && how == Beginning::found) {
    tracking_start_ = lost;
    return;
  }
  tracking_start_ = TrackingStart{++tracking_starts_, tracked.pose, tracked.mode, tracked.time, epoch_};
  uniqueness_ = unknown_domains(uniqueness_.known);
}

void RobotMonitor::fill_domains(AspectState& state) const {
  state.uniqueness = uniqueness_;
  if (!uniqueness_.warns || (state.level != AspectState::CLEAR && state.level != AspectState::NO_THRESHOLD))
    return;
  state.level = level_message(level_of(hazards_.findings().threshold, uniqueness_));
  state.reason += (state.reason.empty() ? "" : "; ") + warning_of(uniqueness_);
}

// Without the lock while it looks. What was found of a start that is no longer the last is dropped.
void RobotMonitor::look_for_domain(const TrackedState& tracked, const TrackingStart& start) {
  if (!domains_.look(tracked, start)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!tracking_start_ || tracking_start_->number != start.number) return;
  uniqueness_ = domains_.state();
  if (const auto& transition = domains_.transition()) transitions_.push_back(*transition);
}

}  // namespace parallel_aspects
