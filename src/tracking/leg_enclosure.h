// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_LEG_ENCLOSURE_H
#define PARALLEL_ASPECTS_TRACKING_LEG_ENCLOSURE_H

#include "interval/interval.h"
#include "interval/rotation_rows.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

using IntervalVector = std::array<Interval, 3>;

/// One upper bound, or one enclosure, for each leg.
using LegBounds = std::array<double, max_legs>;

/// How anchors move with the pose, in the coordinates xi = (L w, v) of `PoseCertifier`, at every pose.
struct AnchorBounds {
  LegBounds lever{};  ///< at least |dp| over |xi|
  LegBounds bend{};   ///< at least |d^2 p| over |xi|^2
};

/// Needs a live `RoundingUpward`.
AnchorBounds anchor_bounds(const Manipulator& manipulator) noexcept;

/// A pose, enclosed. In R2 it is the one whose angles are those of the given pose to the last digit, since
/// rounded positions and quaternions are of no chain.
struct EnclosedPose {
  IntervalVector position;
  RotationRows<Interval> turn;  ///< not filled where the platform does not turn
  bool turns = false;
};

/// Needs a live `RoundingUpward`.
EnclosedPose enclosed_pose(const Motions& motions, const Pose& pose) noexcept;

/// What a leg is at a pose and a joint value, each an enclosure of the real value.
struct LegEnclosure {
  Lever<IntervalVector> lever;  ///< of the anchor [m]
  IntervalVector u;             ///< from the proximal point to the anchor [m]
  Interval half_residual;       ///< f_j / 2 [m^2]
  Interval inverse_diagonal;    ///< B_jj
};

/// A row of A with moments over the characteristic length: of numbers, or what encloses them.
template <class Scalar, class Vector>
void write_homogenised_row(TaskSpace space, const Lever<Vector>& b, const Vector& u,
                           const Scalar& over_length, std::array<Scalar, max_legs>& row) {
  write_row(space, b, u, row);
  for (std::size_t i = 0; i < rotational_degrees_of_freedom(space); ++i) row[i] = row[i] * over_length;
}

/// A leg prepared for many evaluations: c(q) = fixed + cos q first + sin q second for an actuated revolute
/// joint, and fixed + q first for a prismatic one. Sine and cosine of the C library are trusted to within
/// 2^-52, twice what its manual states.
class LegForm {
 public:
  LegForm() = default;

  /// Needs a live `RoundingUpward`, as `enclose` does.
  explicit LegForm(const Leg& leg) noexcept;

  const Eigen::Vector3d& anchor() const noexcept { return anchor_; }

  /// c(q), rounded [m].
  Eigen::Vector3d proximal_point(double q) const noexcept;

  /// rho(q)^2, rounded [m^2].
  double squared_distance(double q) const noexcept;

  LegEnclosure enclose(const EnclosedPose& pose, double q) const noexcept;

  /// The largest |B_jj| of a leg whose |u| is `rod`.
  double largest_inverse_entry(double rod) const noexcept;

  /// At least |c'| [m/rad or 1].
  double point_speed() const noexcept { return point_speed_; }

  /// At least |d^2 F / dq^2| for F = f / 2, at any pose where |u| is at most `rod` [m^2 or 1].
  double joint_curvature(double rod) const noexcept { return curvature_ + point_curvature_ * rod; }

 private:
  /// Each completes u and B_jj, which is u.c' where c moves and rho rho' where rho does, and returns rho^2.
  Interval complete(double q, LegEnclosure& leg) const noexcept;
  Interval complete_crank(double q, LegEnclosure& leg) const noexcept;
  Interval complete_slide(double q, LegEnclosure& leg) const noexcept;
  Interval complete_strut(double q, LegEnclosure& leg) const noexcept;
  Interval complete_elbow(double q, LegEnclosure& leg) const noexcept;

  void prepare(const Leg& leg, const RevoluteActuation& actuation) noexcept;
  void prepare(const Leg& leg, const PrismaticActuation& actuation) noexcept;
  void prepare(const Leg& leg, const StrutActuation& actuation) noexcept;
  void prepare(const Leg& leg, const ElbowActuation& actuation) noexcept;

  LegType type_ = LegType::strut;
  Eigen::Vector3d anchor_, fixed_, first_, second_;
  IntervalVector exact_first_, exact_second_;
  double offset_ = 0.0, sense_ = 1.0;  // of the length of a strut, or of the angle of an elbow
  Interval squared_rod_;               // of an elbow, inner^2 + outer^2
  Interval product_;                   // of an elbow, inner outer
  double point_speed_ = 0.0, curvature_ = 0.0, point_curvature_ = 0.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_LEG_ENCLOSURE_H
