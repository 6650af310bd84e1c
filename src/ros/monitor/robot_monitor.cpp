// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/robot_monitor.h"

#include "ros/messages/configurations.h"
#include "ros/messages/hazard_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

Pose start_pose(const Manipulator& manipulator, const std::vector<double>& coordinates) {
  const Eigen::Map<const Eigen::VectorXd> values(coordinates.data(),
                                                 static_cast<Eigen::Index>(coordinates.size()));
  return pose_from_coordinates(manipulator.task_space(), values).value_or(Pose{});
}

constexpr double speed_window = 0.2;  // over which approach is looked at [s]
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

DistanceBounds unknown_distance() {
  DistanceBounds bounds;
  bounds.lower = bounds.upper = bounds.speed = not_a_number;
  return bounds;
}

DistanceBounds bounds_of(const BoundaryDistance& distance) {
  DistanceBounds bounds = unknown_distance();
  if (distance.status == DistanceStatus::unavailable) return bounds;
  bounds.lower = distance.lower;
  bounds.upper = distance.upper;
  return bounds;
}

// The distance is that to a set of poses, so it changes by no more than the robot moves; a little more is
// taken off for rounding.
DistanceBounds moved(DistanceBounds bounds, double by, double size) {
  const double change = by * (1.0 + 1e-9) + 1e-12 * size;
  bounds.lower = std::max(0.0, bounds.lower - change);
  bounds.upper += change;
  return bounds;
}

const char* const how_to_start = "call set_assembly_mode, or set start/pose or start/determinant_sign.";

}  // namespace

RobotMonitor::RobotMonitor(std::shared_ptr<const Mechanism> mechanism, const NodeOptions& options)
    : mechanism_(mechanism),
      reader_(mechanism),
      names_(*mechanism->manipulator()),
      start_(options.start),
      start_tolerance_(options.start.tolerance.value_or(mechanism->manipulator()->size() / 20.0)),
      timeout_(options.joint_states_timeout),
      passive_(mechanism, options.passive),
      meter_(mechanism->manipulator()),
      stand_off_(mechanism->manipulator(), options.tracking.samples),
      merger_(mechanism->manipulator(), options.tracking.samples, options.joint_states_window),
      tracker_(mechanism->manipulator(), options.tracking),
      status_(make_status(Status::NO_JOINT_STATES, "No usable joint_states have arrived yet.")),
      publishers_(ros::Duration(timeout_)),
      thresholds_(thresholds_of(options.thresholds)) {
  speeds_.fill(ApproachSpeed(speed_window));
  residual_.compared = 0;
}

MonitorUpdate RobotMonitor::update(const sensor_msgs::JointState& message, const ros::Time& now,
                                   const std::string& publisher) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (seconds_between(now, last_received_) > timeout_) forget();
  last_received_ = now;
  publishers_.count(publisher, message.header.seq);
  const JointSample sample = reader_.read(message);
  const ros::Time& stamp = message.header.stamp;
  const bool new_names = sample.status != SampleStatus::usable && names_.hear(message);
  if (sample.status == SampleStatus::foreign) return pass_over(new_names);
  std::string other;
  const Claim claim = publishers_.claim(publisher, sample.joint_values, now, other);
  if (claim == Claim::contested)
    return refuse(Status::SEVERAL_PUBLISHERS,
                  "both " + publisher + " and " + other + " publish the actuated joints; stop one of them.",
                  stamp);
  if (claim == Claim::waiting) return {};
  if (sample.status == SampleStatus::invalid)
    return refuse(Status::INVALID_JOINT_STATES, with_guess(sample.message), stamp);
  if (sample.status == SampleStatus::usable && stamp == last_stamp_ && last_q_ && sample.q == *last_q_)
    return {};  // the same again
  const std::string fault = fault_of_stamp(sample.status, stamp, now);
  if (!fault.empty()) return refuse(Status::INVALID_JOINT_STATES, fault, stamp);
  const auto merged = merger_.add(stamp, sample.joint_values, sample.q);
  if (sample.status == SampleStatus::usable) return accept(sample, {stamp, sample.q, {}}, now);
  if (merged && merged->stamp > last_stamp_) return accept(JointSample(), *merged, now);
  return wait_for_joints(sample, now);
}

