// SPDX-License-Identifier: BSD-3-Clause
#include "motion/guard/hazard_judge.h"

#include "interval/interval.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

// Allowance for floating-point arithmetic beside the proofs; far more than its error.
constexpr double relative_rounding = 1e-9, rounding_of_size = 1e-12;

// The scale is chosen as if a command were followed for this many latencies longer than it is. The speed then
// falls with the distance so gently that a robot that answers late, by up to the latency, does not
// oscillate: v(t) = d(t) / T with d'(t) = -v(t - latency) is monotone for T >= e latency. The rest is for
// distances that come late, and for commands that are merged.
constexpr double calm = 5.0;

// The braking of a command counts so many times, so that the robot never needs all of its deceleration to
// follow the speed that the distance allows. Else one call takes all of the room, and the next ones get none
// until it stands.
constexpr double calm_braking = 2.0;

// Cosine of the angle between a command and the fastest way out, from which on it passes whole; smaller ones
// pass in part, so that the scale is continuous.
constexpr double clearly_away = 0.05;

// Parts of a command over whose reach enclosures are made at first, and the least later; then about the part
// that was last proved, so that it changes continuously and the time is short.
constexpr std::array<double, 4> first_reaches{1.0, 0.3, 0.1, 0.03};
constexpr double least_reach = 0.03;

// How far beyond the proved distance a way out is searched, as a share of it.
constexpr double nearly = 0.1;

double positive_part(double value) noexcept { return std::max(0.0, value); }

}  // namespace

HazardJudge::HazardJudge(std::shared_ptr<const Manipulator> manipulator, const GuardOptions& options)
    : manipulator_(std::move(manipulator)), options_(options), region_(make_clear_region(manipulator_)) {}

double HazardJudge::braking_time(const TaskVector& twist) const noexcept {
  const TaskSpaceTraits& space = traits(manipulator_->task_space());
  const auto turns = static_cast<Eigen::Index>(space.rotations);
  return std::max(twist.head(turns).norm() / options_.angular_deceleration,
                  twist.tail(twist.size() - turns).norm() / options_.linear_deceleration);
}

double HazardJudge::after_motion(double distance, const Pose& from, const Pose& to) const noexcept {
  return distance - anchor_distance(*manipulator_, from, to) * (1.0 + relative_rounding) - slack();
}

// For rounding of lengths beside the proofs.
double HazardJudge::slack() const noexcept { return rounding_of_size * manipulator_->size(); }

void HazardJudge::look_ahead(const TrackedState& state, const IssuedMotion& issued, const TaskVector& twist,
                             double time) noexcept {
  region_->move_to(state.pose, state.mode);
  issued.pending(state.time, time, pending_);
  prospect_.count = pending_.count;
  prospect_.spread = state.spread;
  for (std::size_t i = 0; i < pending_.count; ++i) {
    const PendingMotion& motion = pending_.list[i];
    MetricSpeed speed = region_->speed_of(motion.twist);
    speed.turn_off = motion.turn_off;
    speed.off = region_->speed_at_most(motion.turn_off, motion.slide_off);
    prospect_.before[i] = {speed, motion.seconds, motion.brake, motion.may_begin_yet};
  }
  prospect_.command = {region_->speed_of(twist), options_.period + calm * options_.latency,
                       calm_braking * braking_time(twist), true};
}

// How far earlier commands may still go, by the speed that `of` finds in each [m, or rad].
template <class Of>
double HazardJudge::pending_travel(const Of& of) const noexcept {
  double travel = 0.0, least_before = 0.0;
  for (std::size_t i = 0; i < prospect_.count; ++i) {
    const Motion& motion = prospect_.before[i];
    const SpeedRange speed = of(motion.speed);
    travel += speed.most * motion.seconds;
    // If delays differ, a faster command may begin sooner or end later than a slower one.
    if (motion.may_begin_yet)
      travel += (positive_part(speed.most - least_before) + speed.range()) * options_.latency;
    double lost = speed.range();
    if (i + 1 < prospect_.count) lost += positive_part(speed.most - of(prospect_.before[i + 1].speed).least);
    travel += 0.5 * lost * motion.brake;
    least_before = speed.least;
  }
  return travel;
}

