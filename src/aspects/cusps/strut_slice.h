// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_STRUT_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_STRUT_SLICE_H

#include "aspects/cusps/jet.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "legs/planar_leg.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cmath>
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

  /// The derivative of `half_square` by the length.
  static CosineSum half_square_slope(const Interval& length, const Planar<Interval>& between_anchors,
                                     const Planar<Interval>& o) noexcept;

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

/// Lengths of struts: those of functions 0 and 1, then that which is held [m].
using Lengths = std::array<double, 3>;

/// A 3-RPR with the length of one strut held: the other two lengths rho_i as functions of the slice.
///
/// With r the rod that is held, v = R(phi) (b_i - b_h) between the anchors and o = c_h - c_i between the base
/// points, the rod of leg i is r + v + o, and
///
///     g_i = rho_i^2 / 2 = K + r.v + r.o + v.o,
///
/// a sum of three cosines, of phi - a, a and phi. All poses of the robot are a family of such slices, over
/// the length of r, by which g_i is a polynomial of degree two. All of it needs a live `RoundingUpward`.
class StrutSlice {
 public:
  /// Of a slice that holds a strut, of three; see `find_uniqueness_problem`.
  StrutSlice(const Manipulator& manipulator, const MapSlice& slice);

  /// Of all slices that hold this leg, within its limits: the family.
  StrutSlice(const Manipulator& manipulator, std::size_t held);

  /// 2 of one slice, 3 of a family.
  std::size_t dimension() const noexcept { return dimension_; }

  /// Direction of the held rod and phi [half turns]; of a family its length in the plane, too [m].
  Box whole() const noexcept;

  /// Index of the leg that function i, 0 or 1, belongs to; that is held, of 2.
  std::size_t leg(std::size_t i) const noexcept { return i < 2 ? legs_[i].index : held_; }

  /// The slices of the family where the held rod has such a length in the plane [m].
  StrutSlice with_rod(const Interval& rod) const noexcept;

  /// The same with half the square of the length of its strut [m^2].
  StrutSlice with_half_square(const Interval& value) const noexcept;

  /// The slice of these lengths: of one slice itself.
  StrutSlice at(const Lengths& lengths) const noexcept;

  /// The slices that a box lies in: of one slice itself.
  StrutSlice over(const Box& box) const noexcept;

  /// Of the held rod in the plane [m].
  const Interval& rod() const noexcept { return rod_; }

  /// g_i over the ranges.
  template <std::size_t Order>
  Jet<Order> half_square(std::size_t i, const SliceTurns& at) const noexcept {
    return legs_[i].half_square.template jet<Order>(at);
  }

  /// Its derivative by the rod's length. The second is 1.
  template <std::size_t Order>
  Jet<Order> slope(std::size_t i, const SliceTurns& at) const noexcept {
    return CosineSum::half_square_slope(rod_, legs_[i].between_anchors, legs_[i].between_bases)
        .template jet<Order>(at);
  }

  /// Half the square of the held strut [m^2].
  Interval held_half_square() const noexcept;

  /// No larger g_i is reached, whatever the limits. Of a strut that is held there is no such bound.
  double largest_half_square(std::size_t i) const noexcept { return i < 2 ? legs_[i].largest : HUGE_VAL; }

  /// Half the square of a strut at the shortest and at the longest that limits allow; the second is infinite
  /// where there are none.
  const std::array<Interval, 2>& limits(std::size_t i) const noexcept {
    return i < 2 ? legs_[i].limits : held_limits_;
  }

 private:
  struct MovingLeg {
    std::size_t index = 0;
    Planar<Interval> between_anchors, between_bases;
    Interval squared_height;
    CosineSum half_square;
    double largest = 0.0;
    std::array<Interval, 2> limits;

    MovingLeg() = default;
    MovingLeg(const Manipulator& manipulator, std::size_t held, std::size_t index);
    void set_rod(const Interval& rod) noexcept;
  };

  void add_legs(const Manipulator& manipulator);
  void set_rod(const Interval& rod) noexcept;

  std::size_t dimension_ = 2, held_ = 0;
  Interval rod_, held_squared_height_;
  std::array<Interval, 2> held_limits_;
  std::array<MovingLeg, 2> legs_;
};

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

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_STRUT_SLICE_H
