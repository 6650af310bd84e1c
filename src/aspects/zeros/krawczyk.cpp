// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/zeros/krawczyk.h"

#include "interval/half_turns.h"
#include "interval/scalar_range.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

template <std::size_t N>
using Matrix = Eigen::Matrix<double, static_cast<int>(N), static_cast<int>(N)>;

/// An approximate inverse of the middle of the derivatives; any matrix would do.
template <std::size_t N>
Matrix<N> preconditioner(const SystemOverBox<N>& system) noexcept {
  Matrix<N> middle;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < N; ++k)
      middle(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = middle_of(system.jacobian[i][k]);
  return middle.inverse();
}

/// Coordinate i of K - x [rad], from row i of Y.
template <std::size_t N>
Interval krawczyk_coordinate(const SystemOverBox<N>& system, const std::array<Interval, N>& y, std::size_t i,
                             const std::array<DistanceToFaces, N>& faces) noexcept {
  Interval at_middle, drift;
  for (std::size_t j = 0; j < N; ++j) {
    at_middle += y[j] * system.center[j];
    drift += y[j] * system.drift[j];
  }
  Interval sum = drift * Interval(-1.0, 1.0) - at_middle;
  for (std::size_t k = 0; k < N; ++k) {
    Interval deviation(i == k ? 1.0 : 0.0);
    for (std::size_t j = 0; j < N; ++j) deviation = deviation - y[j] * system.jacobian[j][k];
    sum += deviation * Interval(-faces[k].most, faces[k].most);
  }
  return sum;
}

void move_by(double turns, std::size_t angle, Box& box) noexcept {
  if (turns == 0.0) return;
  box.lower[angle] += turns - few_units;
  box.upper[angle] += turns + few_units;
}

}  // namespace

template <std::size_t N>
SystemZeros<N> krawczyk_test(const std::array<DistanceToFaces, N>& faces,
                             const SystemOverBox<N>& system) noexcept {
  assert_rounding_upward();
  const Matrix<N> y = preconditioner(system);
  if (!y.allFinite()) return {};
  SystemZeros<N> result{Zeros::one, std::array<Interval, N>{}};
  for (std::size_t i = 0; i < N; ++i) {
    std::array<Interval, N> row;
    for (std::size_t j = 0; j < N; ++j)
      row[j] = Interval(y(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    const Interval k = (*result.from_middle)[i] = krawczyk_coordinate(system, row, i, faces);
    if (!std::isfinite(k.lower()) || !std::isfinite(k.upper())) return {};
    if (k.lower() > faces[i].most || k.upper() < -faces[i].most) return {Zeros::none, std::nullopt};
    if (!(-faces[i].least < k.lower() && k.upper() < faces[i].least)) result.zeros = Zeros::unknown;
  }
  return result;
}

template SystemZeros<2> krawczyk_test(const std::array<DistanceToFaces, 2>&,
                                      const SystemOverBox<2>&) noexcept;
template SystemZeros<4> krawczyk_test(const std::array<DistanceToFaces, 4>&,
                                      const SystemOverBox<4>&) noexcept;

DistanceToFaces distance_to_faces(const Box& box, std::size_t i) noexcept {
  const Interval middle(box.center(i));
  const Interval above = pi_enclosure() * (Interval(box.upper[i]) - middle);
  const Interval below = pi_enclosure() * (middle - Interval(box.lower[i]));
  return {std::min(above.lower(), below.lower()), std::max(above.upper(), below.upper())};
}

void set_from_middle(const Interval& radians, std::size_t i, Box& box) noexcept {
  const Interval at = Interval(box.center(i)) + radians * reciprocal(pi_enclosure());
  box.lower[i] = at.lower();
  box.upper[i] = at.upper();
}

ZeroSearch krawczyk_test(const Box& box, const PairOverBox& pair) noexcept {
  const auto found = krawczyk_test<2>({distance_to_faces(box, 0), distance_to_faces(box, 1)}, pair);
  ZeroSearch result{found.zeros, box};
  if (found.from_middle)
    for (std::size_t i = 0; i < 2; ++i) set_from_middle((*found.from_middle)[i], i, result.enclosure);
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

Box hull_of(const Box& a, const Box& b) noexcept {
  Box hull = a;
  for (std::size_t i = 0; i < a.dimension; ++i) {
    hull.lower[i] = std::min(a.lower[i], b.lower[i]);
    hull.upper[i] = std::max(a.upper[i], b.upper[i]);
  }
  return hull;
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
