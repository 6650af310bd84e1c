// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/plane_slab.h"

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

}  // namespace

LinearOverCell::LinearOverCell(const Box& cell, const std::array<double, 2>& normal) noexcept {
  Interval sum;
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval n(normal[i]), middle(cell.center(i)), half(-half_width(cell, i), half_width(cell, i));
    slope[i] = normal[i] * cell.center(i);
    sum += n * square(middle) + Interval(2.0) * (n * middle - Interval(slope[i])) * half + n * square(half);
  }
  rest = Interval(0.5) * sum;
}

Interval linear_at(const Box& cell, const std::array<double, 2>& slope,
                   const std::array<double, 2>& at) noexcept {
  Interval sum;
  for (std::size_t i = 0; i < 2; ++i)
    sum += Interval(slope[i]) * (Interval(at[i]) - Interval(cell.center(i)));
  return sum;
}

Interval area_of(const Box& cell) noexcept {
  return (Interval(cell.upper[0]) - Interval(cell.lower[0])) *
         (Interval(cell.upper[1]) - Interval(cell.lower[1]));
}

Interval area_beside(const Box& cell, const std::array<double, 2>& slope, const Interval& slab,
                     int side) noexcept {
  Interval p = absolute(Interval(slope[0])) * Interval(half_width(cell, 0));
  Interval q = absolute(Interval(slope[1])) * Interval(half_width(cell, 1));
  if (p.lower() < q.lower()) std::swap(p, q);
  const Interval t = side < 0 ? Interval(slab.lower()) : -Interval(slab.upper());
  return area_of(cell) * share_below(p, q, t);
}

double unknown_area(const Box& cell, const std::array<double, 2>& slope, const Interval& slab) noexcept {
  const Interval known = area_beside(cell, slope, slab, -1) + area_beside(cell, slope, slab, 1);
  return std::max(0.0, (area_of(cell) - Interval(known.lower())).upper());
}

// Two thirds of the way to the corner that is farthest out; of a wide piece that is well inside.
std::array<double, 2> point_beside(const Box& cell, const std::array<double, 2>& slope, const Interval& slab,
                                   int side) noexcept {
  const auto corner = [&](std::size_t i) {
    return (slope[i] > 0.0) == (side > 0) ? cell.upper[i] : cell.lower[i];
  };
  std::array<double, 2> best{corner(0), corner(1)};
  for (const double share : {0.5, 0.75, 0.9}) {
    const std::array<double, 2> at{cell.center(0) + share * (corner(0) - cell.center(0)),
                                   cell.center(1) + share * (corner(1) - cell.center(1))};
    const Interval value = linear_at(cell, slope, at);
    const double beyond = side < 0 ? slab.lower() - value.upper() : value.lower() - slab.upper();
    const Interval out = linear_at(cell, slope, {corner(0), corner(1)});
    const double room = side < 0 ? slab.lower() - out.lower() : out.upper() - slab.upper();
    if (beyond > 0.5 * room) return at;
  }
  return best;
}

}  // namespace parallel_aspects
