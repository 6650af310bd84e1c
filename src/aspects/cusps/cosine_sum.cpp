// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cosine_sum.h"

#include "model/angles.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

// Within a full turn of zero, for `turn_of_half_turns`.
Interval without_turns(const Interval& angle) noexcept {
  const double middle = 0.5 * (angle.lower() + angle.upper());
  if (middle > 1.0) return angle - Interval(2.0);
  return middle < -1.0 ? angle + Interval(2.0) : angle;
}

}  // namespace

SliceTurns::SliceTurns(const SliceRanges& at, SliceSums sums) noexcept
    : direction(turn_of_half_turns(at[0])),
      phi(turn_of_half_turns(at[1])),
      difference(turn_of_half_turns(without_turns(at[1] - at[0]))) {
  if (sums == SliceSums::yes) sum = turn_of_half_turns(without_turns(at[1] + at[0]));
}

SliceTurns::SliceTurns(const std::array<double, 2>& at) noexcept
    : direction(enclosed_turn(pi * at[0])),
      phi(enclosed_turn(pi * at[1])),
      difference{phi.cosine * direction.cosine + phi.sine * direction.sine,
                 phi.sine * direction.cosine - phi.cosine * direction.sine},
      sum{phi.cosine * direction.cosine - phi.sine * direction.sine,
          phi.sine * direction.cosine + phi.cosine * direction.sine} {}

// |r + v + o|^2 = |r|^2 + |v|^2 + |o|^2 + 2 (r.v + r.o + v.o).
CosineSum CosineSum::half_square(const Interval& length, const Planar<Interval>& m, const Planar<Interval>& o,
                                 const Interval& squared_height) noexcept {
  const Interval squares = square(length) + squared_norm(m) + squared_norm(o);
  return {Interval(0.5) * (squares + squared_height),
          {length * m.x, -(length * m.y)},
          {length * o.x, length * o.y},
          {m.x * o.x + m.y * o.y, m.x * o.y - m.y * o.x}};
}

CosineSum CosineSum::half_square_slope(const Interval& length, const Planar<Interval>& m,
                                       const Planar<Interval>& o) noexcept {
  return {length, {m.x, -m.y}, {o.x, o.y}, {0.0, 0.0}};
}

CosineSum CosineSum::along(const Planar<Interval>& n, const Interval& length, const Planar<Interval>& m,
                           const Planar<Interval>& o) noexcept {
  return {n.x * o.x + n.y * o.y,
          {0.0, 0.0},
          {length * n.x, length * n.y},
          {m.x * n.x + m.y * n.y, m.x * n.y - m.y * n.x}};
}

CosineSum operator*(const Interval& factor, const CosineSum& sum) noexcept {
  const auto scaled = [&factor](const Planar<Interval>& m) {
    return Planar<Interval>{factor * m.x, factor * m.y};
  };
  CosineSum result{factor * sum.constant, scaled(sum.of_difference), scaled(sum.of_direction),
                   scaled(sum.of_phi)};
  if (sum.of_sum) result.of_sum = scaled(*sum.of_sum);
  return result;
}

SliceCenter::SliceCenter(const Box& box) noexcept {
  for (std::size_t i = 0; i < 2; ++i) {
    at[i] = box.center(i);
    const double half = std::max(box.upper[i] - box.center(i), box.center(i) - box.lower[i]);
    half_widths[i] = (pi_enclosure() * Interval(half)).upper();
  }
  if (box.dimension < 3) return;
  rod = box.center(2);
  half_widths[2] = std::max(box.upper[2] - rod, rod - box.lower[2]);
}

SliceRanges ranges_of(const Box& box) noexcept {
  return {Interval(box.lower[0], box.upper[0]), Interval(box.lower[1], box.upper[1])};
}

std::array<Box, 2> halves_of(const Box& box) noexcept {
  const std::size_t axis = box.width(0) >= box.width(1) ? 0 : 1;
  std::array<Box, 2> halves{box, box};
  halves[0].upper[axis] = halves[1].lower[axis] = box.center(axis);
  return halves;
}

}  // namespace parallel_aspects
