// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_ROUNDING_H
#define PARALLEL_ASPECTS_INTERVAL_ROUNDING_H

#include <cassert>
#include <cfenv>
#include <cmath>

// What proofs rest on of floating-point arithmetic.

namespace parallel_aspects {

/// While one lives, floating-point operations of its thread round upward. Intervals are enclosures only
/// meanwhile. Hold one for a whole batch: switching costs more than many operations.
class RoundingUpward {
 public:
  RoundingUpward() noexcept : before_(std::fegetround()) { std::fesetround(FE_UPWARD); }
  ~RoundingUpward() { std::fesetround(before_); }
  RoundingUpward(const RoundingUpward&) = delete;
  RoundingUpward& operator=(const RoundingUpward&) = delete;

 private:
  int before_;
};

/// Whether this thread rounds upward, found by arithmetic. `fegetround` of glibc reads the control word of
/// the x87 unit only, while the proofs are computed by SSE.
inline bool rounds_upward() noexcept {
  const volatile double one = 1.0, tiny = 0x1p-60;
  return one + tiny > 1.0;
}

/// First in whatever needs a live `RoundingUpward`. Checked where assertions are: in debug and sanitized
/// builds.
inline void assert_rounding_upward() noexcept { assert(rounds_upward()); }

/// A member whose constructor needs a live `RoundingUpward`.
template <class Made, class... Arguments>
Made made_under_upward_rounding(const Arguments&... arguments) {
  const RoundingUpward rounding;
  return Made(arguments...);
}

/// More than a few units in the last place of numbers up to 1: what sine, cosine and sums of some rounded
/// numbers are off by at most, in every rounding direction.
inline constexpr double few_units = 0x1p-48;

/// A lower bound of sqrt(-a), for an upper bound `a` of what is not positive. The root and the product are
/// rounded up, by one part in 2^52 each; the factor takes two.
inline double lower_root_of_negated(double a) noexcept { return std::sqrt(-a) * (1.0 - 0x1p-51); }

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_ROUNDING_H
