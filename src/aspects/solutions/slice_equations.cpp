// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/slice_equations.h"

#include "aspects/cusps/jet.h"
#include "aspects/solutions/solution_equations.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cstddef>

namespace parallel_aspects {

PairOverBox pair_over(const LegsAt& legs, const SlicePlace& place) {
  PairOverBox pair;
  for (std::size_t i = 0; i < 2; ++i) {
    const Jet<1> g = legs[i].equation.jet<1>(place.over());
    pair.center[i] = legs[i].equation.jet<0>(place.center()).value();
    pair.jacobian[i] = {g.at(1, 0), g.at(0, 1)};
  }
  return pair;
}

PairOverBox SliceEquations::at(const Box& box, const ActuatedValues& values) const {
  return about(box, values, 0.0);
}

PairOverBox SliceEquations::about(const Box& box, const ActuatedValues& values, double slack) const {
  const Interval off(-slack, slack);
  return pair_over({slice_.leg_at(0, values[0] + off), slice_.leg_at(1, values[1] + off)}, slice_.place(box));
}

// In the middle of the box g(m + t h) is  g(m) + t h g'  with g' of all values between.
std::optional<PairOverBox> SliceEquations::between(const Box& box, const ActuatedValues& from,
                                                   const ActuatedValues& to) const {
  const SlicePlace place = slice_.place(box);
  if (slice_.held_sign(place) == 0) return std::nullopt;
  PairOverBox pair;
  for (std::size_t i = 0; i < 2; ++i) {
    const HeldSlice::LegAt all =
        slice_.leg_at(i, Interval(std::min(from[i], to[i]), std::max(from[i], to[i])));
    if (may_vanish(all.slope.jet<0>(place.over()).value())) return std::nullopt;
    const Jet<1> g = all.equation.jet<1>(place.over());
    pair.jacobian[i] = {g.at(1, 0), g.at(0, 1)};
    const Interval middle = Interval(0.5) * (Interval(from[i]) + Interval(to[i]));
    const Interval half = Interval(0.5) * (Interval(to[i]) - Interval(from[i]));
    const Interval slope = all.slope.jet<0>(place.center()).value();
    const Interval drift = half * Interval(middle_of(slope));
    pair.center[i] = slice_.leg_at(i, middle).equation.jet<0>(place.center()).value() +
                     (half * slope - drift) * Interval(-1.0, 1.0);
    pair.drift[i] = -drift;
  }
  return pair;
}

namespace {

/// Values from one end of a line to the other: all, the middle, and half of the way.
struct ValuesBetween {
  Interval all, middle, half;

  ValuesBetween(double from, double to) noexcept
      : all(std::min(from, to), std::max(from, to)),
        middle(Interval(0.5) * (Interval(from) + Interval(to))),
        half(Interval(0.5) * (Interval(to) - Interval(from))) {}
};

}  // namespace

FamilyEquations::FamilyEquations(const Manipulator& manipulator, const HeldJoint& held)
    : slices_(manipulator, held), held_(held.leg) {}

PlanarHeldSlice FamilyEquations::slice_at(const Interval& held) const noexcept {
  PlanarHeldSlice result = slices_;
  result.hold(held);
  return result;
}

PairOverBox FamilyEquations::at(const Box& box, const ActuatedValues& values) const {
  return about(box, values, 0.0);
}

PairOverBox FamilyEquations::about(const Box& box, const ActuatedValues& values, double slack) const {
  const Interval off(-slack, slack);
  const PlanarHeldSlice slice = slice_at(values[held_] + off);
  const auto leg = [&](std::size_t i) { return slice.leg_at(i, values[slice.leg(i)] + off); };
  return pair_over({leg(0), leg(1)}, slice.place(box));
}

// In the middle of the box g(m, t) is  g(m, 0) + t g'  with the derivative g' by t at any t between.
std::optional<PairOverBox> FamilyEquations::between(const Box& box, const ActuatedValues& from,
                                                    const ActuatedValues& to) const {
  const ValuesBetween held(from[held_], to[held_]);
  const PlanarHeldSlice over = slice_at(held.all), middle = slice_at(held.middle);
  const SlicePlace place = over.place(box);
  if (over.held_sign(place) == 0) return std::nullopt;
  PairOverBox pair;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t leg = over.leg(i);
    const ValuesBetween values(from[leg], to[leg]);
    const HeldSlice::LegAt all = over.leg_at(i, values.all);
    if (may_vanish(all.slope.jet<0>(place.over()).value())) return std::nullopt;
    const Jet<1> g = all.equation.jet<1>(place.over());
    pair.jacobian[i] = {g.at(1, 0), g.at(0, 1)};
    const Interval rate = all.slope.jet<0>(place.center()).value() * values.half +
                          all.held_slope.jet<0>(place.center()).value() * held.half;
    const Interval drift(middle_of(rate));
    pair.center[i] = middle.leg_at(i, values.middle).equation.jet<0>(place.center()).value() +
                     (rate - drift) * Interval(-1.0, 1.0);
    pair.drift[i] = -drift;
  }
  return pair;
}

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
