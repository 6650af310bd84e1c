// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_SLOPE_FUNCTIONS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_SLOPE_FUNCTIONS_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/tree/monotonicity.h"
#include "interval/dual.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

template <std::size_t N, class Value>
std::array<Interval, N> ranges(const std::array<Value, N>& values) {
  std::array<Interval, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = range_of(values[i]);
  return result;
}

/// Leaves the directions in which the poses grow where the function is positive.
template <std::size_t N, class Value>
void require_positive(const Dual<N, Value>& function, Monotonicity& monotonicity) {
  if (is_positive(range_of(function)) == Verdict::unknown) monotonicity.require(ranges(function.gradient));
}

template <std::size_t N, class Value>
Condition condition(const Dual<N, Value>& function) {
  Condition result{middle_of(range_of(function)), {}};
  for (std::size_t i = 0; i < N; ++i) result.slope[i] = middle_of(range_of(function.gradient[i]));
  return result;
}

/// Of limits of which one is enough, the one that is farther from failing.
template <std::size_t N, class Value>
void add_limits(const LimitFunctions<Dual<N, Value>>& limits, Conditions& result) {
  std::array<Condition, 2> each;
  for (std::size_t k = 0; k < limits.count; ++k) each[k] = condition(limits.values[k]);
  if (limits.any && limits.count == 2) return result.add(each[each[0].value < each[1].value ? 1 : 0]);
  for (std::size_t k = 0; k < limits.count; ++k) result.add(each[k]);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_SLOPE_FUNCTIONS_H
