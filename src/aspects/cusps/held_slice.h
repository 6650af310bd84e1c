// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_SLICE_H

#include "aspects/cusps/jet.h"
#include "aspects/cusps/strut_slice.h"
#include "interval/interval.h"
#include "legs/held_leg.h"
#include "legs/limit_verdict.h"
#include "legs/planar_leg.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// The signs of B_jj of both legs whose joints move.
using SlicePosture = std::array<int, 2>;

/// A robot of SE2 with three legs of any kind, the actuated joint of one of them held: the equations of both
/// others over its slice.
///
/// With r the rod that is held and v = R(phi) (b_i - b_h), the rod of leg i is u_i = r + v + o_i, with o_i =
/// c_h - c_i(q_i). Its equation is g_i(x, q_i) = (|u_i|^2 - rho_i^2) / 2 = 0, x the coordinates of the slice.
/// At a fixed joint value it is a sum of three cosines, as of a strut, and so is its derivative by the joint
/// value where c_i moves, -u_i.c_i'. All of it needs a live `RoundingUpward`.
class HeldSlice {
 public:
  HeldSlice(const Manipulator& manipulator, const MapSlice& slice);

  /// Holds the joint in a range instead: everything is then enclosed for each value of it [m or rad]. Of a
  /// crank the range is at most a full turn.
  void hold(const Interval& value) noexcept;

  /// Index of the leg that equation i, 0 or 1, belongs to.
  std::size_t leg(std::size_t i) const noexcept { return legs_[i].index; }

  /// Those that the kinds of both legs allow.
  const std::vector<SlicePosture>& postures() const noexcept { return postures_; }

  /// A leg over a box of the slice, in one posture.
  struct LegOver {
    Verdict reaches = Verdict::unknown;
    Planar<Interval> o;      ///< for poses that it reaches
    Planar<Interval> slope;  ///< -c', by the joint value
    Interval entry;          ///< B_jj where c moves; 1 where it does not
  };

  /// Nothing where the box is too large to tell.
  std::optional<LegOver> leg_over(std::size_t i, int sign, const SliceTurns& at) const noexcept;

  /// g_i at fixed joint values, but for a constant.
  template <std::size_t Order>
  Jet<Order> equation(std::size_t i, const LegOver& leg, const SliceTurns& at) const noexcept {
    return CosineSum::half_square(length_, legs_[i].between_anchors, leg.o, 0.0).template jet<Order>(at);
  }

  /// Its derivative by the joint value.
  template <std::size_t Order>
  Jet<Order> slope(std::size_t i, const LegOver& leg, const SliceTurns& at) const noexcept {
    return CosineSum::along(leg.slope, length_, legs_[i].between_anchors, leg.o).template jet<Order>(at);
  }

  /// The derivative of g_i by the value that is held, at fixed joint values: u.(c_h' + r').
  template <std::size_t Order>
  Jet<Order> held_slope(std::size_t i, const LegOver& leg, const SliceTurns& at) const noexcept {
    const Planar<Interval>&m = legs_[i].between_anchors, &c = held_.center_slope();
    if (!held_is_strut_) return CosineSum::along(c, length_, m, leg.o).template jet<Order>(at);
    const Interval factor = held_.length_slope();
    return factor * CosineSum::half_square_slope(length_, m, leg.o).template jet<Order>(at);
  }

  /// Whether the joint values are within limits.
  Verdict within_limits(const SlicePosture& posture, const SliceTurns& at) const noexcept;

  /// The sign of B_jj of the leg whose joint is held; 0 where the box is too large to tell.
  int held_sign(const SliceTurns& at) const noexcept;

 private:
  struct MovingLeg {
    std::size_t index = 0;
    PlanarLeg leg;
    Planar<Interval> between_anchors;
    double crank_sense = 0.0;         // of turning about z; 0 where c does not turn
    Planar<Interval> rail{0.0, 0.0};  // direction of c; zero where it does not slide
    std::vector<int> signs{};         // of B_jj that there are
    bool moves = false;               // whether c moves

    MovingLeg(const Leg& moving, const Leg& held, std::size_t index);
    void set(const RevoluteActuation& crank);
    void set(const PrismaticActuation& slide);
    void set(const StrutActuation& strut);
    void set(const ElbowActuation& elbow);
  };

  Planar<Interval> displacement(const MovingLeg& leg, const SliceTurns& at) const noexcept;

  Leg held_leg_;
  HeldLeg held_;
  bool held_is_strut_;
  Interval length_;              // of the held rod
  std::vector<int> held_signs_;  // of B_jj of its leg that there are
  std::vector<MovingLeg> legs_;
  std::vector<SlicePosture> postures_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_HELD_SLICE_H
