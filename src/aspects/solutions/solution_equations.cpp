// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/solution_equations.h"

#include "aspects/cusps/cosine_sum.h"
#include "aspects/zeros/krawczyk.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

// Boxes that are larger are not worth Krawczyk's test, and smaller ones not worth being divided [half turns].
constexpr double largest_tested_for_zero = 0.2, smallest_with_zero = 0x1p-34;

// Its test of a somewhat larger box also proves zeros that lie on a face.
constexpr double inflation_for_zero = 1.5;
constexpr std::size_t largest_search = 20000;
constexpr int contractions_of_zero = 6;

class ZeroFinder {
 public:
  explicit ZeroFinder(const PairOver& pair_over) : pair_over_(pair_over) {}

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
  static bool may_vanish(const Box& box, const PairOverBox& pair) {
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
    if (known_.cover(box) || !may_vanish(box, pair_over_(box))) return true;
    const double width = std::max(box.width(0), box.width(1));
    if (width < largest_tested_for_zero && is_settled(scaled(box, inflation_for_zero))) return true;
    for (const Box& half : halves_of(box)) boxes_.push_back(half);
    return width > smallest_with_zero;
  }

  bool is_settled(const Box& box) {
    const ZeroSearch found = krawczyk_test(box, pair_over_(box));
    if (found.zeros != Zeros::one) return found.zeros == Zeros::none;
    return known_.note({box, contracted(pair_over_, found.enclosure, contractions_of_zero)});
  }

  const PairOver& pair_over_;
  std::vector<Box> boxes_;
  KnownZeros known_;
};

}  // namespace

Box contracted(const PairOver& pair_over, Box box, int times) {
  for (int k = 0; k < times; ++k) box = intersection(box, krawczyk_test(box, pair_over(box)).enclosure);
  return box;
}

std::optional<std::vector<Box>> find_all_zeros(const PairOver& pair_over) {
  assert_rounding_upward();
  return ZeroFinder(pair_over).run();
}

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
