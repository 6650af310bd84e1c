// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/tracker_core.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int max_root_steps = 4;
constexpr int max_steps_to_resume = 4096;

int sign_of(double value) { return (value > 0.0) - (value < 0.0); }

int sign_of(const Interval& value) { return value.positive() ? 1 : value.negative() ? -1 : 0; }

// The working mode, where the sign of every B_jj is proved.
bool proved_mode(const CertifiedPoint& point, WorkingMode& mode) {
  mode = WorkingMode(static_cast<std::size_t>(point.q.size()));
  for (std::size_t j = 0; j < mode.leg_count(); ++j) {
    const int sign = sign_of(point.inverse_diagonal[j]);
    if (sign == 0) return false;
    mode.set_sign(j, sign);
  }
  return true;
}

double time_between(double start, double end, double share) {
  return share >= 1.0 ? end : start + (end - start) * share;
}

Ambiguity ambiguity_of(SampleGap gap) {
  switch (gap) {
    case SampleGap::none:
      return Ambiguity::none;
    case SampleGap::step:
      return Ambiguity::gap;
    case SampleGap::silence:
      return Ambiguity::silence;
    case SampleGap::pause:
      return Ambiguity::pause;
    case SampleGap::half_turn:
      break;
  }
  return Ambiguity::half_turn;
}

}  // namespace

TrackerCore::TrackerCore(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options)
    : manipulator_(std::move(manipulator)),
      options_(options),
      noise_(encoder_noise(*manipulator_, options.samples)),
      certifier_(*manipulator_) {}

void TrackerCore::set_map(std::shared_ptr<const AspectMap> map) noexcept {
  map_ = std::move(map);
  state_.aspect = last_aspect_ = reported_aspect_ = 0;
  if (state_.followed()) identify_aspect();
  transitions_ = {};  // the robot is where it was: that its aspect has a number now is none
}

bool TrackerCore::start(double time, const JointVector& q, const Pose& pose, double tolerance,
                        const JointVector& uncertainty) {
  if (q.size() != static_cast<Eigen::Index>(manipulator_->leg_count()) || !q.allFinite()) return false;
  if (!pose.position.allFinite() || !pose.orientation.coeffs().allFinite()) return false;
  Candidate found;
  const JointVector joint_values = options_.samples.unwrap ? unwrapped(*manipulator_, {}, q) : q;
  if (!certify_solution(certifier_, pose, joint_values, found.point)) return false;
  if (!(anchor_distance(*manipulator_, found.point.pose, pose) <= tolerance)) return false;
  const JointVector room = uncertainty.size() == q.size() ? uncertainty : JointVector::Zero(q.size());
  const RoundingUpward upward;
  if (std::isinf(certifier_.anchor_spread(found.point, room))) return false;
  found.determinant_sign = certifier_.determinant_sign(found.point);
  WorkingMode mode;
  const bool known = found.determinant_sign != 0 && proved_mode(found.point, mode);
  if (!known && state_.followed()) return false;
  clear();  // from here on nothing is refused
  uncertainty_ = room;
  candidates_.set(found);
  state_.time = time;
  state_.q = joint_values;
  return settle();
}

bool TrackerCore::start(double time, const JointVector& q, int determinant_sign,
                        const JointVector& uncertainty) {
  const DirectResult result = direct(*manipulator_, q);
  const AssemblyMode* chosen = nullptr;
  for (const AssemblyMode& mode : result.solutions) {
    if (mode.near_singular) return false;
    if (sign_of(mode.determinant) != determinant_sign) continue;
    if (chosen != nullptr) return false;
    chosen = &mode;
  }
  return result.status == DirectStatus::solved && chosen != nullptr &&
         start(time, q, chosen->pose, manipulator_->size() * 1e-6, uncertainty);
}

bool TrackerCore::find_candidates() {
  if (!wants_candidates()) return state_.followed();
  if (resume()) return true;
  const bool first = state_.status == TrackStatus::uninitialised;
  candidates_.find(*manipulator_, certifier_, state_.q);
  if (!uncertainty_.isZero(0.0)) candidates_.mark_incomplete();
  if (candidates_.complete() && candidates_.size() == 0)
    become_ambiguous(Ambiguity::no_direct_solution);
  else if (first || state_.ambiguity == Ambiguity::no_direct_solution)
    become_ambiguous(Ambiguity::several_assembly_modes);
  return settle();
}

