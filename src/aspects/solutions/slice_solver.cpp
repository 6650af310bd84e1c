// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/slice_solver.h"

#include "aspects/cusps/jet.h"
#include "aspects/zeros/known_zeros.h"
#include "aspects/zeros/krawczyk.h"

#include <algorithm>
#include <cstddef>

namespace parallel_aspects {
namespace {

// Boxes that are larger are not worth Krawczyk's test, and smaller ones not worth being divided [half turns].
constexpr double largest_tested = 0.2, smallest_box = 0x1p-34, inflation = 1.5;
constexpr std::size_t largest_effort = 20000;
constexpr int contractions = 6;

class SliceSolver {
 public:
  SliceSolver(const HeldSlice& slice, const std::array<double, 2>& values)
      : slice_(slice), legs_{slice.leg_at(0, values[0]), slice.leg_at(1, values[1])} {}

  std::optional<std::vector<SliceSolution>> run() {
    boxes_.push_back(whole_slice());
    for (std::size_t effort = 0; !boxes_.empty(); ++effort) {
      const Box box = boxes_.back();
      boxes_.pop_back();
      if (effort > largest_effort || !examine(box)) return std::nullopt;
    }
    std::vector<SliceSolution> result;
    for (const KnownZero& zero : known_.all()) result.push_back(solution_in(zero.enclosure));
    return result;
  }

 private:
  PairOverBox pair_over(const Box& box) const {
    const SlicePlace place = slice_.place(box);
    PairOverBox pair;
    for (std::size_t i = 0; i < 2; ++i) {
      const Jet<1> g = legs_[i].equation.jet<1>(place.over());
      pair.center[i] = legs_[i].equation.jet<0>(place.center()).value();
      pair.jacobian[i] = {g.at(1, 0), g.at(0, 1)};
    }
    return pair;
  }

  static bool may_vanish(const Box& box, const PairOverBox& pair) {
    const SliceCenter middle(box);
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval g =
          pair.center[i] + pair.jacobian[i][0] * middle.offset(0) + pair.jacobian[i][1] * middle.offset(1);
      if (g.positive() || g.negative()) return false;
    }
    return true;
  }

  /// False where the box is too small to be divided.
  bool examine(const Box& box) {
    if (known_.cover(box)) return true;
    if (!may_vanish(box, pair_over(box))) return true;
    const double width = std::max(box.width(0), box.width(1));
    if (width < largest_tested && is_settled(scaled(box, inflation))) return true;
    for (const Box& half : halves_of(box)) boxes_.push_back(half);
    return width > smallest_box;
  }

  bool is_settled(const Box& box) {
    const ZeroSearch found = krawczyk_test(box, pair_over(box));
    if (found.zeros != Zeros::one) return found.zeros == Zeros::none;
    Box enclosure = found.enclosure;
    for (int k = 0; k < contractions; ++k)
      enclosure = intersection(enclosure, krawczyk_test(enclosure, pair_over(enclosure)).enclosure);
    return known_.note({box, enclosure});
  }

  SliceSolution solution_in(const Box& enclosure) const {
    SliceSolution result{without_turns(enclosure), {}};
    const SlicePlace place = slice_.place(enclosure);
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval slope = legs_[i].slope.jet<0>(place.over()).value();
      result.posture[i] = slope.negative() ? 1 : slope.positive() ? -1 : 0;
    }
    return result;
  }

  const HeldSlice& slice_;
  std::array<HeldSlice::LegAt, 2> legs_;
  std::vector<Box> boxes_;
  KnownZeros known_;
};

}  // namespace

std::optional<std::vector<SliceSolution>> find_slice_solutions(const HeldSlice& slice,
                                                               const std::array<double, 2>& values) {
  assert_rounding_upward();
  return SliceSolver(slice, values).run();
}

}  // namespace parallel_aspects
