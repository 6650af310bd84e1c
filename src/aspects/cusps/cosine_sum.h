// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_COSINE_SUM_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_COSINE_SUM_H

#include "aspects/cusps/jet.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "legs/planar_leg.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Ranges of the two coordinates of a slice that holds a joint [half turns]: in SE2 the direction a of the
/// held rod and phi, in SO3 those of `HeldOrientations`. Each is periodic, by 2; a range may leave [-1, 1] by
/// up to 1/2.
using SliceRanges = std::array<Interval, 2>;

/// Whether phi + a is needed, too.
enum class SliceSums { no, yes };

inline bool may_vanish(const Interval& value) noexcept { return !value.positive() && !value.negative(); }

/// What is needed of the ranges for all legs.
struct SliceTurns {
  Turn<Interval> direction, phi, difference;  ///< of a, phi and phi - a
  Turn<Interval> sum;                         ///< of phi + a where it is needed

  explicit SliceTurns(const SliceRanges& at, SliceSums sums = SliceSums::no) noexcept;

  /// Of one point [half turns].
  explicit SliceTurns(const std::array<double, 2>& at) noexcept;
};

/// K + m.(c, s)(phi - a) + o.(c, s)(a) + w.(c, s)(phi) + n.(c, s)(phi + a), a sum of cosines, of which all
/// derivatives are known in closed form. In SE2 a scalar product of r + v + o, or its square, is such a sum
/// without the last term, where r is the rod that is held and v turns with the platform.
struct CosineSum {
  Interval constant;
  Planar<Interval> of_difference, of_direction, of_phi;
  std::optional<Planar<Interval>> of_sum{};

  /// (|r + v + o|^2 + squared_height) / 2 with r of that length, v = R(phi) `between_anchors` and a constant
  /// o.
  static CosineSum half_square(const Interval& length, const Planar<Interval>& between_anchors,
                               const Planar<Interval>& o, const Interval& squared_height) noexcept;

  /// The derivative of `half_square` by the length.
  static CosineSum half_square_slope(const Interval& length, const Planar<Interval>& between_anchors,
                                     const Planar<Interval>& o) noexcept;

  /// n.(r + v + o), of a constant n.
  static CosineSum along(const Planar<Interval>& n, const Interval& length,
                         const Planar<Interval>& between_anchors, const Planar<Interval>& o) noexcept;

  friend CosineSum operator*(const Interval& factor, const CosineSum& sum) noexcept;

  /// Derivatives are by radians. Needs a live `RoundingUpward`.
  template <std::size_t Order>
  Jet<Order> jet(const SliceTurns& at) const noexcept;
};

template <std::size_t Order>
Jet<Order> CosineSum::jet(const SliceTurns& at) const noexcept {
  // A cosine f and its derivatives f1, -f, -f1, f, ...
  const auto cycle = [](const Planar<Interval>& m, const Turn<Interval>& turn) {
    const Interval f = m.x * turn.cosine + m.y * turn.sine, f1 = m.y * turn.cosine - m.x * turn.sine;
    return std::array<Interval, 4>{f, f1, -f, -f1};
  };
  const auto difference = cycle(of_difference, at.difference), direction = cycle(of_direction, at.direction),
             turn = cycle(of_phi, at.phi);
  Jet<Order> g;
  for (std::size_t n = 0; n <= Order; ++n)
    for (std::size_t k = 0; k <= n; ++k) {
      const Interval& term = difference[n % 4];
      g.at(n - k, k) = (n - k) % 2 == 0 ? term : -term;
    }
  for (std::size_t n = 0; n <= Order; ++n) {
    g.at(n, 0) += direction[n % 4];
    g.at(0, n) += turn[n % 4];
  }
  g.at(0, 0) += constant;
  if (!of_sum) return g;
  const auto sum = cycle(*of_sum, at.sum);
  for (std::size_t n = 0; n <= Order; ++n)
    for (std::size_t k = 0; k <= n; ++k) g.at(n - k, k) += sum[n % 4];
  return g;
}

/// The middle of a box of a slice [half turns], and half its widths [rad], rounded upward; of a family that
/// of the rod, too [m].
struct SliceCenter {
  std::array<double, 2> at;
  double rod = 0.0;
  std::array<double, 3> half_widths{};

  explicit SliceCenter(const Box& box) noexcept;

  /// How far a point of the box is from its middle along a coordinate [rad, or m of the rod].
  Interval offset(std::size_t i) const noexcept { return {-half_widths[i], half_widths[i]}; }
};

SliceRanges ranges_of(const Box& box) noexcept;

/// The whole slice.
inline Box whole_slice() noexcept { return Box{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}}; }

/// The halves of a box of a slice, divided along its longer edge.
std::array<Box, 2> halves_of(const Box& box) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_COSINE_SUM_H
