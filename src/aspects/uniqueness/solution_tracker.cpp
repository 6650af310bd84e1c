// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/solution_tracker.h"

#include "aspects/uniqueness/krawczyk.h"
#include "aspects/uniqueness/solution_search.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Lengths = std::array<double, 2>;

// Of a line, and of boxes [half turns].
constexpr double shortest_tracking_step = 0x1p-20, least_tracking_box = 1e-11;
constexpr double longest_tracking_step = 0.3;

// Boxes are longer than what solutions move by this share, at each end.
constexpr double tracking_inflation = 0.3;
constexpr int newton_steps = 5, tracking_contractions = 2;

Lengths between(const Lengths& from, const Lengths& to, double t) {
  if (t >= 1.0) return to;
  return {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])};
}

/// For all lengths between, as  ((m + t h)^2) / 2  with t from -1 to 1.
PairOverBox pair_between(const StrutSlice& slice, const Box& box, const Lengths& from, const Lengths& to) {
  std::array<Interval, 2> values, drift;
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval middle = Interval(0.5) * (Interval(from[i]) + Interval(to[i]));
    const Interval half = Interval(0.5) * (Interval(to[i]) - Interval(from[i]));
    values[i] = Interval(0.5) * (square(middle) + Interval(0.0, square(half).upper()));
    drift[i] = middle * half;
  }
  PairOverBox pair = pair_over(slice, box, values);
  pair.drift = drift;
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
  return contracted(slice_, now, values_at(to), tracking_contractions);
}

// With a box about both ends, for all lengths between.
std::optional<Box> SolutionTracker::step(const Box& box, const Lengths& from, const Lengths& to) const {
  const Lengths end = approximated(box, to);
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
  if (krawczyk_test(about, pair_between(slice_, about, from, to)).zeros != Zeros::one) return std::nullopt;
  return contracted(slice_, about, values_at(to), 1);
}

Lengths SolutionTracker::approximated(const Box& box, const Lengths& lengths) const {
  Lengths x{box.center(0), box.center(1)};
  for (int k = 0; k < newton_steps; ++k) {
    const SliceTurns turns(x);
    const auto g0 = slice_.half_square<1>(0, turns), g1 = slice_.half_square<1>(1, turns);
    const double f0 = middle_of(g0.value()) - 0.5 * lengths[0] * lengths[0];
    const double f1 = middle_of(g1.value()) - 0.5 * lengths[1] * lengths[1];
    const double a = middle_of(g0.at(1, 0)), b = middle_of(g0.at(0, 1));
    const double c = middle_of(g1.at(1, 0)), d = middle_of(g1.at(0, 1));
    const double scale = 1.0 / (middle_of(pi_enclosure()) * (a * d - b * c));
    const Lengths move{scale * (d * f0 - b * f1), scale * (a * f1 - c * f0)};
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
