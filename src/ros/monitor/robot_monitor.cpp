// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/robot_monitor.h"

#include "model/message_text.h"
#include "ros/messages/hazard_messages.h"
#include "ros/monitor/missing_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

std::string both(const std::string& one, const std::string& other) {
  return "both " + std::min(one, other) + " and " + std::max(one, other) +
         " publish the actuated joints; stop one of them.";
}

}  // namespace

RobotMonitor::RobotMonitor(std::shared_ptr<const Mechanism> mechanism, const NodeOptions& options,
                           const std::string& topic)
    : mechanism_(mechanism),
      reader_(mechanism),
      names_(*mechanism),
      start_(options.start),
      start_tolerance_(tolerance_of(options.start, *mechanism->manipulator())),
      read_only_(options.read_only),
      passive_(mechanism, options.passive),
      meter_(mechanism->manipulator()),
      stand_off_(mechanism->manipulator(), options.tracking.samples),
      domains_(mechanism->manipulator(), options.uniqueness.hold),
      merger_(mechanism->manipulator(), options.tracking.samples, options.joint_states_window),
      tracker_(mechanism->manipulator(), options.tracking),
      status_(make_status(Status::NO_JOINT_STATES,
                          "Nothing has arrived on " + topic + " yet; " + names_.expectation() + ".")),
      age_(options.joint_states_timeout),
      publishers_(ros::Duration(options.joint_states_timeout)),
      hazards_(mechanism->manipulator(),
               thresholds_of(options.thresholds, DistanceUnit(*mechanism->manipulator()))) {
  if (options.guard.enabled) guard_.emplace(mechanism->manipulator(), options);
}

MonitorUpdate RobotMonitor::update(const sensor_msgs::JointState& message, const ros::Time& now,
                                   const std::string& publisher) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (seconds_between(now, last_received_) > age_.timeout()) forget();
  last_received_ = now;
  publishers_.count(publisher, message.header.seq);
  const JointSample sample = reader_.read(message);
  const ros::Time& stamp = message.header.stamp;
  // So long that names may be what is wrong; before that they would be work at the rate of other robots.
  const bool nothing_lately = age_.silence(now) > age_.timeout() / 2.0;
  const bool new_names = sample.status != SampleStatus::usable && nothing_lately && names_.hear(message);
  if (sample.status == SampleStatus::foreign) return pass_over(new_names);
  std::string other;
  const Claim claim = publishers_.claim(publisher, sample.named_joints, now, other);
  if (claim == Claim::contested)
    return refuse(Status::SEVERAL_PUBLISHERS, both(publisher, other), stamp, now);
  if (claim == Claim::waiting && status_.code == Status::SEVERAL_PUBLISHERS) last_refused_ = now;
  // Nothing is reported while the other publisher may have ended; by a clock that stands still it never has.
  if (claim == Claim::waiting && !age_.halted()) return {};
  const bool again = sample.status == SampleStatus::usable && stamp == age_.stamp();
  if (again && last_q_ && sample.q == *last_q_) return {};
  const std::string fault = fault_of(sample, stamp, now);
  if (!fault.empty()) return refuse(Status::INVALID_JOINT_STATES, fault, stamp, now);
  return claim == Claim::sole ? take(sample, stamp, now) : MonitorUpdate();
}

// Messages that hold some of the actuated joints come on several paths, and may overtake one another.
std::string RobotMonitor::fault_of(const JointSample& sample, const ros::Time& stamp,
                                   const ros::Time& now) const {
  if (sample.status == SampleStatus::invalid) return sample.message;
  const ros::Time before = sample.status == SampleStatus::partial ? ros::Time() : age_.stamp();
  return fault_of_stamp(stamp, before, now, age_.timeout());
}

