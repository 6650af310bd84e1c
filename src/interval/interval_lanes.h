// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_INTERVAL_LANES_H
#define PARALLEL_ASPECTS_INTERVAL_INTERVAL_LANES_H

#include "interval/half_turns.h"
#include "interval/interval.h"
#include "interval/lanes.h"

#include <cstddef>
#include <type_traits>

namespace parallel_aspects {

/// Several `Interval`s at once, with the same operations in the same order: each lane is the same to the last
/// digit. Needs a live `RoundingUpward`, -frounding-math and -ffp-contract=off.
///
/// It would serve one number, too; but `Interval`, which has both of its ends in one vector, takes about a
/// tenth less time for determinants and roots.
template <class Numbers>
class IntervalLanes {
#define PARALLEL_ASPECTS_INLINE [[gnu::always_inline]]
 public:
  PARALLEL_ASPECTS_INLINE IntervalLanes() noexcept : negated_lower_{}, upper_{} {}
  PARALLEL_ASPECTS_INLINE IntervalLanes(double value) noexcept  // NOLINT: numbers are exact intervals
      : negated_lower_(in_lanes<Numbers>(-value)), upper_(in_lanes<Numbers>(value)) {}
  PARALLEL_ASPECTS_INLINE IntervalLanes(const Interval& value) noexcept  // NOLINT: the same in every lane
      : negated_lower_(in_lanes<Numbers>(-value.lower())), upper_(in_lanes<Numbers>(value.upper())) {}
  PARALLEL_ASPECTS_INLINE IntervalLanes(const Numbers& lower, const Numbers& upper) noexcept
      : negated_lower_(-lower), upper_(upper) {}

  PARALLEL_ASPECTS_INLINE Numbers lower() const noexcept { return -negated_lower_; }
  PARALLEL_ASPECTS_INLINE const Numbers& upper() const noexcept { return upper_; }

  PARALLEL_ASPECTS_INLINE Interval lane(std::size_t i) const noexcept {
    return {-negated_lower_[i], upper_[i]};
  }
  PARALLEL_ASPECTS_INLINE void set_lane(std::size_t i, const Interval& value) noexcept {
    negated_lower_[i] = -value.lower();
    upper_[i] = value.upper();
  }

  PARALLEL_ASPECTS_INLINE auto positive() const noexcept { return negated_lower_ < 0.0; }
  PARALLEL_ASPECTS_INLINE auto negative() const noexcept { return upper_ < 0.0; }

  PARALLEL_ASPECTS_INLINE friend IntervalLanes operator-(const IntervalLanes& a) noexcept {
    return ends(a.upper_, a.negated_lower_);
  }
  PARALLEL_ASPECTS_INLINE friend IntervalLanes operator+(const IntervalLanes& a,
                                                         const IntervalLanes& b) noexcept {
    return ends(a.negated_lower_ + b.negated_lower_, a.upper_ + b.upper_);
  }
  PARALLEL_ASPECTS_INLINE friend IntervalLanes operator-(const IntervalLanes& a,
                                                         const IntervalLanes& b) noexcept {
    return ends(a.negated_lower_ + b.upper_, a.upper_ + b.negated_lower_);
  }
  PARALLEL_ASPECTS_INLINE friend IntervalLanes operator*(const IntervalLanes& a,
                                                         const IntervalLanes& b) noexcept {
    const Numbers &na = a.negated_lower_, &ua = a.upper_, &nb = b.negated_lower_, &ub = b.upper_;
    return ends(greater(greater(na * -nb, na * ub), greater(ua * nb, -ua * ub)),
                greater(greater(na * nb, -na * ub), greater(ua * -nb, ua * ub)));
  }

  PARALLEL_ASPECTS_INLINE IntervalLanes& operator+=(const IntervalLanes& other) noexcept {
    return *this = *this + other;
  }