template <class Of>
StoppingMotion HazardJudge::stopping(const Of& of) const noexcept {
  StoppingMotion motion{of(prospect_.command.speed).most, prospect_.command.seconds, prospect_.command.brake,
                        0.0, 0.0};
  if (prospect_.count == 0) return motion;
  const Motion& last = prospect_.before[prospect_.count - 1];
  motion.last = of(last.speed).most;
  motion.last_brake = last.brake;
  return motion;
}

// The largest travel of all scales up to this one; travel is convex in the scale.
template <class Of>
double HazardJudge::travel_up_to(double scale, const Of& of) const noexcept {
  const StoppingMotion motion = stopping(of);
  return (pending_travel(of) + std::max(motion.travel(0.0), motion.travel(scale))) *
         (1.0 + relative_rounding);
}

HazardJudge::SpeedRange HazardJudge::path_of(const MetricSpeed& speed) noexcept {
  return {positive_part(speed.path - speed.off), speed.path + speed.off};
}

HazardJudge::SpeedRange HazardJudge::turn_of(const MetricSpeed& speed) noexcept {
  return {positive_part(speed.turn - speed.turn_off), speed.turn + speed.turn_off};
}

// First by the proved distance alone; then by what is proved to be clear about the robot.
HazardVerdict HazardJudge::judge(Hazard hazard, double stop, double distance, const JointVector& q,
                                 const JointVector& rates) noexcept {
  HazardVerdict best;
  const double known = distance - prospect_.spread;
  best.scale = stopping(path_of).largest_scale((known - stop) - pending_travel(path_of));
  best.inside = known < stop;
  double& proved = reaches_[static_cast<std::size_t>(hazard)];
  // Where nothing was proved before, the least alone is tried.
  const double first = std::clamp(2.0 * proved, least_reach, 1.0),
               second = std::max(least_reach, 0.5 * proved);
  const std::array<double, 4> later{first, second < first ? second : 0.0, 0.0, 0.0};
  const std::array<double, 4>& reaches = proved > 0.0 ? later : first_reaches;
  const Vicinity vicinity{hazard, stop, known, q, rates};
  for (const double reach : reaches) look_about(vicinity, reach, best);
  if (best.inside)
    for (const double reach : reaches) look_for_escape(vicinity, reach, best);
  proved = std::max(0.5 * least_reach, best.scale);
  best.escape = best.escape && best.scale > 0.0;
  return best;
}

void HazardJudge::look_about(const Vicinity& vicinity, double reach, HazardVerdict& best) const noexcept {
  if (reach <= best.scale) return;
  const bool is_outside = vicinity.known >= vicinity.stop;
  const HazardVerdict verdict = judge_within(vicinity, reach, vicinity.stop, is_outside);
  const bool inside = best.inside && verdict.inside, nearer = best.nearer || verdict.nearer;
  if (verdict.scale > best.scale) best = verdict;
  best.inside = inside;
  best.nearer = nearer;
}

// Below the threshold what is clear of a smaller ball suffices, as long as the hazard is in it; or half of
// it, ahead.
void HazardJudge::look_for_escape(const Vicinity& vicinity, double reach,
                                  HazardVerdict& best) const noexcept {
  if (reach <= best.scale) return;
  const double path = travel_up_to(reach, path_of);
  const double least = positive_part(vicinity.known) * (1.0 + nearly) + path;
  if (least < vicinity.stop) {
    const HazardVerdict verdict = judge_within(vicinity, reach, least, false);
    if (verdict.escape && verdict.scale > best.scale) best = verdict;
    best.nearer = best.nearer || verdict.nearer;
  }
  if (reach <= best.scale || best.nearer || !is_ahead_clear(vicinity, least + path)) return;
  best.scale = reach;
  best.inside = best.escape = true;
}

