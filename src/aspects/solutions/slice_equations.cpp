// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/slice_equations.h"

#include "aspects/cusps/jet.h"
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

}  // namespace parallel_aspects
