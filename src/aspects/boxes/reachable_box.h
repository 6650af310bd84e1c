// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_REACHABLE_BOX_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_REACHABLE_BOX_H

#include "interval/interval.h"
#include "parallel_aspects/aspects/box.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// The positions within reach of every leg; each leg allows positions that are at most `reach` from `center`.
class ReachableBox {
 public:
  explicit ReachableBox(std::size_t dimension) : box_{dimension, {}, {}} {
    box_.lower.fill(-HUGE_VAL);
    box_.upper.fill(HUGE_VAL);
  }

  /// Along coordinate i. An infinite reach is no restriction. Needs a live `RoundingUpward`.
  void restrict(std::size_t i, const Interval& center, double reach) {
    assert_rounding_upward();
    if (!std::isfinite(reach)) return;
    // Reaches are rounded sums of lengths.
    const Interval range = center + Interval(1.0 + 1e-12) * Interval(-reach, reach);
    box_.lower[i] = std::max(box_.lower[i], range.lower());
    box_.upper[i] = std::min(box_.upper[i], range.upper());
  }

  /// Nothing where some coordinate is not bounded.
  std::optional<Box> box() const {
    for (std::size_t i = 0; i < box_.dimension; ++i)
      if (!std::isfinite(box_.width(i))) return std::nullopt;
    return box_;
  }

 private:
  Box box_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_REACHABLE_BOX_H