// All of the actuated joints, or some, which make a configuration with what came before.
MonitorUpdate RobotMonitor::take(const JointSample& sample, const ros::Time& stamp, const ros::Time& now) {
  for (std::size_t j = 0; j < sample.named_joints.size(); ++j)
    if (sample.named_joints[j]) came_[j] = now;
  const auto merged = merger_.add(stamp, sample.named_joints, sample.q);
  if (sample.status == SampleStatus::usable) return accept(sample, {stamp, sample.q, {}}, now);
  if (merged && merged->stamp > age_.stamp()) return accept(JointSample(), *merged, now);
  return wait_for_joints(sample, now);
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

MonitorUpdate RobotMonitor::refuse(std::uint8_t code, const std::string& message, const ros::Time& stamp,
                                   const ros::Time& now) {
  ++counts_.invalid;
  last_refused_ = now;
  said_stale_ = false;
  MonitorUpdate update;
  update.warning = "A message of joint_states cannot be used: " + message;
  status_ = make_status(code, update.warning);
  update.state = lost_state(status_, stamp);
  return update;
}

// The others may be on their path; where they are not, the state becomes stale.
MonitorUpdate RobotMonitor::wait_for_joints(const JointSample& sample, const ros::Time& now) {
  MonitorUpdate update;
  if (!age_.stamp().isZero()) return update;
  if (waiting_since_.isZero()) waiting_since_ = now;
  status_ = make_status(Status::NO_JOINT_STATES, some_joints(names_.with_guess(sample.message)));
  if (seconds_between(waiting_since_, now) > age_.timeout()) update.warning = status_.message;
  update.state = unknown_state(*mechanism_->manipulator(), status_, {});
  return update;
}

MonitorUpdate RobotMonitor::accept(const JointSample& sample, const MergedJoints& merged,
                                   const ros::Time& now) {
  ++counts_.usable;
  names_.forget();
  const bool first = age_.stamp().isZero();
  const ros::Time& stamp = merged.stamp;
  age_.take(stamp, now);
  last_q_ = merged.q;
  last_uncertainty_ = merged.uncertainty;
  readings_ = sample.readings;
  const Status start = follow(merged, first);

  MonitorUpdate update;
  if (!sample.message.empty()) update.warning = "In joint_states, " + sample.message;
  if (first && failed_start()) update.warning = start.message;
  fill_tracked(stamp, update);
  said_stale_ = age_.too_old(now);
  if (said_stale_) {
    update.tracked.reset();
    update.state = lost_state(age_.status(now, names_), stamp);
    return update;
  }
  update.state->status = status_;
  if (status_.code == Status::OK)
    update.state->status.message = update.warning.empty()
                                       ? beyond_limits(*mechanism_->manipulator(), tracker_.state().q)
                                       : update.warning;
  return update;
}

// How the start went, where it is the first configuration.
Status RobotMonitor::follow(const MergedJoints& merged, bool first) {
  if (first) epoch_ = merged.stamp;
  const double time = seconds_between(epoch_, merged.stamp);
  const Status start = first ? start_as_configured(time, merged.q) : Status();
  if (!first || start.code != Status::OK) tracker_.update(time, merged.q, merged.uncertainty);
  meanwhile_.add({time, merged.q, merged.uncertainty});
  if (tracker_.state().followed()) meanwhile_.end();
  note_start(Beginning::followed);
  if (tracker_.state().followed()) not_started_ = {};
  if (first && tracker_.state().status == TrackStatus::uninitialised) not_started_ = start;
  status_ = status_of_tracker();
  return start;
}

void RobotMonitor::keep(const Transition& transition) {
  transitions_.push_back(transition_message(*mechanism_->manipulator(), transition,
                                            epoch_ + ros::Duration(transition.time),
                                            std::exchange(stated_anew_, false)));
}

void RobotMonitor::keep_transitions() {
  for (const Transition& transition : tracker_.take_transitions()) keep(transition);
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
  hazards_.judge(tracked, residual_.compared > 0 ? residual_.excess : not_a_number, epoch_, *update.state);
  fill_domains(*update.state);
  if (guard_) update.state->guard = guard_->state();
  update.tracked = tracked;
}

AspectState RobotMonitor::lost_state(const Status& status, const ros::Time& stamp) {
  AspectState state = unknown_state(*mechanism_->manipulator(), status, stamp);
  hazards_.lose(epoch_, state);
  state.uniqueness = unknown_domains(uniqueness_.known);
  if (guard_) state.guard = guard_->state();
  return state;
}

std::optional<AssemblyCandidates> RobotMonitor::work() {
  TrackedState tracked;
  JointVector bend;
  Eigen::VectorXd readings;
  std::optional<TrackingStart> start;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (age_.stamp().isZero()) return std::nullopt;
    tracked = tracker_.state();
    bend = tracker_.bend();
    readings = readings_;
    start = tracking_start_;
  }
  if (start) look_for_domain(tracked, *start);
  if (tracked.followed())
    measure(tracked, bend, readings);
  else
    look_for_assembly_mode();
  return new_candidates();
}

