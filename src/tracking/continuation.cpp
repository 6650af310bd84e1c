// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/continuation.h"

#include "model/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

// Of the whole path. Steps shrink in proportion to the distance from det A = 0, so that one this short is
// within about 1e-7 of the path of it, less than what encoders resolve.
constexpr double shortest_step = 0x1p-24;

// Of the actuated joints on the path, over their size: what rounding of shares and sums can do, with room.
constexpr double path_rounding = 0x1p-48;

}  // namespace

Continuation::Continuation(const PoseCertifier& certifier, const CertifiedPoint& start,
                           const JointVector& end, const JointVector& bend) noexcept
    : certifier_(certifier),
      at_(start),
      start_(start.q),
      end_(end),
      direction_(end - start.q),
      allowance_(path_rounding * (start.q.cwiseAbs() + end.cwiseAbs())) {
  if (bend.size() == allowance_.size()) allowance_ += bend;
}

// The old ball holds exactly one solution for all joint values of this step, and that one
// moves continuously; the new ball holds exactly one for those at its end. Where the new ball lies in the old
// one the two are the same, so that the new point continues the old one.
bool Continuation::step(double length) noexcept {
  if (speed_ < 0.0) speed_ = certifier_.path_speed(at_, direction_);
  const CertifiedBall ball = certifier_.ball(at_, direction_, allowance_, length, speed_);
  if (!ball.certified) return false;
  const double share = share_ + length >= 1.0 ? 1.0 : share_ + length;
  CertifiedPoint next;
  next.q = share >= 1.0 ? end_ : JointVector(start_ + share * direction_);
  next.pose = certifier_.predicted(at_, next.q);
  if (!certifier_.evaluate(next)) return false;
  const CertifiedBall reached = certifier_.ball(next);
  if (!reached.certified || !(certifier_.distance(at_.pose, next.pose) + reached.radius <= ball.radius))
    return false;
  at_ = next;
  share_ = share;
  radius_ = ball.radius;
  speed_ = -1.0;
  return true;
}

ContinuationStatus Continuation::advance() noexcept {
  const RoundingUpward upward;
  if (status_ != ContinuationStatus::unfinished) return status_;
  length_ = std::min(length_, 1.0 - share_);
  while (!step(length_)) {
    length_ *= 0.5;
    if (length_ < shortest_step) return status_ = ContinuationStatus::too_near_singular;
  }
  length_ *= 2.0;
  if (share_ >= 1.0) status_ = ContinuationStatus::finished;
  return status_;
}

ContinuationStatus Continuation::run(int max_steps) noexcept {
  for (int i = 0; i < max_steps && advance() == ContinuationStatus::unfinished; ++i) {
  }
  return status_;
}

bool certify_solution(const PoseCertifier& certifier, const Pose& pose, const JointVector& q,
                      CertifiedPoint& point) noexcept {
  const RoundingUpward upward;
  point.pose = pose;
  point.pose.orientation.normalize();
  point.q = q;
  return certifier.evaluate(point) && certifier.ball(point).certified;
}

namespace {

constexpr int most_boxes = 4000;
constexpr int most_halvings = 40;  // one within another
constexpr int most_steps = 64;     // from the middle of a box to that of a half

// How far an actuated joint can go in the time of a step; infinite where no velocity limit is stated.
double possible_way(const Leg& leg, const SampleOptions& options, double seconds) {
  const double fastest = leg.limits.velocity * (1.0 + options.velocity_tolerance);
  const bool limited = options.check_velocity && std::isfinite(fastest);
  return limited ? fastest * seconds : std::numeric_limits<double>::infinity();
}

// Whether that bounds where it was on its way from one value to the other: it can go as far, and cannot have
// turned the other way round where whole turns do not show. Both values are within `off` of the true ones.
// Rounds upward.
bool bounds_way(const Leg& leg, const SampleOptions& options, double change, double possible, double off) {
  const bool turns_show = !options.unwrap || !leg.actuated_by_angle() || possible + 2.0 * off < pi;
  return std::abs(change) <= possible && std::isfinite(possible) && turns_show;
}

// The box of the bounds, proved part by part.
class Sheet {
 public:
  explicit Sheet(const PoseCertifier& certifier) noexcept : certifier_(certifier) {}

  // Over the whole box, of which `at` is a point. Where one ball does not hold all of it, it is cut through
  // `at`: the straight paths from there to the middles of both parts are certified, and the solution over
  // each part, which is unique near by, is that of `at` where they meet.
  bool covers(const CertifiedPoint& at, const JointVector& lower, const JointVector& upper, int halvings) {
    if (boxes_++ >= most_boxes || halvings > most_halvings) return false;
    const TaskVector half = (upper - at.q).cwiseMax(at.q - lower);
    const TaskVector still = TaskVector::Zero(at.q.size());
    if (certifier_.ball(at, still, half, 0.0, 0.0).certified) return true;
    const Eigen::Index cut = certifier_.widest(at, half);
    if (!(half[cut] > 0.0)) return false;
    JointVector below = upper, above = lower;
    below[cut] = above[cut] = at.q[cut];
    return covers_part(at, lower, below, cut, halvings) && covers_part(at, above, upper, cut, halvings);
  }

 private:
  bool covers_part(const CertifiedPoint& at, const JointVector& lower, const JointVector& upper,
                   Eigen::Index cut, int halvings) {
    if (lower[cut] == upper[cut]) return true;  // it is a face of the other part
    JointVector middle = at.q;
    middle[cut] = 0.5 * (lower[cut] + upper[cut]);
    Continuation path(certifier_, at, middle);
    if (path.run(most_steps) != ContinuationStatus::finished) return false;
    return covers(path.at(), lower, upper, halvings + 1);
  }

  const PoseCertifier& certifier_;
  int boxes_ = 0;
};

}  // namespace

void JointReach::begin() noexcept {
  known_ = true;
  lower_.resize(0);
  upper_.resize(0);
}

void JointReach::add(const Manipulator& manipulator, const SampleOptions& options,
                     const SampleStep& step) noexcept {
  known_ = known_ && step.seconds >= 0.0;
  if (!known_) return;
  const RoundingUpward upward;
  const JointVector off = encoder_noise(manipulator, options) + step.uncertainty;
  if (lower_.size() == 0) lower_ = upper_ = step.from;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    const double from = step.from[i], to = step.to[i];
    const double possible = possible_way(manipulator.leg(j), options, step.seconds);
    // On its way it is no farther from each end than the time from there allows.
    double lower = -(0.5 * (possible - from - to) + off[i]), upper = 0.5 * (possible + from + to) + off[i];
    if (step.gap == SampleGap::none) {
      lower = std::max(lower, -(step.bend[i] - std::min(from, to)));
      upper = std::min(upper, std::max(from, to) + step.bend[i]);
    } else {
      known_ = known_ && bounds_way(manipulator.leg(j), options, to - from, possible, off[i]);
    }
    lower_[i] = std::min({lower_[i], lower, from, to});
    upper_[i] = std::max({upper_[i], upper, from, to});
  }
}

bool JointReach::keeps_to(const PoseCertifier& certifier, const CertifiedPoint& point) const noexcept {
  if (!known()) return false;
  Continuation path(certifier, point, 0.5 * (lower_ + upper_));
  if (path.run(most_steps) != ContinuationStatus::finished) return false;
  const RoundingUpward upward;
  return Sheet(certifier).covers(path.at(), lower_, upper_, 0);
}

}  // namespace parallel_aspects
