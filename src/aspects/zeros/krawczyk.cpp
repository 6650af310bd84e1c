// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/zeros/krawczyk.h"

#include "interval/half_turns.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {
namespace {

using Matrix = std::array<std::array<double, 2>, 2>;

/// An approximate inverse of the middle of the derivatives; any matrix would do.
std::optional<Matrix> preconditioner(const PairOverBox& pair) noexcept {
  const double a = middle_of(pair.jacobian[0][0]), b = middle_of(pair.jacobian[0][1]);
  const double c = middle_of(pair.jacobian[1][0]), d = middle_of(pair.jacobian[1][1]);
  const double determinant = a * d - b * c;
  const Matrix y{{{d / determinant, -b / determinant}, {-c / determinant, a / determinant}}};
  for (const auto& row : y)
    for (const double each : row)
      if (!std::isfinite(each)) return std::nullopt;
  return y;
}

/// Coordinate i of K - x [rad], where X - x is from -half to half.
Interval krawczyk_coordinate(const PairOverBox& pair, const std::array<double, 2>& y, std::size_t i,
                             const std::array<double, 2>& half) noexcept {
  Interval sum = -(Interval(y[0]) * pair.center[0] + Interval(y[1]) * pair.center[1]);
  sum += (Interval(y[0]) * pair.drift[0] + Interval(y[1]) * pair.drift[1]) * Interval(-1.0, 1.0);
  for (std::size_t k = 0; k < 2; ++k) {
    const Interval product = Interval(y[0]) * pair.jacobian[0][k] + Interval(y[1]) * pair.jacobian[1][k];
    const Interval deviation = Interval(i == k ? 1.0 : 0.0) - product;
    sum += deviation * Interval(-half[k], half[k]);
  }
  return sum;
}

void move_by(double turns, std::size_t angle, Box& box) noexcept {
  if (turns == 0.0) return;
  box.lower[angle] += turns - few_units;
  box.upper[angle] += turns + few_units;
}

}  // namespace

ZeroSearch krawczyk_test(const Box& box, const PairOverBox& pair) noexcept {
  assert_rounding_upward();
  const auto y = preconditioner(pair);
  if (!y) return {Zeros::unknown, box};
  std::array<double, 2> half, least;  // the middle is at most and at least this far from the faces [rad]
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval middle(box.center(i));
    const Interval above = pi_enclosure() * (Interval(box.upper[i]) - middle);
    const Interval below = pi_enclosure() * (middle - Interval(box.lower[i]));
    half[i] = std::max(above.upper(), below.upper());
    least[i] = std::min(above.lower(), below.lower());
  }
  ZeroSearch result{Zeros::one, box};
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval k = krawczyk_coordinate(pair, (*y)[i], i, half);
    if (!std::isfinite(k.lower()) || !std::isfinite(k.upper())) return {Zeros::unknown, box};
    if (k.lower() > half[i] || k.upper() < -half[i]) return {Zeros::none, box};
    if (!(-least[i] < k.lower() && k.upper() < least[i])) result.zeros = Zeros::unknown;
    const Interval at = Interval(box.center(i)) + k * reciprocal(pi_enclosure());
    result.enclosure.lower[i] = at.lower();
    result.enclosure.upper[i] = at.upper();
  }
  return result;
}

Box intersection(const Box& a, const Box& b) noexcept {
  Box result = a;
  for (std::size_t i = 0; i < a.dimension; ++i) {
    result.lower[i] = std::max(a.lower[i], b.lower[i]);
    result.upper[i] = std::min(a.upper[i], b.upper[i]);
  }
  return result;
}

Box scaled(const Box& box, double factor) noexcept {
  Box result = box;
  for (std::size_t i = 0; i < box.dimension; ++i) {
    const double half = 0.5 * factor * box.width(i);
    result.lower[i] = box.center(i) - half;
    result.upper[i] = box.center(i) + half;
  }
  return result;
}

bool contains(const Box& outer, const Box& inner) noexcept {
  for (std::size_t i = 0; i < outer.dimension; ++i)
    if (!(outer.lower[i] <= inner.lower[i] && inner.upper[i] <= outer.upper[i])) return false;
  return true;
}

Box without_turns(Box box) noexcept {
  for (std::size_t i = 0; i < 2; ++i)
    move_by(box.center(i) > 1.0 ? -2.0 : box.center(i) < -1.0 ? 2.0 : 0.0, i, box);
  return box;
}

Box beside(const MapPoint& at, Box box) noexcept {
  for (std::size_t i = 0; i < 2; ++i) move_by(2.0 * std::round(0.5 * (at[i] - box.center(i))), i, box);
  return box;
}

// The sums are exact to a rounding that is far below the width of a box; inner ends are moved outward by it.
bool contains_up_to_turns(const Box& outer, const Box& inner) noexcept {
  for (std::size_t i = 0; i < outer.dimension; ++i) {
    bool found = false;
    for (const double turns : {0.0, 2.0, -2.0})
      found = found || (outer.lower[i] <= inner.lower[i] + turns - few_units &&
                        inner.upper[i] + turns + few_units <= outer.upper[i]);
    if (!found) return false;
  }
  return true;
}

bool meet_up_to_turns(const Box& a, const Box& b) noexcept {
  for (std::size_t i = 0; i < a.dimension; ++i) {
    bool found = false;
    for (const double turns : {0.0, 2.0, -2.0})
      found = found ||
              (a.lower[i] <= b.upper[i] + turns + few_units && b.lower[i] + turns <= a.upper[i] + few_units);
    if (!found) return false;
  }
  return true;
}

bool KnownZeros::cover(const Box& box) const noexcept {
  return std::any_of(zeros_.begin(), zeros_.end(),
                     [&](const KnownZero& each) { return contains_up_to_turns(each.unique, box); });
}

bool KnownZeros::note(const KnownZero& found) {
  for (const KnownZero& each : zeros_) {
    if (contains_up_to_turns(each.unique, found.enclosure)) return true;
    if (contains_up_to_turns(found.unique, each.enclosure)) return true;
    if (meet_up_to_turns(found.enclosure, each.enclosure)) return false;
  }
  zeros_.push_back(found);
  return true;
}

}  // namespace parallel_aspects
