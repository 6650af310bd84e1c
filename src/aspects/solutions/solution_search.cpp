// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/solution_search.h"

#include "aspects/solutions/all_zeros.h"

#include <cstddef>

namespace parallel_aspects {

std::array<Interval, 2> values_at(const Lengths& lengths) noexcept {
  return {Interval(0.5) * square(Interval(lengths[0])), Interval(0.5) * square(Interval(lengths[1]))};
}

PairOverBox pair_over(const StrutSlice& slice, const Box& box, const std::array<Interval, 2>& values) {
  const bool is_point = box.width(0) == 0.0 && box.width(1) == 0.0;
  const SliceTurns center(SliceCenter(box).at), over = is_point ? center : SliceTurns(ranges_of(box));
  PairOverBox pair;
  for (std::size_t i = 0; i < 2; ++i) {
    const Jet<1> slopes = slice.half_square<1>(i, over);
    pair.center[i] = (is_point ? slopes.value() : slice.half_square<0>(i, center).value()) - values[i];
    pair.jacobian[i] = {slopes.at(1, 0), slopes.at(0, 1)};
  }
  return pair;
}

Box contracted(const StrutSlice& slice, Box box, const std::array<Interval, 2>& values, int times) {
  return contracted([&](const Box& over) { return pair_over(slice, over, values); }, box, times);
}

std::optional<std::vector<Box>> find_all_solutions(const StrutSlice& slice, const Lengths& lengths) {
  assert_rounding_upward();
  const StrutSlice at = slice.at(lengths);
  const std::array<Interval, 2> values = values_at(lengths);
  return find_all_zeros([&](const Box& box) { return pair_over(at, box, values); });
}

}  // namespace parallel_aspects
