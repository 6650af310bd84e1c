// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_POSE_CERTIFIER_H
#define PARALLEL_ASPECTS_TRACKING_POSE_CERTIFIER_H

#include "interval/nonsingular.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "tracking/leg_enclosure.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// An approximate direct solution (X, q) and, rounded outward, what a proof about its neighbourhood needs.
/// `PoseCertifier::evaluate` fills it from `pose` and `q`.
struct CertifiedPoint {
  Pose pose;
  JointVector q;                                    ///< [rad or m]
  SquareArray<double> inverse{};                    ///< C, about the inverse of A for twists (L w, v)
  double defect = 0.0;                              ///< at least |C A - I|
  double residual = 0.0;                            ///< at least |C F| [m]
  LegBounds rod{};                                  ///< at least |u_j| [m]
  std::array<Interval, max_legs> inverse_diagonal;  ///< B_jj
};

/// What is proved about the neighbourhood of a point: while the actuated joints move, the ball around its
/// pose holds exactly one direct solution, which moves continuously, and det A vanishes nowhere in the ball.
struct CertifiedBall {
  bool certified = false;
  double radius = 0.0;  ///< in the metric of `PoseCertifier::distance` [m]
};

/// Proves that direct solutions exist, are unique and stay off det A = 0 while actuated joints move.
///
/// Let F_j(xi, q) = f_j / 2 in exponential coordinates xi = (L w, v) about the pose, in R2 L times the
/// changes of both angles, L the characteristic length, and C any matrix. T(xi) = xi - C F(xi, q) maps the
/// ball |xi| <= r into itself and contracts there, for every q that the actuated joints take, if
///
///     |C F(0, q)| + g r + k r^2 / 2 <= r    and    g + k r < 1,
///
/// where g bounds |I - C DF(0, q)| and k is a Lipschitz constant of C DF in the ball. docs/theory/tracking.md
/// has the proof and the bounds. All of them are rounded outward, so what is certified is a theorem about the
/// model.
///
/// Copies what it needs of the manipulator. Nothing but the constructor needs room; nothing throws. All but
/// the constructor need a live `RoundingUpward`.
class PoseCertifier {
 public:
  explicit PoseCertifier(const Manipulator& manipulator) noexcept;

  /// Newton's method from `point.pose` for `point.q`, then everything else at the pose it ends at. False
  /// where it does not converge; the point is then of no use.
  bool evaluate(CertifiedPoint& point) const noexcept;

  /// What is proved where the actuated joints stay at `point.q`: the smallest ball, of rounding alone.
  CertifiedBall ball(const CertifiedPoint& point) const noexcept;

  /// What is proved while they move by `share` (0 to 1) of `direction` from there, with `speed` of
  /// `path_speed`. An actuated joint may be off by `allowance`, which is for rounding [rad or m].
  CertifiedBall ball(const CertifiedPoint& point, const TaskVector& direction, const TaskVector& allowance,
                     double share, double speed) const noexcept;

  /// At least |C B direction|: how far the platform goes on the path, to first order [m].
  double path_speed(const CertifiedPoint& point, const TaskVector& direction) const noexcept;

  /// The actuated joint that, off by its `allowance` [rad or m], moves the platform most, about.
  Eigen::Index widest(const CertifiedPoint& point, const TaskVector& allowance) const noexcept;

  /// At least how far the platform is from the pose where each actuated joint is off by `allowance` at most
  /// [m, RMS over the anchors]; infinite where that is not proved.
  double anchor_spread(const CertifiedPoint& point, const TaskVector& allowance) const noexcept;

  /// The pose that one step of Newton's method leads to for the actuated joints `q`.
  Pose predicted(const CertifiedPoint& point, const JointVector& q) const noexcept;

  /// At least the distance sqrt(L^2 angle^2 + |displacement|^2) of two poses that are not half a turn apart
  /// [m]; in R2 L times that of the angles.
  double distance(const Pose& a, const Pose& b) const noexcept;

  /// B_jj over the largest that it can be at this |u_j|: the sine of the angle between rod and crank, or
  /// between rod and the normal of a rail; 1 or -1 for struts. Rounded.
  TaskVector entry_sines(const CertifiedPoint& point) const noexcept;

  /// The sign of B_jj of a leg wherever the platform is within `radius` of `point`, in the metric of
  /// `distance`, and the actuated joint within `change` of its value [rad or m]; 0 where that is not proved.
  int entry_sign(const CertifiedPoint& point, std::size_t leg, double radius, double change) const noexcept;

  /// Whether it is proved of each leg that a joint value within `allowance` of that at `point` [rad or m]
  /// assembles it with `point.pose` itself.
  bool assembles_within(const CertifiedPoint& point, const TaskVector& allowance) const noexcept;

  /// The sign of det A at `point`, and so in each ball around it; 0 where that is not proved.
  int determinant_sign(const CertifiedPoint& point) const noexcept;

 private:
  using Rows = SquareArray<double>;

  CertifiedBall ball(const CertifiedPoint& point, const TaskVector& direction, const TaskVector& allowance,
                     double share, double speed, double least) const noexcept;
  double angle_distance(const Pose& a, const Pose& b) const noexcept;
  void approximate(const Pose& pose, const JointVector& q, LegBounds& residual, Rows* matrix) const noexcept;
  Pose stepped(const Pose& pose, const Rows& inverse, const LegBounds& residual, double& size) const noexcept;
  bool refine(CertifiedPoint& point) const noexcept;
  bool enclose(CertifiedPoint& point) const noexcept;
  SquareArray<Interval> enclosed_matrix(const CertifiedPoint& point,
                                        std::array<LegEnclosure, max_legs>& legs) const noexcept;
  double spread(const CertifiedPoint& point, const LegBounds& entries) const noexcept;

  Motions motions_;
  std::size_t size_;        // number of legs
  std::size_t rotational_;  // columns
  double length_;           // characteristic
  double scale_;            // size of the robot
  std::array<LegForm, max_legs> legs_;
  AnchorBounds bounds_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_POSE_CERTIFIER_H