// Whether no pose of the hazard within `radius` is ahead of the robot: then going there increases the
// distance from all of them. Earlier commands may go aside by less than is left.
bool HazardJudge::is_ahead_clear(const Vicinity& vicinity, double radius) const noexcept {
  const TaskVector& rate = prospect_.command.speed.rate;
  const TaskVector ahead = rate / rate.norm();
  const auto aside = [&](const MetricSpeed& speed) {
    const double away = (speed.rate - positive_part(speed.rate.dot(ahead)) * ahead).norm();
    return SpeedRange{positive_part(away - speed.off), away + speed.off};
  };
  const double kept = 1.0 - region_->distortion(radius);
  const double left = kept * (vicinity.known - region_->bend(travel_up_to(1.0, turn_of)));
  if (!(pending_travel(aside) + stopping(aside).travel(0.0) < left)) return false;
  return region_->is_ahead_clear(vicinity.hazard, ahead, radius * (1.0 + relative_rounding));
}

HazardVerdict HazardJudge::judge_within(const Vicinity& vicinity, double reach, double stop,
                                        bool known_outside) const noexcept {
  HazardVerdict verdict;
  verdict.inside = true;
  const double radius =
      (stop + prospect_.spread + travel_up_to(reach, path_of)) * (1.0 + relative_rounding) + slack();
  const double kept = 1.0 - region_->distortion(radius);
  if (!(kept > 0.0)) return verdict;
  const double bend = region_->bend(travel_up_to(reach, turn_of));
  const ClearHalfSpaces clear = region_->find(vicinity.hazard, radius);
  verdict.scale = reach;
  verdict.inside = false;
  for (std::size_t k = 0; k < clear.count; ++k) {
    const ClearHalfSpace& half_space = clear.list[k];
    if (vicinity.hazard == Hazard::limit && is_beyond(half_space, vicinity.q)) continue;
    const double spare =
        half_space.clearance - bend - prospect_.spread / kept - slack() - relative_rounding * radius;
    judge_half_space(half_space, spare, stop / kept, known_outside, verdict);
  }
  if (vicinity.hazard == Hazard::limit) turn_back(vicinity.q, vicinity.rates, verdict);
  return verdict;
}

// `spare`: how far the half space lets the robot go at all.
void HazardJudge::judge_half_space(const ClearHalfSpace& half_space, double spare, double stop,
                                   bool known_outside, HazardVerdict& verdict) const noexcept {
  const auto towards = [&](const MetricSpeed& speed) {
    const double along = -half_space.normal.dot(speed.rate);
    return SpeedRange{positive_part(along - speed.off), positive_part(along + speed.off)};
  };
  const double room = spare - pending_travel(towards);
  if (spare >= stop || known_outside) {
    verdict.inside = verdict.inside || spare < stop;
    verdict.scale = std::min(verdict.scale, stopping(towards).largest_scale(room - stop));
    return;
  }
  verdict.inside = verdict.escape = true;
  const TaskVector& rate = prospect_.command.speed.rate;
  const double away = half_space.normal.dot(rate) / (clearly_away * rate.norm());
  verdict.nearer = verdict.nearer || (spare > 0.0 && away < 0.0);
  const bool clears = room - stopping(towards).travel(0.0) > 0.0;
  verdict.scale = std::min(verdict.scale, clears ? positive_part(away) : 0.0);
}

bool HazardJudge::is_beyond(const ClearHalfSpace& half_space, const JointVector& q) const noexcept {
  const JointLimits& limits = manipulator_->leg(half_space.leg).limits;
  const double value = q[static_cast<Eigen::Index>(half_space.leg)];
  return half_space.end == LimitEnd::lower ? value < limits.lower : value > limits.upper;
}

// Joints that are beyond their limits must not go farther.
void HazardJudge::turn_back(const JointVector& q, const JointVector& rates,
                            HazardVerdict& verdict) const noexcept {
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const JointLimits& limits = manipulator_->leg(static_cast<std::size_t>(j)).limits;
    if (limits.contain(q[j])) continue;
    verdict.inside = verdict.escape = true;
    if (q[j] < limits.lower ? rates[j] < 0.0 : rates[j] > 0.0) verdict.scale = 0.0;
  }
}

}  // namespace parallel_aspects
