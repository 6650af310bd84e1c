// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/continuation.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

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

}  // namespace parallel_aspects
