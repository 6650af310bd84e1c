// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/cell_slab.h"

#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

/// At least half the width.
double half_width(const Box& cell, std::size_t i) noexcept {
  return std::max(cell.upper[i] - cell.center(i), cell.center(i) - cell.lower[i]);
}

Interval cube(const Interval& a) noexcept { return a * square(a); }

/// The share of the square from -1 to 1 where  p x + q y < t,  p >= q >= 0.
Interval share_below(const Interval& p, const Interval& q, const Interval& t) noexcept {
  const Interval from_start = t + p + q, from_end = p + q - t;
  if (from_start.upper() <= 0.0) return 0.0;
  if (from_end.upper() <= 0.0) return 1.0;
  const auto corner = [&](const Interval& x) {
    return square(not_negative_part(x)) * reciprocal(Interval(8.0) * p * q);
  };
  const bool q_counts = (p * q).lower() > 0.0;
  if (q_counts && from_start.upper() <= (Interval(2.0) * q).lower()) return corner(from_start);
  if (q_counts && from_end.upper() <= (Interval(2.0) * q).lower()) return Interval(1.0) - corner(from_end);
  if (!p.positive()) return {0.0, 1.0};
  // Between the corners it is linear. In a corner it is off from that by q / (2 p) at most.
  const Interval twice_q = Interval(2.0) * q;
  const bool between = from_start.lower() >= twice_q.upper() && from_end.lower() >= twice_q.upper();
  const Interval half_over_p = Interval(0.5) * reciprocal(p);
  const double off = between ? 0.0 : (q * half_over_p).upper();
  const Interval share = t * half_over_p + Interval(0.5) + Interval(-off, off);
  return {std::max(0.0, share.lower()), std::min(1.0, share.upper())};
}

/// The same of the cube, with  p x + q y + r z < t,  p >= q >= r >= 0: an alternating sum of cubes over its
/// corners, which is inexact where q and r are small; and by the square, with r z as a part of t.
Interval share_below(const Interval& p, const Interval& q, const Interval& r, const Interval& t) noexcept {
  const Interval bounds{share_below(p, q, t - r).lower(), share_below(p, q, t + r).upper()};
  const Interval product = Interval(48.0) * p * q * r;
  if (!product.positive()) return bounds;
  Interval sum;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const bool x = (corner & 1U) != 0, y = (corner & 2U) != 0, z = (corner & 4U) != 0;
    const Interval from = t + (x ? -p : p) + (y ? -q : q) + (z ? -r : r);
    const Interval term = cube(not_negative_part(from));
    sum += (x != y) != z ? -term : term;
  }
  return intersection(bounds, sum * reciprocal(product));
}

}  // namespace

LinearOverCell::LinearOverCell(const Box& cell, const std::array<double, 3>& normal) noexcept {
  Interval sum;
  for (std::size_t i = 0; i < cell.dimension; ++i) {
    const Interval n(normal[i]), middle(cell.center(i)), half(-half_width(cell, i), half_width(cell, i));
    slope[i] = normal[i] * cell.center(i);
    sum += n * square(middle) + Interval(2.0) * (n * middle - Interval(slope[i])) * half + n * square(half);
  }
  rest = Interval(0.5) * sum;
}

Interval linear_at(const Box& cell, const std::array<double, 3>& slope,
                   const std::array<double, 3>& at) noexcept {
  Interval sum;
  for (std::size_t i = 0; i < cell.dimension; ++i)
    sum += Interval(slope[i]) * (Interval(at[i]) - Interval(cell.center(i)));
  return sum;
}

Interval measure_of(const Box& cell) noexcept {
  Interval product(1.0);
  for (std::size_t i = 0; i < cell.dimension; ++i)
    product = product * (Interval(cell.upper[i]) - Interval(cell.lower[i]));
  return product;
}

Interval measure_beside(const Box& cell, const std::array<double, 3>& slope, const Interval& slab,
                        int side) noexcept {
  std::array<Interval, 3> reach;  // falling
  for (std::size_t i = 0; i < cell.dimension; ++i)
    reach[i] = absolute(Interval(slope[i])) * Interval(half_width(cell, i));
  std::sort(reach.begin(), reach.end(),
            [](const Interval& a, const Interval& b) { return a.lower() > b.lower(); });
  const auto& [p, q, r] = reach;
  const Interval t = side < 0 ? Interval(slab.lower()) : -Interval(slab.upper());
  return measure_of(cell) * (cell.dimension == 2 ? share_below(p, q, t) : share_below(p, q, r, t));
}

double unknown_measure(const Box& cell, const std::array<double, 3>& slope, const Interval& slab) noexcept {
  const Interval known = measure_beside(cell, slope, slab, -1) + measure_beside(cell, slope, slab, 1);
  return std::max(0.0, (measure_of(cell) - Interval(known.lower())).upper());
}

// Two thirds of the way to the corner that is farthest out; of a wide piece that is well inside.
std::array<double, 3> point_beside(const Box& cell, const std::array<double, 3>& slope, const Interval& slab,
                                   int side) noexcept {
  const std::array<double, 3> middle = cell.middle();
  std::array<double, 3> corner{};
  for (std::size_t i = 0; i < cell.dimension; ++i)
    corner[i] = (slope[i] > 0.0) == (side > 0) ? cell.upper[i] : cell.lower[i];
  const Interval out = linear_at(cell, slope, corner);
  for (const double share : {0.5, 0.75, 0.9}) {
    std::array<double, 3> at{};
    for (std::size_t i = 0; i < cell.dimension; ++i) at[i] = middle[i] + share * (corner[i] - middle[i]);
    const Interval value = linear_at(cell, slope, at);
    const double beyond = side < 0 ? slab.lower() - value.upper() : value.lower() - slab.upper();
    const double room = side < 0 ? slab.lower() - out.lower() : out.upper() - slab.upper();
    if (beyond > 0.5 * room) return at;
  }
  return corner;
}

}  // namespace parallel_aspects