// Messages that hold some of the actuated joints come on several paths, and may overtake one another.
std::string RobotMonitor::fault_of_stamp(SampleStatus status, const ros::Time& stamp,
                                         const ros::Time& now) const {
  if (stamp.isZero()) return "its stamp is zero; set header.stamp.";
  if (status != SampleStatus::partial && stamp == last_stamp_)
    return "its stamp is that of the message before, but the actuated joints are elsewhere.";
  if (status != SampleStatus::partial && stamp < last_stamp_)
    return "its stamp is " + std::to_string(seconds_between(stamp, last_stamp_)) +
           " s before that of the message before.";
  if (seconds_between(now, stamp) > timeout_)
    return "its stamp is " + std::to_string(seconds_between(now, stamp)) +
           " s ahead of this computer's clock; synchronise the clocks.";
  return {};
}

// Another robot's message; while nothing else comes, perhaps this one's with the wrong names.
MonitorUpdate RobotMonitor::pass_over(bool new_names) {
  ++counts_.foreign;
  MonitorUpdate update;
  if (!new_names || status_.code != Status::NO_JOINT_STATES) return update;
  status_ =
      make_status(Status::NO_JOINT_STATES, "No usable joint_states have arrived yet: " + names_.comparison());
  update.state = lost_state(status_, {});
  if (!std::exchange(said_names_, true)) update.warning = status_.message;
  return update;
}

std::string RobotMonitor::with_guess(const std::string& message) const {
  const std::string guess = names_.guess();
  return guess.empty() ? message : message + " Or " + guess;
}

MonitorUpdate RobotMonitor::refuse(std::uint8_t code, const std::string& message, const ros::Time& stamp) {
  ++counts_.invalid;
  MonitorUpdate update;
  update.warning = "A message of joint_states cannot be used: " + message;
  status_ = make_status(code, update.warning);
  update.state = lost_state(status_, stamp);
  return update;
}

// The others may be on their path; where they are not, the state becomes stale.
MonitorUpdate RobotMonitor::wait_for_joints(const JointSample& sample, const ros::Time& now) {
  MonitorUpdate update;
  if (!last_stamp_.isZero()) return update;
  if (waiting_since_.isZero()) waiting_since_ = now;
  status_ = make_status(
      Status::NO_JOINT_STATES,
      "A message of joint_states holds some of the actuated joints, and those of the others do not "
      "fit it: " +
          with_guess(sample.message));
  if (seconds_between(waiting_since_, now) > timeout_) update.warning = status_.message;
  update.state = unknown_state(*mechanism_->manipulator(), status_, {});
  return update;
}

MonitorUpdate RobotMonitor::accept(const JointSample& sample, const MergedJoints& joint_values,
                                   const ros::Time& now) {
  ++counts_.usable;
  names_.forget();
  const bool first = last_stamp_.isZero();
  const ros::Time& stamp = joint_values.stamp;
  if (first) epoch_ = stamp;
  const JointVector& q = joint_values.q;
  last_usable_ = now;
  last_stamp_ = stamp;
  last_q_ = q;
  last_uncertainty_ = joint_values.uncertainty;
  readings_ = sample.readings;
  const double time = seconds_between(epoch_, stamp);
  const Status start = first ? start_as_configured(time, q) : Status();
  if (!first || start.code != Status::OK) tracker_.update(time, q, joint_values.uncertainty);
  const bool uninitialised = tracker_.state().status == TrackStatus::uninitialised;
  if (tracker_.state().followed()) not_started_ = {};
  if (first && uninitialised && start.code != Status::OK)
    status_ = not_started_ = start;
  else
    status_ = uninitialised && not_started_.code != Status::OK ? not_started_ : status_of_tracker();

  MonitorUpdate update;
  if (!sample.message.empty()) update.warning = "In joint_states, " + sample.message;
  if (first && failed_start()) update.warning = start.message;
  fill_tracked(stamp, update);
  said_stale_ = stale(now);
  if (said_stale_) {
    update.tracked.reset();
    update.state = lost_state(stale_status(now), stamp);
    return update;
  }
  update.state->status = status_;
  if (status_.code == Status::OK) update.state->status.message = update.warning;
  return update;
}

