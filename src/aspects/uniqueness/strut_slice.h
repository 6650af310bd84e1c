// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_STRUT_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_STRUT_SLICE_H

#include "aspects/uniqueness/jet.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "legs/planar_leg.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Ranges of the two coordinates of a slice that holds a joint, the direction a of the held rod and phi [half
/// turns]. Each is periodic, by 2; a range may leave [-1, 1] by up to 1/2.
using SliceRanges = std::array<Interval, 2>;

/// What is needed of the ranges for all legs.
struct SliceTurns {
  Turn<Interval> direction, phi, difference;  ///< of a, phi and phi - a

  explicit SliceTurns(const SliceRanges& at) noexcept;

  /// Of one point [half turns].
  explicit SliceTurns(const std::array<double, 2>& at) noexcept;
};

/// K + m.(c, s)(phi - a) + o.(c, s)(a) + w.(c, s)(phi), a sum of three cosines, of which all derivatives are
/// known in closed form. It is what a scalar product of r + v + o, or its square, is, where r is the rod that
/// is held and v turns with the platform.
struct CosineSum {
  Interval constant;
  Planar<Interval> of_difference, of_direction, of_phi;

  /// (|r + v + o|^2 + squared_height) / 2 with r of that length, v = R(phi) `between_anchors` and a constant
  /// o.
  static CosineSum half_square(const Interval& length, const Planar<Interval>& between_anchors,
                               const Planar<Interval>& o, const Interval& squared_height) noexcept;

  /// n.(r + v + o), of a constant n.
  static CosineSum along(const Planar<Interval>& n, const Interval& length,
                         const Planar<Interval>& between_anchors, const Planar<Interval>& o) noexcept;

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
  return g;
}

/// A 3-RPR with the length of one strut held: the other two lengths rho_i as functions of the slice.
///
/// With r the rod that is held, v = R(phi) (b_i - b_h) between the anchors and o = c_h - c_i between the base
/// points, the rod of leg i is r + v + o, and
///
///     g_i = rho_i^2 / 2 = K + r.v + r.o + v.o,
///
/// a sum of three cosines, of phi - a, a and phi. All of it needs a live `RoundingUpward`.
class StrutSlice {
 public:
  /// Of a slice that holds a strut, of three; see `find_uniqueness_problem`.
  StrutSlice(const Manipulator& manipulator, const MapSlice& slice);

  /// Index of the leg that function i, 0 or 1, belongs to.
  std::size_t leg(std::size_t i) const noexcept { return legs_[i].index; }

  /// g_i over the ranges.
  template <std::size_t Order>
  Jet<Order> half_square(std::size_t i, const SliceTurns& at) const noexcept {
    return legs_[i].half_square.template jet<Order>(at);
  }

  /// No larger g_i is reached, whatever the limits.
  double largest_half_square(std::size_t i) const noexcept { return legs_[i].largest; }

  /// g_i at the shortest and at the longest that limits allow; the second is infinite where there are none.
  const std::array<Interval, 2>& limits(std::size_t i) const noexcept { return legs_[i].limits; }

 private:
  struct MovingLeg {
    std::size_t index = 0;
    CosineSum half_square;
    double largest = 0.0;
    std::array<Interval, 2> limits;

    MovingLeg() = default;
    MovingLeg(const Manipulator& manipulator, std::size_t held, std::size_t index, const Interval& length);
  };

  std::array<MovingLeg, 2> legs_;
};

/// The middle of a box of a slice [half turns], and half its widths [rad], rounded upward.
struct SliceCenter {
  std::array<double, 2> at;
  std::array<double, 2> half_widths;

  explicit SliceCenter(const Box& box) noexcept;

  /// How far a point of the box is from its middle along a coordinate [rad].
  Interval offset(std::size_t i) const noexcept { return {-half_widths[i], half_widths[i]}; }
};

SliceRanges ranges_of(const Box& box) noexcept;

/// The whole slice.
inline Box whole_slice() noexcept { return Box{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}}; }

/// The halves of a box of a slice, divided along its longer edge.
std::array<Box, 2> halves_of(const Box& box) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_STRUT_SLICE_H