  PARALLEL_ASPECTS_INLINE friend IntervalLanes square(const IntervalLanes& a) noexcept {
    const Numbers smallest = larger_of(larger_of(Numbers{}, a.lower()), Numbers(-a.upper_));
    const Numbers largest = larger_of(a.negated_lower_, a.upper_);
    return ends(-smallest * smallest, largest * largest);
  }

  PARALLEL_ASPECTS_INLINE friend IntervalLanes square_root(const IntervalLanes& a) noexcept {
    constexpr double down = 1.0 - 0x1p-52;
    const Numbers root_of_lower = root_of(larger_of(Numbers{}, a.lower()));
    return ends(-root_of_lower * down, root_of(larger_of(Numbers{}, a.upper_)));
  }

  /// Where a is positive.
  PARALLEL_ASPECTS_INLINE friend IntervalLanes reciprocal(const IntervalLanes& a) noexcept {
    return ends(-1.0 / a.upper_, 1.0 / a.lower());
  }

  /// The same where a is known to be at least `least` > 0.
  PARALLEL_ASPECTS_INLINE friend IntervalLanes reciprocal(const IntervalLanes& a, double least) noexcept {
    return reciprocal(IntervalLanes(larger_of(a.lower(), in_lanes<Numbers>(least)), a.upper_));
  }

  PARALLEL_ASPECTS_INLINE friend IntervalLanes intersection(const IntervalLanes& a,
                                                            const IntervalLanes& b) noexcept {
    return IntervalLanes(larger_of(a.lower(), b.lower()), smaller_of(a.upper_, b.upper_));
  }

  PARALLEL_ASPECTS_INLINE friend IntervalLanes not_negative_part(const IntervalLanes& a) noexcept {
    return IntervalLanes(larger_of(Numbers{}, a.lower()), larger_of(Numbers{}, a.upper_));
  }

  template <class Mask>
  PARALLEL_ASPECTS_INLINE friend IntervalLanes where(const Mask& condition, const IntervalLanes& a,
                                                     const IntervalLanes& b) noexcept {
    return ends(where(condition, a.negated_lower_, b.negated_lower_), where(condition, a.upper_, b.upper_));
  }

 private:
  PARALLEL_ASPECTS_INLINE static IntervalLanes ends(const Numbers& negated_lower,
                                                    const Numbers& upper) noexcept {
    IntervalLanes result;
    result.negated_lower_ = negated_lower;
    result.upper_ = upper;
    return result;
  }
  PARALLEL_ASPECTS_INLINE static Numbers greater(const Numbers& a, const Numbers& b) noexcept {
    return a > b ? a : b;
  }
#undef PARALLEL_ASPECTS_INLINE

  Numbers negated_lower_, upper_;
};

/// The intervals of numbers: of one, or of several in lanes.
template <class Number>
using RangeOf = std::conditional_t<std::is_same_v<Number, double>, Interval, IntervalLanes<Number>>;

inline Interval lane_of(const Interval& of, std::size_t) noexcept { return of; }
template <class Numbers>
[[gnu::always_inline]] inline Interval lane_of(const IntervalLanes<Numbers>& of, std::size_t i) noexcept {
  return of.lane(i);
}

/// Boxes of one level hold few different angles, which are worked out once.
template <class Numbers>
[[gnu::always_inline]] inline Turn<IntervalLanes<Numbers>> turn_of_half_turns(
    const IntervalLanes<Numbers>& a) noexcept {
  Turn<IntervalLanes<Numbers>> result;
  for (std::size_t i = 0; i < lane_count<Numbers>; ++i) {
    const Turn<Interval>& turn = remembered_turn(a.lane(i));
    result.cosine.set_lane(i, turn.cosine);
    result.sine.set_lane(i, turn.sine);
  }
  return result;
}

template <class Numbers>
[[gnu::always_inline]] inline IntervalLanes<Numbers> range_of(const IntervalLanes<Numbers>& a) noexcept {
  return a;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_INTERVAL_LANES_H
