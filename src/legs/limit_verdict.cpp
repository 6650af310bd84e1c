// SPDX-License-Identifier: BSD-3-Clause
#include "legs/limit_verdict.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

Verdict both(Verdict a, Verdict b) noexcept {
  if (a == Verdict::fails || b == Verdict::fails) return Verdict::fails;
  return a == Verdict::holds && b == Verdict::holds ? Verdict::holds : Verdict::unknown;
}

Verdict either(Verdict a, Verdict b) noexcept {
  if (a == Verdict::holds || b == Verdict::holds) return Verdict::holds;
  return a == Verdict::fails && b == Verdict::fails ? Verdict::fails : Verdict::unknown;
}

Verdict is_positive(const Interval& value) noexcept {
  if (value.positive()) return Verdict::holds;
  return value.negative() ? Verdict::fails : Verdict::unknown;
}

AngleLimits::AngleLimits(const JointLimits& limits, double offset, double sense)
    : limited_(std::isfinite(limits.lower) && std::isfinite(limits.upper) &&
               limits.upper - limits.lower < 2.0 * EIGEN_PI) {
  if (!limited_) return;
  const double one_end = offset + sense * limits.lower, other_end = offset + sense * limits.upper;
  lower_ = enclosed_turn(std::min(one_end, other_end));
  upper_ = enclosed_turn(std::max(one_end, other_end));
  less_than_half_turn_ = limits.upper - limits.lower < EIGEN_PI;
}

LengthLimits::LengthLimits(const JointLimits& limits, const Interval& zero, double sense) : limits_(limits) {
  const double first = sense > 0.0 ? limits.lower : limits.upper;
  const double last = sense > 0.0 ? limits.upper : limits.lower;
  const Interval factor(sense);
  if (std::isfinite(first)) {
    const Interval shortest = zero + factor * Interval(first);
    if (!shortest.negative()) squared_lower_ = square(not_negative_part(shortest));
  }
  if (std::isfinite(last)) {
    const Interval longest = zero + factor * Interval(last);
    squared_upper_ = longest.negative() ? Interval(-1.0) : square(not_negative_part(longest));
  }
}

}  // namespace parallel_aspects
