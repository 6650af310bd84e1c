// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/slice_solver.h"

#include "aspects/solutions/all_zeros.h"
#include "aspects/solutions/slice_equations.h"

#include <cstddef>

namespace parallel_aspects {
namespace {

SlicePosture posture_in(const HeldSlice& slice, const LegsAt& legs, const Box& enclosure) {
  const SlicePlace place = slice.place(enclosure);
  SlicePosture posture{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval slope = legs[i].slope.jet<0>(place.over()).value();
    posture[i] = slope.negative() ? 1 : slope.positive() ? -1 : 0;
  }
  return posture;
}

}  // namespace

std::optional<std::vector<SliceSolution>> find_slice_solutions(const HeldSlice& slice,
                                                               const std::array<double, 2>& values) {
  assert_rounding_upward();
  const LegsAt legs{slice.leg_at(0, values[0]), slice.leg_at(1, values[1])};
  const auto boxes = find_all_zeros([&](const Box& box) { return pair_over(legs, slice.place(box)); });
  if (!boxes) return std::nullopt;
  std::vector<SliceSolution> result;
  for (const Box& box : *boxes) result.push_back({box, posture_in(slice, legs, box)});
  return result;
}

}  // namespace parallel_aspects
