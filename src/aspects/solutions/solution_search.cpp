// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/solution_search.h"

#include "aspects/zeros/known_zeros.h"

#include <algorithm>
#include <cstddef>

namespace parallel_aspects {
namespace {

// As in cusp_search.cpp.
constexpr double largest_solution_box = 0.2, smallest_solution_box = 0x1p-34, solution_inflation = 1.5;
constexpr std::size_t largest_search = 20000;
constexpr int solution_contractions = 6;

class SolutionSearch {
 public:
  SolutionSearch(const StrutSlice& slice, const std::array<Interval, 2>& values)
      : slice_(slice), values_(values) {}

  std::optional<std::vector<Box>> run() {
    boxes_.push_back(whole_slice());
    for (std::size_t effort = 0; !boxes_.empty(); ++effort) {
      const Box box = boxes_.back();
      boxes_.pop_back();
      if (effort > largest_search || !examine(box)) return std::nullopt;
    }
    std::vector<Box> result;
    for (const KnownZero& each : known_.all()) result.push_back(without_turns(each.enclosure));
    return result;
  }

 private:
  bool may_hold_solution(const Box& box, const PairOverBox& pair) const {
    const SliceCenter middle(box);
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval value =
          pair.center[i] + pair.jacobian[i][0] * middle.offset(0) + pair.jacobian[i][1] * middle.offset(1);
      if (value.positive() || value.negative()) return false;
    }
    return true;
  }

  /// False where the box is too small to be divided.
  bool examine(const Box& box) {
    if (known_.cover(box)) return true;
    const PairOverBox pair = pair_over(slice_, box, values_);
    if (!may_hold_solution(box, pair)) return true;
    const double width = std::max(box.width(0), box.width(1));
    if (width < largest_solution_box && is_settled(scaled(box, solution_inflation))) return true;
    for (const Box& half : halves_of(box)) boxes_.push_back(half);
    return width > smallest_solution_box;
  }

  bool is_settled(const Box& box) {
    const ZeroSearch found = krawczyk_test(box, pair_over(slice_, box, values_));
    if (found.zeros != Zeros::one) return found.zeros == Zeros::none;
    return known_.note({box, contracted(slice_, found.enclosure, values_, solution_contractions)});
  }

  const StrutSlice& slice_;
  std::array<Interval, 2> values_;
  std::vector<Box> boxes_;
  KnownZeros known_;
};

}  // namespace

std::array<Interval, 2> values_at(const Lengths& lengths) noexcept {
  return {Interval(0.5) * square(Interval(lengths[0])), Interval(0.5) * square(Interval(lengths[1]))};
}

PairOverBox pair_over(const StrutSlice& slice, const Box& box, const std::array<Interval, 2>& values) {
  const SliceTurns over(ranges_of(box)), center(SliceCenter(box).at);
  PairOverBox pair;
  for (std::size_t i = 0; i < 2; ++i) {
    const Jet<1> slopes = slice.half_square<1>(i, over);
    pair.center[i] = slice.half_square<0>(i, center).value() - values[i];
    pair.jacobian[i] = {slopes.at(1, 0), slopes.at(0, 1)};
  }
  return pair;
}

Box contracted(const StrutSlice& slice, Box box, const std::array<Interval, 2>& values, int times) {
  for (int k = 0; k < times; ++k)
    box = intersection(box, krawczyk_test(box, pair_over(slice, box, values)).enclosure);
  return box;
}

std::optional<std::vector<Box>> find_all_solutions(const StrutSlice& slice, const Lengths& lengths) {
  assert_rounding_upward();
  const StrutSlice at = slice.at(lengths);
  return SolutionSearch(at, values_at(lengths)).run();
}

}  // namespace parallel_aspects
