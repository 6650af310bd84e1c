// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/strut_equations.h"

#include "aspects/solutions/all_zeros.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cstddef>

namespace parallel_aspects {
namespace {

/// Half the square of m + t h for t from -1 to 1, as a value and the slope m h.
struct HalfSquareBetween {
  Interval value, slope;

  HalfSquareBetween(double from, double to) noexcept {
    const Interval middle = Interval(0.5) * (Interval(from) + Interval(to));
    const Interval half = Interval(0.5) * (Interval(to) - Interval(from));
    value = Interval(0.5) * (square(middle) + Interval(0.0, square(half).upper()));
    slope = middle * half;
  }
};

/// The rod that is held, as  middle + t slope  and what is left of that, for t from -1 to 1.
struct RodBetween {
  StrutSlice middle;
  Interval all, slope, rest;

  RodBetween(const StrutSlice& family, double from, double to) noexcept
      : middle(slices_of(family, Interval(0.5) * (Interval(from) + Interval(to)))),
        all(slices_of(family, {std::min(from, to), std::max(from, to)}).rod()) {
    const Interval half = Interval(0.5) * (Interval(to) - Interval(from));
    const Interval derivative = Interval(std::min(from, to), std::max(from, to)) * half * reciprocal(all);
    slope = Interval(middle_of(derivative));
    rest = (derivative - slope) * Interval(-1.0, 1.0);
  }

  static StrutSlice slices_of(const StrutSlice& family, const Interval& lengths) noexcept {
    return family.with_half_square(Interval(0.5) * square(lengths));
  }
};

PairOverBox pair_between(const StrutSlice& slice, const Box& box, const Lengths& from, const Lengths& to) {
  const HalfSquareBetween first(from[0], to[0]), second(from[1], to[1]);
  PairOverBox pair = pair_over(slice, box, {first.value, second.value});
  pair.drift = {first.slope, second.slope};
  return pair;
}

/// The same in a family: g_i is of degree two in the rod.
PairOverBox pair_in_family(const StrutSlice& family, const Box& box, const Lengths& from, const Lengths& to) {
  const RodBetween rod(family, from[2], to[2]);
  PairOverBox pair = pair_between(rod.middle, box, from, to);
  pair.jacobian = pair_over(family.with_rod(rod.all), box, {}).jacobian;
  const SliceTurns center(SliceCenter(box).at);
  const Interval bend = Interval(0.5) * square(rod.all - rod.middle.rod());
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval slope = rod.middle.slope<0>(i, center).value();
    pair.center[i] += slope * rod.rest + bend;
    pair.drift[i] = pair.drift[i] - slope * rod.slope;
  }
  return pair;
}

}  // namespace

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

std::optional<std::vector<Box>> find_all_solutions(const StrutSlice& slice, const Lengths& lengths) {
  assert_rounding_upward();
  const StrutSlice at = slice.at(lengths);
  const std::array<Interval, 2> values = values_at(lengths);
  return find_all_zeros([&](const Box& box) { return pair_over(at, box, values); });
}

PairOverBox StrutEquations::at(const Box& box, const ActuatedValues& lengths) const {
  return pair_over(slice_.at(lengths), box, values_at(lengths));
}

PairOverBox StrutEquations::about(const Box& box, const ActuatedValues& lengths, double slack) const {
  std::array<Interval, 3> values;
  for (std::size_t i = 0; i < 3; ++i)
    values[i] = Interval(0.5) * square(Interval(lengths[i]) + Interval(-slack, slack));
  const StrutSlice slice = slice_.dimension() == 2 ? slice_ : slice_.with_half_square(values[2]);
  return pair_over(slice, box, {values[0], values[1]});
}

std::optional<PairOverBox> StrutEquations::between(const Box& box, const ActuatedValues& from,
                                                   const ActuatedValues& to) const {
  return slice_.dimension() == 2 ? pair_between(slice_, box, from, to)
                                 : pair_in_family(slice_, box, from, to);
}

}  // namespace parallel_aspects
