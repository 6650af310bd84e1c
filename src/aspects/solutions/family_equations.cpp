// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/family_equations.h"

#include "aspects/solutions/slice_equations.h"
#include "interval/scalar_range.h"

#include <algorithm>

namespace parallel_aspects {
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

}  // namespace parallel_aspects
