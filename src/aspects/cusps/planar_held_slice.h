// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_PLANAR_HELD_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_PLANAR_HELD_SLICE_H

#include "aspects/cusps/held_slice.h"
#include "legs/held_leg.h"
#include "legs/planar_leg.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

namespace parallel_aspects {

/// The slice of a robot of SE2.
///
/// With r the rod that is held and v = R(phi) (b_i - b_h), the rod of leg i is u_i = r + v + o_i, with o_i =
/// c_h - c_i(q_i). Its equation is g_i(x, q_i) = (|u_i|^2 - rho_i^2) / 2 = 0, x the coordinates of the slice.
/// At a fixed joint value it is a sum of three cosines, as of a strut, and so is its derivative by the joint
/// value where c_i moves, -u_i.c_i', and that by the value that is held, u_i.(c_h' + r').
class PlanarHeldSlice : public HeldSlice {
 public:
  PlanarHeldSlice(const Manipulator& manipulator, const HeldJoint& joint);

  /// Holds the joint in a range instead: everything is then enclosed for each value of it [m or rad]. Of a
  /// crank the range is at most a full turn. From then on `LegOver` has its `held_slope`.
  void hold(const Interval& value) noexcept;

  std::optional<LegOver> leg_over(std::size_t i, int sign, const SlicePlace& at) const noexcept override;
  LegAt leg_at(std::size_t i, const Interval& q) const noexcept override;
  Pose pose(const std::array<double, 2>& at) const override;

  /// B_jj of the leg whose joint is held, but for a positive factor, and its derivatives by the direction of
  /// the rod and by the value that is held.
  struct HeldEntry {
    Interval value, by_direction, by_held;
  };
  HeldEntry held_entry_over(const SlicePlace& at) const noexcept;

  /// B_jj^2 of leg i, 0 or 1, of a strut a number that does not vanish.
  Interval squared_b_entry(std::size_t i, const SlicePlace& at) const noexcept {
    return legs_[i].leg.form(displacement(legs_[i], at.over())).squared_b_entry;
  }

 private:
  struct MovingLeg {
    PlanarLeg leg;
    Planar<Interval> between_anchors;
    double crank_sense = 0.0;         // of turning about z; 0 where c does not turn
    Planar<Interval> rail{0.0, 0.0};  // direction of c; zero where it does not slide
    bool moves = false;               // whether c moves

    MovingLeg(const Leg& moving, const Leg& held);
    void set(const RevoluteActuation& crank);
    void set(const PrismaticActuation& slide);
    void set(const StrutActuation& strut);
    void set(const ElbowActuation& elbow);
  };

  std::optional<RodOver> rod_over(std::size_t i, int sign, const SlicePlace& at) const noexcept override;
  Verdict leg_within_limits(std::size_t i, int sign, const SlicePlace& at) const noexcept override;
  Interval held_entry(const SlicePlace& at) const noexcept override;

  Planar<Interval> displacement(const MovingLeg& leg, const SliceTurns& at) const noexcept;
  CosineSum held_slope(const MovingLeg& leg, const Planar<Interval>& o) const noexcept;

  std::shared_ptr<const Leg> held_leg_;
  AnchorCircle circle_;
  HeldLeg held_;
  bool held_is_strut_;
  bool in_range_ = false;  // whether derivatives by the value that is held are of use
  Interval length_;        // of the held rod
  std::array<MovingLeg, 2> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_PLANAR_HELD_SLICE_H
