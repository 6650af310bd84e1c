// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/solution_tracker.h"

#include "aspects/solutions/all_zeros.h"
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

// A box of a solution that is widened is so much larger at each end [half turns].
constexpr double widening_margin = 1e-9;

ActuatedValues between(const ActuatedValues& from, const ActuatedValues& to, double t) {
  if (t >= 1.0) return to;
  ActuatedValues at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = from[i] + t * (to[i] - from[i]);
  return at;
}

}  // namespace

std::optional<Box> SolutionTracker::follow(const Box& box, const ActuatedValues& from,
                                           const ActuatedValues& to) const {
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
  return contracted_at(to, now, tracking_contractions);
}

// With a box about both ends, for all values between.
std::optional<Box> SolutionTracker::step(const Box& box, const ActuatedValues& from,
                                         const ActuatedValues& to) const {
  const Angles end = approximated(box, to);
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
  const auto pair = equations_.between(about, from, to);
  if (!pair || krawczyk_test(about, *pair).zeros != Zeros::one) return std::nullopt;
  return contracted_at(to, about, 1);
}

Box SolutionTracker::contracted_at(const ActuatedValues& values, const Box& box, int times) const {
  return contracted([&](const Box& over) { return equations_.at(over, values); }, box, times);
}

Angles SolutionTracker::approximated(const Box& box, const ActuatedValues& values) const {
  Angles x{box.center(0), box.center(1)};
  for (int k = 0; k < newton_steps; ++k) {
    const PairOverBox pair = equations_.at({2, {x[0], x[1], 0.0}, {x[0], x[1], 0.0}}, values);
    const double f0 = middle_of(pair.center[0]), f1 = middle_of(pair.center[1]);
    const double a = middle_of(pair.jacobian[0][0]), b = middle_of(pair.jacobian[0][1]);
    const double c = middle_of(pair.jacobian[1][0]), d = middle_of(pair.jacobian[1][1]);
    const double scale = 1.0 / (middle_of(pi_enclosure()) * (a * d - b * c));
    const Angles move{scale * (d * f0 - b * f1), scale * (a * f1 - c * f0)};
    if (!(std::abs(move[0]) + std::abs(move[1]) < 0.5)) break;
    x = {x[0] - move[0], x[1] - move[1]};
    if (std::abs(move[0]) + std::abs(move[1]) < least_tracking_box) break;
  }
  return x;
}

std::optional<Box> SolutionTracker::widened(const Box& box, const ActuatedValues& values,
                                            double slack) const {
  Box about = box;
  for (std::size_t i = 0; i < 2; ++i) {
    const double margin = widening_margin + box.width(i);
    about.lower[i] -= margin;
    about.upper[i] += margin;
  }
  if (krawczyk_test(about, equations_.about(about, values, slack)).zeros != Zeros::one) return std::nullopt;
  return about;
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
