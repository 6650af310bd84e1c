// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/tracker.h"

#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "parallel_aspects/tracking/continuation.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

double anchor_distance(const Manipulator& manipulator, const Pose& a, const Pose& b) {
  double sum = 0.0;
  for (const Leg& leg : manipulator.legs())
    sum += (a.transform(leg.anchor) - b.transform(leg.anchor)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(manipulator.leg_count()));
}

int sign_of(double value) { return (value > 0.0) - (value < 0.0); }

// B_jj / (|u_j| |c_j'|): sine of the angle between rod and crank, or between rod and the normal of a rail;
// for legs whose length is driven, B_jj over its largest value.
TaskVector entry_sines(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  TaskVector sines = inverse_diagonal(manipulator, pose, q);
  for (Eigen::Index j = 0; j < sines.size(); ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const double rod = (pose.transform(leg.anchor) - leg.proximal_point(q[j])).norm();
    if (const auto* elbow = std::get_if<ElbowDrive>(&leg.drive))
      sines[j] /= elbow->inner_length * elbow->outer_length;
    else if (std::holds_alternative<StrutDrive>(leg.drive))
      sines[j] /= rod;
    else
      sines[j] /= rod * leg.proximal_point_derivative(q[j]).norm();
  }
  return sines;
}

}  // namespace

const char* name(TrackStatus status) noexcept {
  switch (status) {
    case TrackStatus::unstarted:
      return "unstarted";
    case TrackStatus::tracking:
      return "tracking";
    case TrackStatus::ambiguous:
      return "ambiguous";
  }
  return "unknown";
}

const char* name(TransitionKind kind) noexcept {
  switch (kind) {
    case TransitionKind::working_mode:
      return "working mode";
    case TransitionKind::aspect:
      return "aspect";
    case TransitionKind::lost:
      return "lost";
  }
  return "unknown";
}

Tracker::Tracker(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options)
    : manipulator_(std::move(manipulator)), options_(options) {}

void Tracker::set_map(std::shared_ptr<const AspectMap> map) noexcept {
  map_ = std::move(map);
  transitions_ = {};
  state_.aspect = last_aspect_ = 0;
  if (state_.status == TrackStatus::tracking) identify_aspect();
  transitions_ = {};
}

bool Tracker::start(double time, const JointVector& q, const Pose& pose, double tolerance) {
  stop();
  if (q.size() != static_cast<Eigen::Index>(manipulator_->leg_count()) || !q.allFinite()) return false;
  if (!pose.position.allFinite() || !pose.orientation.coeffs().allFinite()) return false;
  Pose refined = pose;
  if (!refine_pose(*manipulator_, q, refined)) return false;
  return anchor_distance(*manipulator_, refined, pose) <= tolerance && begin_at(time, q, refined);
}

bool Tracker::start(double time, const JointVector& q, int determinant_sign) {
  stop();
  const DirectResult result = direct(*manipulator_, q);
  const AssemblyMode* chosen = nullptr;
  for (const AssemblyMode& mode : result.solutions) {
    if (mode.near_singular) return false;
    if (sign_of(mode.determinant) != determinant_sign) continue;
    if (chosen != nullptr) return false;
    chosen = &mode;
  }
  return result.status == DirectStatus::solved && chosen != nullptr && begin_at(time, q, chosen->pose);
}

bool Tracker::begin_at(double time, const JointVector& q, const Pose& pose) {
  const auto mode = working_mode(*manipulator_, pose, q);
  const int determinant_sign = sign_of(direct_determinant(*manipulator_, pose, q));
  if (!mode || determinant_sign == 0) return false;
  state_ = {TrackStatus::tracking, time, q, pose, *mode, determinant_sign, 0};
  entry_sines_ = entry_sines(*manipulator_, pose, q);
  path_time_ = time;
  zero_times_.fill(time);
  identify_aspect();
  return true;
}

void Tracker::stop() noexcept {
  state_.status = TrackStatus::unstarted;
  state_.aspect = 0;
  transitions_ = {};
}

