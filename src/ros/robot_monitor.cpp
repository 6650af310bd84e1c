// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ros/robot_monitor.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

Pose start_pose(const Manipulator& manipulator, const std::vector<double>& coordinates) {
  const Eigen::Map<const Eigen::VectorXd> values(coordinates.data(),
                                                 static_cast<Eigen::Index>(coordinates.size()));
  return pose_from_coordinates(manipulator.task_space(), values).value_or(Pose{});
}

// From one time to another [s]. A ros::Duration would throw for stamps that are absurd enough.
double seconds_between(const ros::Time& from, const ros::Time& to) {
  return static_cast<double>(to.sec) - static_cast<double>(from.sec) +
         1e-9 * (static_cast<double>(to.nsec) - static_cast<double>(from.nsec));
}

const char* const how_to_start = "call set_assembly_mode, or set start/pose or start/determinant_sign.";

}  // namespace

RobotMonitor::RobotMonitor(std::shared_ptr<const Mechanism> mechanism, const StartOptions& start,
                           double timeout)
    : mechanism_(mechanism),
      reader_(mechanism),
      start_(start),
      start_tolerance_(start.tolerance.value_or(mechanism->manipulator()->size() / 20.0)),
      timeout_(timeout),
      tracker_(mechanism->manipulator()),
      status_(make_status(Status::NO_JOINT_STATES, "No usable joint_states have arrived yet.")),
      publishers_(ros::Duration(timeout_)) {}

MonitorUpdate RobotMonitor::update(const sensor_msgs::JointState& message, const ros::Time& now,
                                   const std::string& publisher) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (seconds_between(now, last_received_) > timeout_) forget();
  last_received_ = now;
  publishers_.count(publisher, message.header.seq);
  const JointSample sample = reader_.read(message);
  const ros::Time& stamp = message.header.stamp;
  if (sample.status == SampleStatus::foreign) {
    ++counts_.foreign;
    return {};
  }
  const std::string other = publishers_.claim(publisher, now);
  if (!other.empty())
    return refuse(Status::SEVERAL_PUBLISHERS,
                  "both " + publisher + " and " + other + " publish the drives; stop one of them.", stamp);
  if (sample.status == SampleStatus::invalid)
    return refuse(Status::INVALID_JOINT_STATES, sample.sentence, stamp);
  const std::string fault = fault_of_stamp(stamp, now);
  if (!fault.empty()) return refuse(Status::INVALID_JOINT_STATES, fault, stamp);
  return accept(sample, stamp, now);
}

std::string RobotMonitor::fault_of_stamp(const ros::Time& stamp, const ros::Time& now) const {
  if (stamp.isZero()) return "its stamp is zero; set header.stamp.";
  if (stamp == last_stamp_) return "its stamp is that of the message before.";
  if (stamp < last_stamp_)
    return "its stamp is " + std::to_string(seconds_between(stamp, last_stamp_)) +
           " s before that of the message before.";
  if (seconds_between(now, stamp) > timeout_)
    return "its stamp is " + std::to_string(seconds_between(now, stamp)) +
           " s ahead of this computer's clock; synchronise the clocks.";
  return {};
}

MonitorUpdate RobotMonitor::refuse(std::uint8_t code, const std::string& sentence, const ros::Time& stamp) {
  ++counts_.invalid;
  MonitorUpdate update;
  update.warning = "A message of joint_states cannot be used: " + sentence;
  status_ = make_status(code, update.warning);
  update.state = unknown_state(*mechanism_->manipulator(), status_, stamp);
  return update;
}

// A change by more than half a turn is an encoder that wraps where it is close to whole turns; otherwise the
// drive moved as far as it says.
void RobotMonitor::unwrap(JointVector& q) const {
  if (!last_q_) return;
  for (std::size_t j = 0; j < mechanism_->manipulator()->leg_count(); ++j) {
    if (!mechanism_->manipulator()->leg(j).driven_by_angle()) continue;
    double& value = q[static_cast<Eigen::Index>(j)];
    const double change = value - (*last_q_)[static_cast<Eigen::Index>(j)];
    const double rest = std::remainder(change, 2.0 * EIGEN_PI);
    if (std::abs(change) > EIGEN_PI && std::abs(rest) <= 0.25 * EIGEN_PI) value += rest - change;
  }
}

MonitorUpdate RobotMonitor::accept(const JointSample& sample, const ros::Time& stamp, const ros::Time& now) {
  ++counts_.usable;
  const bool first = last_stamp_.isZero();
  if (first) epoch_ = stamp;
  JointVector q = sample.q;
  unwrap(q);
  last_usable_ = now;
  last_stamp_ = stamp;
  last_q_ = q;
  const double time = seconds_between(epoch_, stamp);
  const Status start = first ? start_as_configured(time, q) : Status();
  if (!first && tracker_.state().status != TrackStatus::unstarted) tracker_.update(time, q);
  if (first || status_.code != Status::NOT_STARTED)
    status_ = start.code == Status::OK ? status_of_tracker() : start;

  MonitorUpdate update;
  if (!sample.sentence.empty()) update.warning = "In joint_states, " + sample.sentence;
  fill_tracked(stamp, update);
  said_stale_ = stale(now);
  if (said_stale_) {
    update.tracked.reset();
    update.state = unknown_state(*mechanism_->manipulator(), stale_status(), stamp);
    return update;
  }
  update.state->status = status_;
  if (status_.code == Status::OK) update.state->status.sentence = update.warning;
  return update;
}

void RobotMonitor::keep_transitions() {
  for (const Transition& transition : tracker_.transitions())
    transitions_.push_back(
        transition_message(*mechanism_->manipulator(), transition, epoch_ + ros::Duration(transition.time)));
}

