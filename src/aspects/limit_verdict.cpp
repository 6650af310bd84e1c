// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/limit_verdict.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

Verdict opposite(Verdict a) {
  if (a == Verdict::unsure) return a;
  return a == Verdict::holds ? Verdict::fails : Verdict::holds;
}

Verdict is_positive(const Interval& value) {
  if (value.positive()) return Verdict::holds;
  return value.negative() ? Verdict::fails : Verdict::unsure;
}

}  // namespace

Verdict both(Verdict a, Verdict b) noexcept {
  if (a == Verdict::fails || b == Verdict::fails) return Verdict::fails;
  return a == Verdict::holds && b == Verdict::holds ? Verdict::holds : Verdict::unsure;
}

AngleLimits::AngleLimits(const JointLimits& limits, double offset, double sense)
    : limited_(std::isfinite(limits.lower) && std::isfinite(limits.upper) &&
               limits.upper - limits.lower < 2.0 * EIGEN_PI) {
  if (!limited_) return;
  const double one_end = offset + sense * limits.lower, other_end = offset + sense * limits.upper;
  lower_ = direction(std::min(one_end, other_end));
  upper_ = direction(std::max(one_end, other_end));
  less_than_half_turn_ = limits.upper - limits.lower < EIGEN_PI;
}

// The angle is a rounded sum of a limit and perhaps a rounded arc tangent; its error and that of cosine and
// sine are a few units in the last place each, in every rounding direction. Together they stay below this.
AngleLimits::Direction AngleLimits::direction(double angle) {
  const double error = 0x1p-48 * (1.0 + std::abs(angle));
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {{cosine - error, cosine + error}, {sine - error, sine + error}};
}

Verdict AngleLimits::test(const Interval& cosine, const Interval& sine) const noexcept {
  if (!limited_) return Verdict::holds;
  const auto follows = [&](const Direction& limit) {
    return is_positive(limit.cosine * sine - limit.sine * cosine);
  };
  const auto precedes = [&](const Direction& limit) {
    return is_positive(limit.sine * cosine - limit.cosine * sine);
  };
  if (less_than_half_turn_) return both(follows(lower_), precedes(upper_));
  return opposite(both(follows(upper_), precedes(lower_)));
}

Verdict LengthLimits::test(const Interval& length) const noexcept {
  Verdict verdict = Verdict::holds;
  if (std::isfinite(limits_.lower)) verdict = is_positive(length - Interval(limits_.lower));
  if (std::isfinite(limits_.upper)) verdict = both(verdict, is_positive(Interval(limits_.upper) - length));
  return verdict;
}

}  // namespace parallel_aspects
