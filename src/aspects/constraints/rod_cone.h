// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_ROD_CONE_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_ROD_CONE_H

#include "interval/interval.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// A cone that a rod must not leave (see BallJointCone), with its constants enclosed in intervals. Must be
/// made under a live `RoundingUpward`.
template <std::size_t D>
class RodCone {
 public:
  RodCone(const BallJointCone& cone, const Leg& leg) : at_platform_(cone.end == LegEnd::platform) {
    assert_rounding_upward();
    Interval squared_length(0.0);
    for (std::size_t i = 0; i < D; ++i) {
      axis_[i] = Interval(cone.axis[static_cast<Eigen::Index>(i)]);
      squared_length += square(axis_[i]);
    }
    least_ = square_root(squared_length) * enclosed_turn(cone.angle).cosine;
    const RevoluteActuation* crank = leg.crank();
    if (crank == nullptr || at_platform_) return;
    on_crank_ = true;
    for (std::size_t i = 0; i < 3; ++i)
      turning_axis_[i] = Interval(crank->axis[static_cast<Eigen::Index>(i)]);
    over_crank_ = reciprocal(Interval(crank->radius));
  }

  /// u.axis - |u| |axis| cos(angle), which is positive in the cone. `robot` turns what is fixed in the
  /// platform.
  template <class Scalar, class Robot>
  Scalar function(const LinkPoints<Scalar, D>& points, const Robot& robot) const {
    const Point<Scalar, D> rod = points.anchor - points.joint;
    const Point<Scalar, D> axis = at_platform_ ? robot.turned(axis_)
                                  : on_crank_  ? seen_from_base(points.joint - points.base)
                                               : constant<Scalar>(axis_);
    Scalar along = rod[0] * axis[0];
    for (std::size_t i = 1; i < D; ++i) along = along + rod[i] * axis[i];
    return along - least_ * points.length;
  }

 private:
  /// Of an axis that is fixed in the crank, which reaches from its joint to there.
  template <class Scalar>
  Point<Scalar, D> seen_from_base(const Point<Scalar, D>& crank) const {
    const Point<Scalar, D> side = turned_aside(crank);
    Point<Scalar, D> result;
    for (std::size_t i = 0; i < D; ++i) {
      result[i] = over_crank_ * (axis_[0] * crank[i] + axis_[1] * side[i]);
      if constexpr (D == 3) result[i] = result[i] + Scalar(axis_[2] * turning_axis_[i]);
    }
    return result;
  }

  /// By a right angle about the axis of the crank's joint.
  template <class Scalar>
  Point<Scalar, D> turned_aside(const Point<Scalar, D>& crank) const {
    const std::array<Interval, 3>& z = turning_axis_;
    if constexpr (D == 2) {
      return {-(z[2] * crank[1]), z[2] * crank[0]};
    } else {
      return {z[1] * crank[2] - z[2] * crank[1], z[2] * crank[0] - z[0] * crank[2],
              z[0] * crank[1] - z[1] * crank[0]};
    }
  }

  bool at_platform_;
  bool on_crank_ = false;
  Point<Interval, D> axis_;
  Interval least_;                        // of the share of |u| that is along the axis
  std::array<Interval, 3> turning_axis_;  // of the crank
  Interval over_crank_;                   // 1 / length of the crank
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_ROD_CONE_H