void RobotMonitor::fill_tracked(const ros::Time& stamp, MonitorUpdate& update) {
  const Manipulator& manipulator = *mechanism_->manipulator();
  const TrackedState& tracked = tracker_.state();
  keep_transitions();
  update.transitions = std::exchange(transitions_, {});
  if (tracked.status != TrackStatus::tracking) {
    update.state = unknown_state(manipulator, status_, stamp);
    return;
  }
  update.state = state_message(manipulator, tracked, stamp);
  update.tracked = tracked;
}

std::optional<sensor_msgs::JointState> RobotMonitor::complete(const TrackedState& tracked,
                                                              const ros::Time& stamp) const {
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism_->joint_names().size()));
  if (!mechanism_->complete(tracked.pose, tracked.q, positions)) return std::nullopt;
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  message.name = mechanism_->joint_names();
  message.position.assign(positions.begin(), positions.end());
  return message;
}

// Only the first sample may start: a later one could lie near the start pose in another assembly mode.
Status RobotMonitor::start_as_configured(double time, const JointVector& q) {
  const Manipulator& manipulator = *mechanism_->manipulator();
  if (clock_went_back_)
    return make_status(Status::NOT_STARTED,
                       "The clock went backwards, so how the robot moved meanwhile is not known; call "
                       "set_assembly_mode.");
  if (start_.pose) {
    if (tracker_.start(time, q, start_pose(manipulator, *start_.pose), start_tolerance_)) return {};
    return make_status(Status::NOT_STARTED, "The first joint sample does not assemble within " +
                                                std::to_string(start_tolerance_) + " m of start/pose; " +
                                                how_to_start);
  }
  if (start_.determinant_sign) {
    if (tracker_.start(time, q, *start_.determinant_sign)) return {};
    return make_status(
        Status::NOT_STARTED,
        std::string("The first joint sample does not have exactly one assembly mode with the sign "
                    "start/determinant_sign of det A; ") +
            how_to_start);
  }
  return make_status(Status::NOT_STARTED, std::string("The assembly mode is not known; ") + how_to_start);
}

Status RobotMonitor::status_of_tracker() const {
  switch (tracker_.state().status) {
    case TrackStatus::tracking:
      return {};
    case TrackStatus::ambiguous:
      return make_status(Status::AMBIGUOUS, std::string("The assembly mode is not known: ") +
                                                reason(tracker_.state().doubt) + "; call set_assembly_mode.");
    case TrackStatus::inconsistent:
      return make_status(Status::AMBIGUOUS, "Measured passive joints contradict the pose.");
    case TrackStatus::unstarted:
      break;
  }
  return make_status(Status::NOT_STARTED, std::string("The assembly mode is not known; ") + how_to_start);
}

bool RobotMonitor::stale(const ros::Time& now) const {
  return !last_stamp_.isZero() &&
         (seconds_between(last_usable_, now) > timeout_ || seconds_between(last_stamp_, now) > timeout_);
}

Status RobotMonitor::stale_status() const {
  return make_status(Status::STALE,
                     "The last usable joint_states are older than " + std::to_string(timeout_) + " s.");
}

std::optional<AspectState> RobotMonitor::expire(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!stale(now) || said_stale_) return std::nullopt;
  said_stale_ = true;
  return unknown_state(*mechanism_->manipulator(), stale_status(), last_stamp_);
}

CurrentConfiguration RobotMonitor::current(const ros::Time& now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  CurrentConfiguration current;
  const bool refused =
      status_.code == Status::INVALID_JOINT_STATES || status_.code == Status::SEVERAL_PUBLISHERS;
  current.status = stale(now) && !refused ? stale_status() : status_;
  current.stamp = last_stamp_;
  current.tracked = tracker_.state();
  current.solved = {current.tracked.pose, current.tracked.q};
  return current;
}

MonitorCounts RobotMonitor::counts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  MonitorCounts counts = counts_;
  counts.lost = publishers_.lost();
  counts.counted = publishers_.counted();
  return counts;
}

void RobotMonitor::set_map(std::shared_ptr<const AspectMap> map) {
  const std::lock_guard<std::mutex> lock(mutex_);
  tracker_.set_map(std::move(map));
}

Status RobotMonitor::start_near(const Pose& pose, const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!last_q_ || stale(now))
    return make_status(Status::NO_JOINT_STATES,
                       "No present drive values are known; publish joint_states first.");
  if (tracker_.start(seconds_between(epoch_, last_stamp_), *last_q_, pose, start_tolerance_)) {
    keep_transitions();
    return status_ = {};
  }
  status_ = status_of_tracker();
  return make_status(Status::NO_SOLUTION, "The present drives do not assemble within " +
                                              std::to_string(start_tolerance_) + " m of that pose.");
}

Status RobotMonitor::start_with_sign(int determinant_sign, const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!last_q_ || stale(now))
    return make_status(Status::NO_JOINT_STATES,
                       "No present drive values are known; publish joint_states first.");
  if (tracker_.start(seconds_between(epoch_, last_stamp_), *last_q_, determinant_sign)) {
    keep_transitions();
    return status_ = {};
  }
  status_ = status_of_tracker();
  return make_status(Status::NO_SOLUTION,
                     "The present drives do not have exactly one assembly mode with that sign of det A.");
}

// A simulation that begins anew starts as configured; a clock that was set back says nothing of the robot.
void RobotMonitor::forget() {
  clock_went_back_ = !ros::Time::isSimTime();
  publishers_.forget_claims();
  tracker_.stop();
  last_stamp_ = last_usable_ = ros::Time();
  last_q_.reset();
  status_ =
      make_status(Status::NO_JOINT_STATES, "Time went backwards; no usable joint_states have arrived since.");
}

}  // namespace parallel_aspects
