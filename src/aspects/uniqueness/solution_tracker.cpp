// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/solution_tracker.h"

#include "aspects/solutions/solution_search.h"
#include "aspects/zeros/krawczyk.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Angles = std::array<double, 2>;  // of a slice [half turns]

// Of a line, and of boxes [half turns].
constexpr double shortest_tracking_step = 0x1p-20, least_tracking_box = 1e-11;
constexpr double longest_tracking_step = 0.3;

// Boxes are longer than what solutions move by this share, at each end.
constexpr double tracking_inflation = 0.3;
constexpr int newton_steps = 5, tracking_contractions = 2;

Lengths between(const Lengths& from, const Lengths& to, double t) {
  if (t >= 1.0) return to;
  Lengths at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = from[i] + t * (to[i] - from[i]);
  return at;
}

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

/// For all lengths between.
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

std::optional<Box> SolutionTracker::follow(const Box& box, const Lengths& from, const Lengths& to) const {
  Box now = box;
  double t = 0.0, length = 1.0;
  while (t < 1.0) {
    const double next = std::min(1.0, t + length);
    const auto found = step(now, between(from, to, t), between(from, to, next));
    if (found) {
      now = without_turns(*found);
      t = next;
      length *= 1.4;
    } else {
      length *= 0.5;
      if (length < shortest_tracking_step) return std::nullopt;
    }
  }
  return contracted(slice_.at(to), now, values_at(to), tracking_contractions);
}

// With a box about both ends, for all lengths between.
std::optional<Box> SolutionTracker::step(const Box& box, const Lengths& from, const Lengths& to) const {
  const StrutSlice there = slice_.at(to);
  const Angles end = approximated(there, box, to);
  Box about = box;
  double longest = least_tracking_box;
  for (std::size_t i = 0; i < 2; ++i) {
    about.lower[i] = std::min(box.lower[i], end[i]);
    about.upper[i] = std::max(box.upper[i], end[i]);
    longest = std::max(longest, about.width(i));
  }
  if (!(longest < longest_tracking_step)) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i) {
    about.lower[i] -= tracking_inflation * longest;
    about.upper[i] += tracking_inflation * longest;
  }
  const PairOverBox pair = slice_.dimension() == 2 ? pair_between(slice_, about, from, to)
                                                   : pair_in_family(slice_, about, from, to);
  if (krawczyk_test(about, pair).zeros != Zeros::one) return std::nullopt;
  return contracted(there, about, values_at(to), 1);
}

Angles SolutionTracker::approximated(const StrutSlice& slice, const Box& box, const Lengths& lengths) {
  Angles x{box.center(0), box.center(1)};
  for (int k = 0; k < newton_steps; ++k) {
    const SliceTurns turns(x);
    const auto g0 = slice.half_square<1>(0, turns), g1 = slice.half_square<1>(1, turns);
    const double f0 = middle_of(g0.value()) - 0.5 * lengths[0] * lengths[0];
    const double f1 = middle_of(g1.value()) - 0.5 * lengths[1] * lengths[1];
    const double a = middle_of(g0.at(1, 0)), b = middle_of(g0.at(0, 1));
    const double c = middle_of(g1.at(1, 0)), d = middle_of(g1.at(0, 1));
    const double scale = 1.0 / (middle_of(pi_enclosure()) * (a * d - b * c));
    const Angles move{scale * (d * f0 - b * f1), scale * (a * f1 - c * f0)};
    if (!(std::abs(move[0]) + std::abs(move[1]) < 0.5)) break;
    x = {x[0] - move[0], x[1] - move[1]};
    if (std::abs(move[0]) + std::abs(move[1]) < least_tracking_box) break;
  }
  return x;
}

std::optional<std::size_t> SolutionTracker::find(const Box& box, const std::vector<Box>& boxes) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!meet_up_to_turns(box, boxes[k])) continue;
    if (found) return std::nullopt;
    found = k;
  }
  return found;
}

}  // namespace parallel_aspects