// Without the lock while it measures.
void RobotMonitor::measure(const TrackedState& tracked, const JointVector& bend,
                           const Eigen::VectorXd& readings) {
  const BoundaryDistances found = meter_.measure(tracked.pose, tracked.mode);
  const PassiveResidual residual = passive_.residual(tracked.pose, tracked.q, readings);
  const double limit =
      tracked.status == TrackStatus::inconsistent ? 1.0 - passive_.options().hysteresis : 1.0;
  MeasuredHazards measured{
      tracked.pose,
      tracked.mode,
      {bounds_of(found.parallel), bounds_of(found.serial), bounds_of(found.actuated_limit)},
      not_a_number,
      {found.parallel.direction, found.serial.direction, found.actuated_limit.direction}};
  if (std::isfinite(found.parallel.upper))
    measured.stand_off = stand_off_.along_path(tracked.pose, found.parallel.witness, tracked.mode, bend);
  const std::lock_guard<std::mutex> lock(mutex_);
  hazards_.take(measured, tracked.time);
  residual_ = residual;
  if (tracker_.state().followed() && residual.compared > 0)
    tracker_.report_residual(residual.excess, residual.excess > limit);
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

// Of the merged actuated joints, where that is what keeps the assembly mode unknown: near det A = 0 it would
// be without it.
JointVector RobotMonitor::uncertainty_to_report() const {
  constexpr double near = 0.05;  // share of the robot's size
  const double distance = hazards_.findings().distances[0].upper;
  return distance <= near * mechanism_->manipulator()->size() ? JointVector() : last_uncertainty_;
}

Status RobotMonitor::status_of_tracker() const {
  switch (tracker_.state().status) {
    case TrackStatus::tracking:
      return {};
    case TrackStatus::ambiguous:
      return ambiguous_status(tracker_.state().ambiguity, uncertainty_to_report(),
                              failed_start() ? not_started_.message : "", read_only_);
    case TrackStatus::inconsistent:
      return inconsistent_status(*mechanism_, residual_);
    case TrackStatus::uninitialised:
      break;
  }
  return not_started_.code != Status::OK ? not_started_ : not_started_status("", read_only_);
}

// While messages are refused, the status says so, and not how long ago the last usable one came.
Status RobotMonitor::status_at(const ros::Time& now) const {
  const bool refused =
      status_.code == Status::INVALID_JOINT_STATES || status_.code == Status::SEVERAL_PUBLISHERS;
  if (refused && seconds_between(last_refused_, now) <= age_.timeout()) return status_;
  if (!age_.too_old(now)) return status_;
  const std::string overdue = overdue_joints(now);
  return overdue.empty() ? age_.status(now, names_) : overdue_status(overdue, names_);
}

// The actuated joints that do not come while others do; empty where all or none do.
std::string RobotMonitor::overdue_joints(const ros::Time& now) const {
  const Manipulator& manipulator = *mechanism_->manipulator();
  std::string overdue;
  bool others = false;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const double silence = seconds_between(came_[j], now);
    if (silence <= age_.timeout())
      others = true;
    else if (!came_[j].isZero())
      overdue += (overdue.empty() ? "" : ", ") + manipulator.leg(j).actuated_joint + " has not come for " +
                 number_text(silence, 2) + " s";
  }
  return others ? overdue : std::string();
}

void RobotMonitor::beat(const ros::SteadyTime& wall) {
  const std::lock_guard<std::mutex> lock(mutex_);
  age_.beat(wall);
}

std::optional<AspectState> RobotMonitor::expire(const ros::Time& now, const ros::SteadyTime& wall) {
  const std::lock_guard<std::mutex> lock(mutex_);
  age_.look(wall);
  const Status status = status_at(now);
  if (status.code != Status::STALE || std::exchange(said_stale_, true)) return std::nullopt;
  return lost_state(status, age_.stamp());
}

CurrentConfiguration RobotMonitor::current(const ros::Time& now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  CurrentConfiguration current;
  current.status = status_at(now);
  current.stamp = age_.stamp();
  current.tracked = tracker_.state();
  current.solved = {current.tracked.pose, current.tracked.q};
  return current;
}

MonitorFindings RobotMonitor::findings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return hazards_.findings();
}

void RobotMonitor::set_thresholds(const DistanceThresholds::Options& thresholds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  hazards_.set_thresholds(thresholds);
  if (guard_) guard_->set_thresholds(thresholds);
}

MonitorCounts RobotMonitor::counts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  MonitorCounts counts = counts_;
  counts.lost = publishers_.lost();
  counts.counted = publishers_.counted();
  return counts;
}

GuardedCommand RobotMonitor::guard(const geometry_msgs::TwistStamped& command, const TurnedTwist& turned,
                                   const ros::Time& now, const ros::SteadyTime& wall) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return guard_->guard(command, turned, known_to_guard(now), now, wall);
}

KnownToGuard RobotMonitor::known_to_guard(const ros::Time& now) const {
  return {tracker_.state(), hazards_.proved(), status_at(now), epoch_};
}

std::optional<GuardedCommand> RobotMonitor::expire_command(const ros::Time& now,
                                                           const ros::SteadyTime& wall) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return guard_->expire(known_to_guard(now), now, wall);
}

void RobotMonitor::set_map(std::shared_ptr<const AspectMap> map) {
  const std::lock_guard<std::mutex> lock(mutex_);
  meanwhile_.end();
  tracker_.set_map(std::move(map));
}

void RobotMonitor::set_distance_map(const std::shared_ptr<const DistanceMap>& map) { meter_.use(map); }

}  // namespace parallel_aspects