void RobotMonitor::keep_transitions() {
  for (const Transition& transition : tracker_.take_transitions())
    transitions_.push_back(
        transition_message(*mechanism_->manipulator(), transition, epoch_ + ros::Duration(transition.time)));
}

void RobotMonitor::fill_tracked(const ros::Time& stamp, MonitorUpdate& update) {
  const Manipulator& manipulator = *mechanism_->manipulator();
  const TrackedState& tracked = tracker_.state();
  keep_transitions();
  update.transitions = std::exchange(transitions_, {});
  if (tracked.status != TrackStatus::tracking) {
    update.state = lost_state(status_, stamp);
    if (tracked.status == TrackStatus::inconsistent) update.state->residual = tracked.residual;
    return;
  }
  update.state = state_message(manipulator, tracked, stamp);
  judge(tracked, *update.state);
  update.tracked = tracked;
}

AspectState RobotMonitor::lost_state(const Status& status, const ros::Time& stamp) {
  findings_.threshold = thresholds_.lose();
  memory_.lose();
  AspectState state = unknown_state(*mechanism_->manipulator(), status, stamp);
  state.last_hazard = hazard_message(memory_.told(), epoch_);
  state.reason = reason_of(memory_.told());
  return state;
}

// Distances to boundaries of another working mode say nothing here, but for that to serial singularities,
// which are the same poses in every mode.
void RobotMonitor::judge(const TrackedState& tracked, AspectState& state) {
  const Manipulator& manipulator = *mechanism_->manipulator();
  findings_.distances.fill(unknown_distance());
  DistanceThresholds::Distances lower;
  HazardMemory::Speeds speeds;
  if (measured_) {
    const double by = anchor_distance(manipulator, measured_->pose, tracked.pose) + tracked.spread;
    const bool same = measured_->mode == tracked.mode;
    for (std::size_t i = 0; i < hazard_count; ++i) {
      if (!same && i != static_cast<std::size_t>(Hazard::serial_singularity)) continue;
      findings_.distances[i] = moved(measured_->bounds[i], by, manipulator.size());
    }
  }
  for (std::size_t i = 0; i < hazard_count; ++i) {
    lower[i] = findings_.distances[i].lower;
    speeds[i] = findings_.distances[i].speed;
  }
  findings_.threshold = thresholds_.update(lower);
  memory_.see(thresholds_, speeds, tracked.time);
  findings_.stand_off = measured_ && measured_->mode == tracked.mode ? measured_->stand_off : not_a_number;
  findings_.residual = residual_.compared > 0 ? residual_.excess : not_a_number;
  state.parallel_distance = findings_.distances[0];
  state.stand_off = findings_.stand_off;
  state.serial_distance = findings_.distances[1];
  state.limit_distance = findings_.distances[2];
  state.level = level_message(findings_.threshold.level);
  state.reason = reason_of(findings_.threshold);
  state.last_hazard = hazard_message(memory_.told(), epoch_);
  state.residual = findings_.residual;
}

std::optional<AssemblyCandidates> RobotMonitor::work() {
  TrackedState tracked;
  JointVector bend;
  Eigen::VectorXd readings;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (last_stamp_.isZero()) return std::nullopt;
    tracked = tracker_.state();
    bend = tracker_.bend();
    readings = readings_;
  }
  if (tracked.followed())
    measure(tracked, bend, readings);
  else
    look_for_assembly_mode(readings);
  return new_candidates();
}

// Without the lock while it measures.
void RobotMonitor::measure(const TrackedState& tracked, const JointVector& bend,
                           const Eigen::VectorXd& readings) {
  const BoundaryDistances found = meter_.measure(tracked.pose, tracked.mode);
  const PassiveResidual residual = passive_.residual(tracked.pose, tracked.q, readings);
  const double limit =
      tracked.status == TrackStatus::inconsistent ? 1.0 - passive_.options().hysteresis : 1.0;
  Measured measured{tracked.pose,
                    tracked.mode,
                    {bounds_of(found.parallel), bounds_of(found.serial), bounds_of(found.actuated_limit)},
                    not_a_number};
  if (std::isfinite(found.parallel.upper))
    measured.stand_off = stand_off_.along_path(tracked.pose, found.parallel.witness, tracked.mode, bend);
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t i = 0; i < hazard_count; ++i) {
    DistanceBounds& bounds = measured.bounds[i];
    if (measured_ && !(measured_->mode == measured.mode)) speeds_[i].forget();
    speeds_[i].add(tracked.time, std::isfinite(bounds.upper) ? bounds.upper : bounds.lower);
    if (speeds_[i].known()) bounds.speed = speeds_[i].speed();
  }
  measured_ = measured;
  residual_ = residual;
  if (tracker_.state().followed() && residual.compared > 0)
    tracker_.report_residual(residual.excess, residual.excess > limit);
}

