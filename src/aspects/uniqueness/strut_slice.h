// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_STRUT_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_STRUT_SLICE_H

#include "aspects/uniqueness/jet.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "legs/limit_verdict.h"
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

/// A 3-RPR with the length of one strut held: the other two lengths rho_i as functions of the slice.
///
/// With r the rod that is held, v = R(phi) (b_i - b_h) between the anchors and o = c_h - c_i between the base
/// points, the rod of leg i is r + v + o, and
///
///     g_i = rho_i^2 / 2 = K + r.v + r.o + v.o,
///
/// a sum of three cosines, of phi - a, a and phi. So all derivatives are known in closed form. Derivatives
/// are by radians. All of it needs a live `RoundingUpward`.
class StrutSlice {
 public:
  /// Of a slice that holds a strut, of three; see `find_uniqueness_problem`.
  StrutSlice(const Manipulator& manipulator, const MapSlice& slice);

  /// Index of the leg that function i, 0 or 1, belongs to.
  std::size_t leg(std::size_t i) const noexcept { return legs_[i].index; }

  /// g_i over the ranges.
  template <std::size_t Order>
  Jet<Order> half_square(std::size_t i, const SliceTurns& at) const noexcept;

  /// No larger g_i is reached, whatever the limits.
  double largest_half_square(std::size_t i) const noexcept { return legs_[i].largest; }

  /// Whether the joint value of g_i, somewhere in this range, is within limits.
  Verdict within_limits(std::size_t i, const Interval& half_square) const noexcept;

  /// g_i at the shortest and at the longest that limits allow; the second is infinite where there are none.
  const std::array<Interval, 2>& limits(std::size_t i) const noexcept { return legs_[i].limits; }

 private:
  struct MovingLeg {
    std::size_t index = 0;
    Interval constant;                 // K
    Planar<Interval> between_anchors;  // rho_h (b_i - b_h)
    Planar<Interval> between_bases;    // rho_h (c_h - c_i)
    Interval along, across;            // of c_h - c_i, seen from b_i - b_h, multiplied by its length
    double largest = 0.0;
    std::array<Interval, 2> limits;

    MovingLeg() = default;
    MovingLeg(const Manipulator& manipulator, std::size_t held, std::size_t index, const Interval& length);
  };

  std::array<MovingLeg, 2> legs_;
};

template <std::size_t Order>
Jet<Order> StrutSlice::half_square(std::size_t i, const SliceTurns& at) const noexcept {
  const MovingLeg& leg = legs_[i];
  const auto &m = leg.between_anchors, &o = leg.between_bases;
  const auto &d = at.difference, &a = at.direction, &phi = at.phi;
  const Interval p = m.x * d.cosine - m.y * d.sine, p1 = -(m.x * d.sine + m.y * d.cosine);
  const Interval r = o.x * a.cosine + o.y * a.sine, r1 = o.y * a.cosine - o.x * a.sine;
  const Interval v = leg.along * phi.cosine + leg.across * phi.sine;
  const Interval v1 = leg.across * phi.cosine - leg.along * phi.sine;
  // A cosine f and its derivatives f1, -f, -f1, f, ...
  const std::array<Interval, 4> of_difference{p, p1, -p, -p1}, of_direction{r, r1, -r, -r1},
      of_phi{v, v1, -v, -v1};
  Jet<Order> g;
  for (std::size_t n = 0; n <= Order; ++n)
    for (std::size_t k = 0; k <= n; ++k) {
      const Interval& term = of_difference[n % 4];
      g.at(n - k, k) = (n - k) % 2 == 0 ? term : -term;
    }
  for (std::size_t n = 0; n <= Order; ++n) {
    g.at(n, 0) += of_direction[n % 4];
    g.at(0, n) += of_phi[n % 4];
  }
  g.at(0, 0) += leg.constant;
  return g;
}

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