// What the actuated joints can have done since it was lost either keeps to the direct solution or does not:
// more samples make that no smaller, so that it is tried once. The straight path then leads to the pose.
bool TrackerCore::resume() noexcept {
  const bool kept = reach_.keeps_to(certifier_, point_);
  reach_.forget();
  if (!kept) return false;
  Continuation path(certifier_, point_, state_.q);
  if (Continuation(path).run(max_steps_to_resume) != ContinuationStatus::finished) return false;
  Transition transition = from_here(TransitionKind::found, state_.time);
  transition.ambiguity = state_.ambiguity;
  transition.determinant_sign_before = 0;
  transition.aspect_after = state_.aspect = aspect_here();
  add(transition);
  state_.status = TrackStatus::tracking;
  state_.ambiguity = Ambiguity::none;
  candidates_.clear();
  advance(path, state_.time, state_.time, max_steps_to_resume);
  state_.pose = point_.pose;
  state_.spread = spread();
  identify_aspect();
  return true;
}

bool TrackerCore::wants_candidates() const noexcept {
  const bool known = candidates_.complete() && candidates_.size() > 0;
  return state_.q.size() > 0 && !state_.followed() && !known;
}

// Starts in the only candidate that is left. That it is the only one says something only where the list of
// direct solutions was complete.
bool TrackerCore::settle() noexcept {
  if (state_.followed() || !candidates_.complete() || candidates_.size() != 1) return false;
  const Candidate only = candidates_[0];
  if (!only.followed || only.determinant_sign == 0) return false;
  if (begin_at(state_.time, only.point, only.determinant_sign)) return true;
  become_ambiguous(Ambiguity::serial_singularity);
  return false;
}

bool TrackerCore::settle_kept() noexcept {
  if (state_.followed() || state_.status == TrackStatus::uninitialised) return state_.followed();
  if (candidates_.size() > 0) return settle();
  candidates_.clear();
  become_ambiguous(Ambiguity::no_candidate_fits);
  return false;
}

bool TrackerCore::begin_at(double time, const CertifiedPoint& point, int determinant_sign) noexcept {
  WorkingMode mode;
  if (!proved_mode(point, mode)) return false;
  point_ = point;
  state_ = {TrackStatus::tracking, time, point.q,         point.pose, mode,
            determinant_sign,      0,    Ambiguity::none, 0.0,        0.0};
  state_.spread = spread();
  entry_sines_ = certifier_.entry_sines(point);
  zero_times_.fill(time);
  candidates_.clear();
  reach_.forget();
  set_reference();
  identify_aspect();
  return true;
}

void TrackerCore::stop() noexcept {
  clear();
  intervals_.forget();
  last_aspect_ = reported_aspect_ = last_determinant_sign_ = 0;
}

void TrackerCore::clear() noexcept {
  state_.status = TrackStatus::uninitialised;
  state_.ambiguity = Ambiguity::none;
  state_.aspect = 0;
  state_.q.resize(0);
  bend_.forget();
  reach_.forget();
  candidates_.clear();
  transitions_ = {};
}

const TrackedState& TrackerCore::update(double time, const JointVector& q,
                                        const JointVector& uncertainty) noexcept {
  transitions_ = {};
  if (q.size() != static_cast<Eigen::Index>(manipulator_->leg_count()) || !q.allFinite() ||
      !std::isfinite(time))
    return state_;
  const JointVector joint_values = options_.samples.unwrap ? unwrapped(*manipulator_, state_.q, q) : q;
  const bool first = state_.q.size() == 0;
  const JointVector last_uncertainty = first ? JointVector::Zero(q.size()) : uncertainty_;
  uncertainty_ = uncertainty.size() == q.size() ? uncertainty : JointVector::Zero(q.size());
  const double seconds = time - state_.time;
  const SampleGap gap = first ? SampleGap::none
                              : gap_between(*manipulator_, options_.samples, intervals_, state_.q,
                                            joint_values, seconds, last_uncertainty + uncertainty_);
  if (!first) intervals_.add(seconds);
  const JointVector step = first ? JointVector::Zero(q.size()) : JointVector(joint_values - state_.q);
  const JointVector bend =
      bend_.next(options_.samples, step, noise_) + last_uncertainty.cwiseMax(uncertainty_);
  const bool followed = state_.followed();
  if (followed && gap != SampleGap::none)
    lose(time, ambiguity_of(gap));
  else if (followed)
    follow(time, joint_values, bend);
  else
    follow_candidates(joint_values, bend, gap);
  if (!first && !state_.followed())
    reach_.add(*manipulator_, options_.samples,
               {state_.q, joint_values, seconds, gap, bend, last_uncertainty.cwiseMax(uncertainty_)});
  state_.time = time;
  state_.q = joint_values;
  state_.spread = spread();
  if (state_.followed() && state_.aspect == 0) identify_aspect();
  if (!followed) settle();
  return state_;
}