void RobotMonitor::look_for_assembly_mode(const Eigen::VectorXd& readings) {
  const std::lock_guard<std::mutex> lock(mutex_);
  measured_.reset();
  for (ApproachSpeed& speed : speeds_) speed.forget();
  if (tracker_.state().followed()) return;
  if (tracker_.wants_candidates()) tracker_.find_candidates();
  if (!tracker_.state().followed()) passive_.apply(readings, tracker_);
  keep_transitions();
}

std::optional<AssemblyCandidates> RobotMonitor::new_candidates() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool followed = tracker_.state().followed();
  const auto& list = tracker_.candidates();
  const std::size_t count = followed ? 0 : list.size();
  if (count == reported_candidates_) return std::nullopt;
  reported_candidates_ = count;
  const Manipulator& manipulator = *mechanism_->manipulator();
  AssemblyCandidates message;
  message.header.stamp = last_stamp_;
  message.header.frame_id = manipulator.base_frame();
  message.complete = followed || list.complete();
  for (std::size_t i = 0; i < count; ++i)
    message.candidates.push_back(
        solved_message(manipulator, {list[i].pose, list[i].q}, nullptr, last_stamp_));
  message.message = followed
                        ? "The assembly mode is known."
                        : std::to_string(count) + (list.complete() ? "" : " or more") +
                              " assembly modes are possible: " + reason(tracker_.state().ambiguity) + ".";
  return message;
}

std::optional<sensor_msgs::JointState> RobotMonitor::complete(const TrackedState& tracked,
                                                              const ros::Time& stamp) const {
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism_->joint_names().size()));
  if (!mechanism_->complete(tracked.pose, tracked.q, positions)) return std::nullopt;
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  message.name = mechanism_->joint_names();
  message.position.assign(positions.data(), positions.data() + positions.size());
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
    const Pose pose = start_pose(manipulator, *start_.pose);
    if (tracker_.start(time, q, pose, start_tolerance_, last_uncertainty_)) return {};
    return make_status(Status::NOT_STARTED,
                       "The first joint sample does not assemble within " + std::to_string(start_tolerance_) +
                           " m of start/pose. " + why_not_at(manipulator, pose, q) + merged_joints() +
                           " Correct start/pose or the actuated joints, or " + how_to_start);
  }
  if (start_.determinant_sign) {
    if (tracker_.start(time, q, *start_.determinant_sign, last_uncertainty_)) return {};
    return make_status(
        Status::NOT_STARTED,
        std::string("The first joint sample does not have exactly one assembly mode with the sign "
                    "start/determinant_sign of det A; ") +
            how_to_start);
  }
  return make_status(Status::NOT_STARTED, std::string("The assembly mode is not known; ") + how_to_start);
}

// Whether it was said where the robot is at first, did not fit, and nothing was known since.
bool RobotMonitor::failed_start() const {
  return (start_.pose || start_.determinant_sign) && not_started_.code != Status::OK;
}

Status RobotMonitor::status_of_tracker() const {
  switch (tracker_.state().status) {
    case TrackStatus::tracking:
      return {};
    case TrackStatus::ambiguous:
      return make_status(Status::AMBIGUOUS, std::string("The assembly mode is not known: ") +
                                                reason(tracker_.state().ambiguity) +
                                                "; call set_assembly_mode." + merged_joints() +
                                                (failed_start() ? " " + not_started_.message : ""));
    case TrackStatus::inconsistent:
      return make_status(Status::INCONSISTENT, contradiction());
    case TrackStatus::uninitialised:
      break;
  }
  return make_status(Status::NOT_STARTED, std::string("The assembly mode is not known; ") + how_to_start);
}

