// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_LIMIT_VERDICT_H
#define PARALLEL_ASPECTS_ASPECTS_LIMIT_VERDICT_H

#include "parallel_aspects/aspects/interval.h"
#include "parallel_aspects/model/leg.h"

namespace parallel_aspects {

/// What is proved of a condition on a whole box: it holds everywhere, it fails everywhere, or neither.
enum class Verdict { holds, fails, unsure };

Verdict both(Verdict a, Verdict b) noexcept;

/// Limits of a drive angle, tested on its cosine and sine without any arc function.
class AngleLimits {
 public:
  /// Without limits.
  AngleLimits() = default;

  /// The angle `offset` + `sense` q is tested, q in `limits` [rad]; `sense` +1 or -1. A range of a full turn
  /// or more is no limit.
  AngleLimits(const JointLimits& limits, double offset, double sense);

  bool limited() const noexcept { return limited_; }

  /// For an angle whose cosine and sine, up to one positive factor, are enclosed by the arguments.
  Verdict test(const Interval& cosine, const Interval& sine) const noexcept;

 private:
  struct Direction {
    Interval cosine, sine;
  };
  static Direction direction(double angle);

  bool limited_ = false;
  bool less_than_half_turn_ = false;
  Direction lower_, upper_;
};

/// Limits of a drive value that is a length [m].
class LengthLimits {
 public:
  LengthLimits() = default;
  explicit LengthLimits(const JointLimits& limits) noexcept : limits_(limits) {}

  bool limited() const noexcept { return limits_.limited(); }
  Verdict test(const Interval& length) const noexcept;

 private:
  JointLimits limits_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_LIMIT_VERDICT_H