void TrackerCore::follow(double time, const JointVector& q, const JointVector& bend) noexcept {
  Continuation path(certifier_, point_, q, bend);
  const double start = state_.time;
  advance(path, start, time, options_.max_steps);
  if (path.status() == ContinuationStatus::finished) return watch_assembly(time);
  lose(time_between(start, time, path.share()), path.status() == ContinuationStatus::unfinished
                                                    ? Ambiguity::step_budget
                                                    : Ambiguity::near_parallel_singularity);
}

// The path takes from one time to another.
void TrackerCore::advance(Continuation& path, double start, double end, int max_steps) noexcept {
  for (int i = 0; i < max_steps && path.status() == ContinuationStatus::unfinished; ++i) {
    const double before = path.share();
    if (path.advance() == ContinuationStatus::too_near_singular) break;
    watch_legs(point_, path.at(), time_between(start, end, before), time_between(start, end, path.share()));
    point_ = path.at();
  }
  state_.pose = point_.pose;
}

void TrackerCore::follow_candidates(const JointVector& q, const JointVector& bend, SampleGap gap) noexcept {
  if (gap != SampleGap::none && state_.status == TrackStatus::ambiguous) {
    candidates_.clear();
    become_ambiguous(ambiguity_of(gap));
  }
  candidates_.follow(certifier_, q, bend, options_.max_steps);
}

void TrackerCore::watch_legs(const CertifiedPoint& from, const CertifiedPoint& to, double start,
                             double end) noexcept {
  const TaskVector sines = certifier_.entry_sines(to);
  state_.pose = to.pose;
  for (std::size_t leg = 0; leg < manipulator_->leg_count(); ++leg) {
    const auto i = static_cast<Eigen::Index>(leg);
    if (sign_of(entry_sines_[i]) != sign_of(sines[i]))
      zero_times_[leg] = zero_time(from, to, leg, start, end);
  }
  entry_sines_ = sines;
  for (int leg = next_crossing(); leg >= 0; leg = next_crossing()) {
    const auto crossed = static_cast<std::size_t>(leg);
    cross(crossed, zero_times_[crossed]);
  }
}

// B_jj changes its sign many times where noise meets a serial singularity; a change counts past a hysteresis.
// The leg that is past the hysteresis on the other side, the first by the time of its zero; -1 for none.
int TrackerCore::next_crossing() const noexcept {
  int first = -1;
  for (Eigen::Index i = 0; i < entry_sines_.size(); ++i) {
    const auto leg = static_cast<std::size_t>(i);
    if (!(entry_sines_[i] * state_.mode.sign(leg) < 0.0)) continue;
    if (!(std::abs(entry_sines_[i]) >= options_.hysteresis)) continue;
    if (first < 0 || zero_times_[leg] < zero_times_[static_cast<std::size_t>(first)])
      first = static_cast<int>(i);
  }
  return first;
}

// Regula falsi between two ends of a certified step, in its Illinois form.
double TrackerCore::zero_time(const CertifiedPoint& from, const CertifiedPoint& to, std::size_t leg,
                              double start, double end) const noexcept {
  const auto i = static_cast<Eigen::Index>(leg);
  const RoundingUpward upward;
  double low = 0.0, high = 1.0;
  double at_low = certifier_.entry_sines(from)[i], at_high = certifier_.entry_sines(to)[i];
  double share = at_low / (at_low - at_high);
  CertifiedPoint between = to;
  for (int k = 0; k < max_root_steps && std::isfinite(share); ++k) {
    between.q = from.q + share * (to.q - from.q);
    if (!certifier_.evaluate(between)) break;
    const double here = certifier_.entry_sines(between)[i];
    if (sign_of(here) == sign_of(at_low)) {
      low = share;
      at_low = here;
      at_high *= 0.5;
    } else {
      high = share;
      at_high = here;
      at_low *= 0.5;
    }
    share = low + (high - low) * at_low / (at_low - at_high);
  }
  return std::isfinite(share) ? start + (end - start) * share : end;
}

