// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_STRUT_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_STRUT_SLICE_H

#include "aspects/cusps/cosine_sum.h"
#include "aspects/cusps/jet.h"
#include "interval/interval.h"
#include "legs/planar_leg.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

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

/// Boxes of a slice in which no two singular poses have the same lengths: there g takes D = 0 to its image
/// one to one. It does in a box B where
///
///  - {D, t.g} does not vanish, for a fixed t. Of two poses, with v from one to the other, the mean value
///    theorem gives points of B with grad D . v = 0 and grad(t.g) . v = 0, though their determinant is not
///    zero.
///  - or B lies in one about a cusp where D vanishes on neither of two opposite edges, and its derivative
///    from one of these to the other has one sign where D = 0, which thus is a graph over the others. With w
///    a column of J and n.w > 0 the image moves along the curve by k w. There {D, n.k w} has one sign, so
///    that k has one zero at most, and w turns one way, {D, w} x w != 0. So the integral of k w from one pose
///    to another does not vanish: if the zero is between them, then what comes before it is, but for its
///    sign, a vector on one side of w there, and what comes after it one on the other.
///
/// Needs a live `RoundingUpward`.
class InjectiveBoxes {
 public:
  /// `cusps` are small boxes about those of the slice, which must outlive it.
  InjectiveBoxes(const StrutSlice& slice, const std::vector<Box>& cusps);

  /// Whether it is proved of this box.
  bool holds(const Box& box) const;

  /// The boxes about cusps of which it is proved; not every cusp has one.
  const std::vector<Box>& about_cusps() const noexcept { return about_cusps_; }

 private:
  const StrutSlice& slice_;
  std::vector<Box> about_cusps_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_STRUT_SLICE_H
