// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_SPHERICAL_HELD_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_SPHERICAL_HELD_SLICE_H

#include "aspects/cusps/cosine_sum.h"
#include "aspects/cusps/held_slice.h"
#include "interval/dual.h"
#include "interval/interval.h"
#include "interval/rotation_rows.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>

namespace parallel_aspects {

/// The orientations of SO3 where the anchor b of a leg has its distance from a proximal point c that is held.
///
/// Then the angle gamma between c and R b is known, and with orthonormal frames E, whose third axis is along
/// c, and F, whose third axis is along b,
///
///     R = E Rz(a) Ry(gamma) Rz(phi) F^T,
///
/// a torus in a and phi where sin(gamma) > 0. All of it needs a live `RoundingUpward`.
class HeldOrientations {
 public:
  HeldOrientations(const Leg& leg, double q);

  /// m.(R b), of constants.
  CosineSum along(const Spatial<Interval>& m, const Spatial<Interval>& b) const noexcept;

  /// B_jj of the leg where its joint moves c, else zero.
  CosineSum held_entry() const noexcept;

  /// Of a point [half turns], rounded.
  Pose pose(const std::array<double, 2>& at) const;

 private:
  RotationRows<Interval> base_, platform_;  // axes of E and of F
  Interval cosine_, sine_;                  // of gamma
  Spatial<Interval> anchor_, slope_;        // b and c'
  Interval along_slope_;                    // c.c'
};

/// The slice of a robot of SO3, in the coordinates of `HeldOrientations`.
///
/// With p_i = R b_i the equation of leg i is g_i(x, q_i) = (|p_i - c_i(q_i)|^2 - rho_i^2) / 2 = 0, at a fixed
/// joint value a constant less p_i.c_i, a sum of four cosines; so is its derivative by the joint value where
/// c_i moves, (c_i - p_i).c_i'.
///
/// Over a box p_i, B_ii^2 and, away from serial singularities, c_i are enclosed by their values in the middle
/// and by slopes: c_i moves by c_i' q_x with q_x = g_x / B_ii. Without slopes of c_i the search takes 1.8
/// times the processor time.
class SphericalHeldSlice : public HeldSlice {
 public:
  SphericalHeldSlice(const Manipulator& manipulator, const HeldJoint& joint);

  std::optional<LegOver> leg_over(std::size_t i, int sign, const SlicePlace& at) const noexcept override;
  LegAt leg_at(std::size_t i, const Interval& q) const noexcept override;
  Pose pose(const std::array<double, 2>& at) const override { return orientations_.pose(at); }

 private:
  /// A leg over a box, on whichever branch.
  struct Reach {
    Spatial<Dual<2, Interval>> displacement;   // of the anchor from the base point
    Spatial<Interval> range, center;           // of the displacement, in the box and in its middle
    Interval squared_b_entry, squared_center;  // B_jj^2 there
  };

  struct MovingLeg {
    SpatialLeg leg;
    Spatial<Interval> anchor;                // in the platform
    std::array<CosineSum, 3> displacement;   // of the anchor from the base point
    Spatial<Interval> crank_axis{}, rail{};  // how c moves; zero where it does not
    bool moves = false;                      // whether c moves

    MovingLeg(const Leg& moving, const HeldOrientations& orientations);
    void set(const RevoluteActuation& crank);
    void set(const PrismaticActuation& slide);
    void set(const StrutActuation& strut);
    void set(const ElbowActuation& elbow);

    Reach reach(const SlicePlace& at) const noexcept;

    /// Nothing where the box is too large to decide.
    std::optional<Spatial<Interval>> proximal_point(const Reach& reach, int sign,
                                                    const SliceCenter& middle) const noexcept;

    /// c', of this c.
    Spatial<Interval> joint_slope(const Spatial<Interval>& c) const noexcept;
  };

  std::optional<RodOver> rod_over(std::size_t i, int sign, const SlicePlace& at) const noexcept override;
  Verdict leg_within_limits(std::size_t i, int sign, const SlicePlace& at) const noexcept override;
  Interval held_entry(const SlicePlace& at) const noexcept override;

  HeldOrientations orientations_;
  CosineSum held_entry_;
  std::array<MovingLeg, 2> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_SPHERICAL_HELD_SLICE_H