std::string RobotMonitor::merged_joints() const {
  if (last_uncertainty_.size() == 0 || !(last_uncertainty_.maxCoeff() > 0.0)) return {};
  return " The actuated joints come in several messages, so that one may have moved by " +
         std::to_string(last_uncertainty_.maxCoeff()) +
         " rad or m since its value was measured, and that leaves more than one possibility; publish all of "
         "them "
         "in one message, or more often.";
}

std::string RobotMonitor::contradiction() const {
  if (residual_.compared == 0) return "Measured passive joints contradict the pose.";
  return "Joint " + mechanism_->joint_names()[residual_.joint] + " is measured " +
         std::to_string(residual_.difference) +
         " rad or m off the value that belongs to the pose; check the encoders, and the dimensions in the "
         "URDF.";
}

bool RobotMonitor::stale(const ros::Time& now) const {
  return !last_stamp_.isZero() &&
         (seconds_between(last_usable_, now) > timeout_ || seconds_between(last_stamp_, now) > timeout_);
}

Status RobotMonitor::stale_status(const ros::Time& now) const {
  const std::string age = std::to_string(timeout_) + " s";
  if (seconds_between(last_usable_, now) <= timeout_)
    return make_status(Status::STALE,
                       "joint_states arrive, but their stamps are more than " + age +
                           " behind this computer's clock; synchronise the clocks, or play bags "
                           "with --clock and use_sim_time.");
  const std::string since = names_.lacks_an_actuated_joint() ? ": since then " + names_.comparison() : ".";
  return make_status(Status::STALE, "The last usable joint_states are older than " + age + since);
}

std::optional<AspectState> RobotMonitor::expire(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!stale(now) || said_stale_) return std::nullopt;
  said_stale_ = true;
  return lost_state(stale_status(now), last_stamp_);
}

CurrentConfiguration RobotMonitor::current(const ros::Time& now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  CurrentConfiguration current;
  const bool refused =
      status_.code == Status::INVALID_JOINT_STATES || status_.code == Status::SEVERAL_PUBLISHERS;
  current.status = stale(now) && !refused ? stale_status(now) : status_;
  current.stamp = last_stamp_;
  current.tracked = tracker_.state();
  current.solved = {current.tracked.pose, current.tracked.q};
  return current;
}

MonitorFindings RobotMonitor::findings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return findings_;
}

void RobotMonitor::set_thresholds(const DistanceThresholds::Options& thresholds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  thresholds_.set_options(thresholds);
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
                       "No present joint values are known; publish joint_states first.");
  if (tracker_.start(seconds_between(epoch_, last_stamp_), *last_q_, pose, start_tolerance_,
                     last_uncertainty_)) {
    keep_transitions();
    return status_ = {};
  }
  status_ = status_of_tracker();
  return make_status(Status::NO_SOLUTION, "The present actuated joints do not assemble within " +
                                              std::to_string(start_tolerance_) + " m of that pose." +
                                              merged_joints());
}

Status RobotMonitor::start_with_sign(int determinant_sign, const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!last_q_ || stale(now))
    return make_status(Status::NO_JOINT_STATES,
                       "No present joint values are known; publish joint_states first.");
  if (tracker_.start(seconds_between(epoch_, last_stamp_), *last_q_, determinant_sign, last_uncertainty_)) {
    keep_transitions();
    return status_ = {};
  }
  status_ = status_of_tracker();
  return make_status(
      Status::NO_SOLUTION,
      "The present actuated joints do not have exactly one assembly mode with that sign of det A.");
}

// A simulation that begins anew starts as configured; a clock that was set back says nothing of the robot.
void RobotMonitor::forget() {
  clock_went_back_ = !ros::Time::isSimTime();
  publishers_.forget_claims();
  tracker_.stop();
  memory_.forget();
  merger_.forget();
  measured_.reset();
  not_started_ = {};
  last_stamp_ = last_usable_ = waiting_since_ = ros::Time();
  last_q_.reset();
  status_ =
      make_status(Status::NO_JOINT_STATES, "Time went backwards; no usable joint_states have arrived since.");
}

}  // namespace parallel_aspects