void TrackerCore::cross(std::size_t leg, double time) noexcept {
  Transition transition = from_here(TransitionKind::working_mode, time);
  state_.mode.set_sign(leg, -state_.mode.sign(leg));
  state_.aspect = aspect_here();
  mode_changed_ = true;
  transition.leg = leg;
  transition.mode_after = state_.mode;
  transition.aspect_after = state_.aspect;
  add(transition);
}

void TrackerCore::watch_assembly(double time) noexcept {
  WorkingMode before;
  const bool known = proved_mode(assembly_.reference(), before);
  if (assembly_.watch(*manipulator_, certifier_, point_) != AssemblyComparison::other) return;
  Transition transition = from_here(TransitionKind::assembly_mode, time);
  if (known) transition.mode_before = before;
  transition.inside_aspect = !mode_changed_;
  transition.first_again = assembly_.is_at_first(*manipulator_);
  mode_changed_ = false;
  add(transition);
}

double TrackerCore::spread() const noexcept {
  if (!state_.followed() || uncertainty_.isZero(0.0)) return 0.0;
  const RoundingUpward upward;
  return certifier_.anchor_spread(point_, uncertainty_);
}

void TrackerCore::set_reference() noexcept {
  if (!state_.followed()) return;
  assembly_.set_reference(point_);
  mode_changed_ = false;
}

AssemblyComparison TrackerCore::compare_with_reference(int max_steps) const noexcept {
  if (!state_.followed()) return AssemblyComparison::unknown;
  return assembly_.compare(*manipulator_, certifier_, point_, max_steps);
}

void TrackerCore::report_residual(double residual, bool contradicts) noexcept {
  state_.residual = residual;
  if (state_.followed()) state_.status = contradicts ? TrackStatus::inconsistent : TrackStatus::tracking;
}

void TrackerCore::lose(double time, Ambiguity why) noexcept {
  Transition transition = from_here(TransitionKind::lost, time);
  transition.ambiguity = why;
  transition.determinant = why == Ambiguity::near_parallel_singularity;
  transition.determinant_sign_after = 0;
  transition.aspect_after = 0;
  candidates_.clear();
  // Where measured passive joints contradict the pose, it is none to go on from.
  if (state_.status == TrackStatus::tracking) reach_.begin();
  become_ambiguous(why);
  add(transition);
}

void TrackerCore::become_ambiguous(Ambiguity why) noexcept {
  state_.status = TrackStatus::ambiguous;
  state_.ambiguity = why;
  state_.aspect = 0;
}

int TrackerCore::aspect_here() const noexcept {
  if (!map_) return 0;
  const Location location = map_->locate(state_.pose, state_.mode);
  return location.status == LocationStatus::inside ? location.aspect : 0;
}

void TrackerCore::identify_aspect() noexcept {
  const int aspect = aspect_here();
  if (aspect == 0) return;
  state_.aspect = aspect;
  if (reported_aspect_ == aspect) return;
  Transition transition = from_here(TransitionKind::aspect, state_.time);
  // The same as before a time when it was unknown: from unknown to it.
  transition.aspect_before = last_aspect_ == aspect ? 0 : last_aspect_;
  transition.determinant_sign_before = last_determinant_sign_;
  transition.determinant = last_determinant_sign_ * state_.determinant_sign < 0;
  add(transition);
}

Transition TrackerCore::from_here(TransitionKind kind, double time) const noexcept {
  Transition transition;
  transition.kind = kind;
  transition.time = time;
  transition.mode_before = transition.mode_after = state_.mode;
  transition.determinant_sign_before = transition.determinant_sign_after = state_.determinant_sign;
  transition.aspect_before = transition.aspect_after = state_.aspect;
  return transition;
}

Transitions TrackerCore::take_transitions() noexcept { return std::exchange(transitions_, {}); }

void TrackerCore::add(const Transition& transition) noexcept {
  reported_aspect_ = transition.aspect_after;
  if (transition.aspect_after != 0) last_aspect_ = transition.aspect_after;
  if (transition.determinant_sign_after != 0) last_determinant_sign_ = transition.determinant_sign_after;
  if (transitions_.count == Transitions::most) {
    transitions_.dropped = true;
    return;
  }
  transitions_.items[transitions_.count++] = transition;
}

}  // namespace parallel_aspects