const TrackedState& Tracker::update(double time, const JointVector& q) noexcept {
  transitions_ = {};
  if (q.size() != static_cast<Eigen::Index>(manipulator_->leg_count()) || !q.allFinite() ||
      !std::isfinite(time))
    return state_;
  if (state_.status == TrackStatus::tracking) {
    Continuation path(*manipulator_, state_.pose, state_.q, q);
    const double start = state_.time;
    while (!path.finished()) {
      const bool followed = path.advance();
      const double at = start + (time - start) * path.at().t;
      if (!followed) {
        lose(at);
        break;
      }
      watch_legs(at, path.at().pose, path.at().q);
    }
    state_.pose = path.at().pose;
  }
  state_.time = time;
  state_.q = q;
  if (state_.status == TrackStatus::tracking && state_.aspect == 0) identify_aspect();
  return state_;
}

void Tracker::watch_legs(double time, const Pose& pose, const JointVector& q) noexcept {
  const TaskVector sines = entry_sines(*manipulator_, pose, q);
  for (Eigen::Index i = 0; i < sines.size(); ++i) {
    const auto leg = static_cast<std::size_t>(i);
    const double before = entry_sines_[i], after = sines[i];
    if (sign_of(before) != sign_of(after))
      zero_times_[leg] = path_time_ + (time - path_time_) * before / (before - after);
  }
  entry_sines_ = sines;
  path_time_ = time;
  state_.pose = pose;
  for (std::size_t leg = 0; leg < manipulator_->leg_count(); ++leg) {
    const double sine = sines[static_cast<Eigen::Index>(leg)];
    if (sine * state_.mode.sign(leg) < 0.0 && std::abs(sine) >= options_.hysteresis)
      cross(leg, zero_times_[leg]);
  }
}

void Tracker::cross(std::size_t leg, double time) noexcept {
  Transition transition = from_here(TransitionKind::working_mode, time);
  state_.mode.set_sign(leg, -state_.mode.sign(leg));
  state_.aspect = 0;
  if (map_) {
    const Location location = map_->locate(state_.pose, state_.mode);
    if (location.status == LocationStatus::inside) state_.aspect = location.aspect;
  }
  transition.leg = leg;
  transition.mode_after = state_.mode;
  transition.aspect_after = state_.aspect;
  add(transition);
}

void Tracker::lose(double time) noexcept {
  Transition transition = from_here(TransitionKind::lost, time);
  transition.determinant = true;
  transition.determinant_sign_after = 0;
  transition.aspect_after = 0;
  state_.status = TrackStatus::ambiguous;
  state_.aspect = 0;
  add(transition);
}

void Tracker::identify_aspect() noexcept {
  if (!map_) return;
  const Location location = map_->locate(state_.pose, state_.mode);
  if (location.status != LocationStatus::inside) return;
  Transition transition = from_here(TransitionKind::aspect, state_.time);
  transition.aspect_before = last_aspect_;
  transition.determinant_sign_before = last_determinant_sign_;
  transition.determinant = last_determinant_sign_ * state_.determinant_sign < 0;
  state_.aspect = transition.aspect_after = location.aspect;
  add(transition);
}

Transition Tracker::from_here(TransitionKind kind, double time) const noexcept {
  Transition transition;
  transition.kind = kind;
  transition.time = time;
  transition.mode_before = transition.mode_after = state_.mode;
  transition.determinant_sign_before = transition.determinant_sign_after = state_.determinant_sign;
  transition.aspect_before = transition.aspect_after = state_.aspect;
  return transition;
}

void Tracker::add(const Transition& transition) noexcept {
  if (transition.aspect_after != 0) last_aspect_ = transition.aspect_after;
  if (transition.determinant_sign_after != 0) last_determinant_sign_ = transition.determinant_sign_after;
  if (transitions_.count == Transitions::most) {
    transitions_.dropped = true;
    return;
  }
  transitions_.items[transitions_.count++] = transition;
}

}  // namespace parallel_aspects
