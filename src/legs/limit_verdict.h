// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_LIMIT_VERDICT_H
#define PARALLEL_ASPECTS_LEGS_LIMIT_VERDICT_H

#include "interval/half_turns.h"
#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// What is proved of a condition on a whole box: it holds everywhere, it fails everywhere, or neither.
enum class Verdict { holds, fails, unknown };

Verdict both(Verdict a, Verdict b) noexcept;
Verdict either(Verdict a, Verdict b) noexcept;
Verdict is_positive(const Interval& value) noexcept;

/// A verdict on one box, or on each of several in lanes; unknown where it is neither.
template <class Mask>
struct Proved {
  Mask holds, fails;
};

inline Verdict verdict_of(const Proved<bool>& proved) noexcept {
  return proved.holds ? Verdict::holds : proved.fails ? Verdict::fails : Verdict::unknown;
}

/// Limits of an actuated joint as functions of the pose: within limits where all of `values`, or with `any`
/// at least one, are positive. A value exactly at a limit may count as inside or outside.
template <class Scalar>
struct LimitFunctions {
  std::array<Scalar, 2> values;
  std::size_t count = 0;
  bool any = false;

  void add(const Scalar& value) { values[count++] = value; }
};

template <class Range>
auto proved(const LimitFunctions<Range>& limits) noexcept {
  using Mask = decltype(limits.values[0].positive());
  const bool any = limits.any && limits.count > 0;
  Proved<Mask> result{any ? Mask{} : !Mask{}, any ? !Mask{} : Mask{}};
  for (std::size_t k = 0; k < limits.count; ++k) {
    const Mask positive = limits.values[k].positive(), negative = limits.values[k].negative();
    result.holds = any ? result.holds | positive : result.holds & positive;
    result.fails = any ? result.fails & negative : result.fails | negative;
  }
  return result;
}

inline Verdict verdict(const LimitFunctions<Interval>& limits) noexcept { return verdict_of(proved(limits)); }

/// Limits of a joint angle, tested on its cosine and sine without any arc function.
class AngleLimits {
 public:
  /// Without limits.
  AngleLimits() = default;

  /// The angle `offset` + `sense` q is tested, q in `limits` [rad]; `sense` +1 or -1. A range of a full turn
  /// or more is no limit.
  AngleLimits(const JointLimits& limits, double offset, double sense);

  bool limited() const noexcept { return limited_; }

  /// For an angle whose cosine and sine, up to one positive factor, are the arguments.
  template <class Scalar>
  LimitFunctions<Scalar> functions(const Scalar& cosine, const Scalar& sine) const {
    LimitFunctions<Scalar> result;
    if (!limited_) return result;
    result.any = !less_than_half_turn_;
    result.add(lower_.cosine * sine - lower_.sine * cosine);
    result.add(upper_.sine * cosine - upper_.cosine * sine);
    return result;
  }

 private:
  bool limited_ = false;
  bool less_than_half_turn_ = false;
  Turn<Interval> lower_, upper_;
};

/// Limits of a length [m].
class LengthLimits {
 public:
  LengthLimits() = default;
  explicit LengthLimits(const JointLimits& limits) noexcept : limits_(limits) {}

  /// Of the length `zero` + `sense` q of a strut, q in `limits`; `sense` +1 or -1.
  LengthLimits(const JointLimits& limits, const Interval& zero, double sense);

  bool limited() const noexcept { return limits_.limited(); }

  template <class Scalar>
  LimitFunctions<Scalar> functions(const Scalar& length) const {
    LimitFunctions<Scalar> result;
    if (std::isfinite(limits_.lower)) result.add(length - Scalar(limits_.lower));
    if (std::isfinite(limits_.upper)) result.add(Scalar(limits_.upper) - length);
    return result;
  }

  /// For a length of at least zero, given by its square: no root is needed. Only for limits of a strut.
  template <class Scalar>
  LimitFunctions<Scalar> functions_of_square(const Scalar& squared_length) const {
    LimitFunctions<Scalar> result;
    if (squared_lower_) result.add(squared_length - Scalar(*squared_lower_));
    if (squared_upper_) result.add(Scalar(*squared_upper_) - squared_length);
    return result;
  }

 private:
  JointLimits limits_;
  std::optional<Interval> squared_lower_, squared_upper_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_LIMIT_VERDICT_H
