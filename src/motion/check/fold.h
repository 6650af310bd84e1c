// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_FOLD_H
#define PARALLEL_ASPECTS_MOTION_CHECK_FOLD_H

#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "tracking/pose_certifier.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// The actuated joints between two waypoints: a polynomial of s in [0, 1] for each, in enclosures of its
/// coefficients. Needs a live `RoundingUpward`.
class JointPath {
 public:
  JointPath(const JointWaypoint& from, const JointWaypoint& to) noexcept;

  /// Encloses the value of a joint at s [rad or m].
  Interval value(std::size_t leg, double s) const noexcept;

  /// Encloses its derivative over a range of s [rad or m].
  Interval slope(std::size_t leg, const Interval& s) const noexcept;

  /// Encloses its second derivative over a range of s [rad or m].
  Interval second(std::size_t leg, const Interval& s) const noexcept;

  /// An upper bound of how far a joint is from its chord between two s [rad or m].
  double bend(std::size_t leg, double begin, double end) const noexcept;

 private:
  using Coefficients = std::array<Interval, 6>;  // of 1, s, ..., s^5

  std::array<Coefficients, max_legs> coefficients_;
};

/// Proves that a platform, followed along a path of the actuated joints, meets det A = 0.
///
/// Where det A vanishes the solutions of F(X, q(s)) = 0 are no function of s any more, but still a curve of
/// (X, s). With zeta = (xi, z) about a point (X_k, s_k), xi = (L w, v) and z = scale (s - s_k), and a unit
/// vector d, let
///
///     H(zeta, tau) = (F(X(xi), q(s_k + z / scale)), d.zeta - tau).
///
/// Let C be any matrix, eta >= |C H(0, 0)|, g >= |I - C DH(0)|, and k a Lipschitz constant of C DH on the
/// ball |zeta| <= r. If eta + |C e| h + g r + k r^2 / 2 <= r and g + k r < 1, with e the last unit vector,
/// then for every |tau| <= h the ball holds exactly one solution; it is continuous in tau. So the solutions
/// with |tau| <= h in the ball are one arc, and the extended matrix is regular on it, whether det A vanishes
/// or not. As |tau| <= |zeta|, each solution that is within h of the point lies on it. Arcs that share a
/// solution continue each other.
///
/// Theorem. Let the platform be followed with det A != 0 for all s in [earliest, share], and let arcs lead
/// from its solution at `share` to one where det A has the other sign, with earliest < s < latest <= 1 on all
/// of them. Then the platform meets det A = 0 at some s* in (share, latest].
///
/// Proof. The arcs are part of a curve without branches, so a simple arc leads from the one solution to the
/// other. As long as det A != 0 it is the graph of a function of s, for ds/dtau is det A over the
/// determinant of the extended matrix. Did it start towards falling s, it would stay on the graph that was
/// followed, on all of which det A has the sign of the start, and could not leave it at s > earliest. So it
/// starts towards rising s, and is where the platform goes, up to the first zero of det A on it; there is
/// one, since the sign differs at its end. QED
///
/// docs/theory/checking.md has the bounds. All of them are rounded outward.
class FoldProof {
 public:
  /// The path and the certifier must outlive it. Needs a live `RoundingUpward`, as all of it does.
  FoldProof(const Manipulator& manipulator, const PoseCertifier& poses, const JointPath& path) noexcept;

  /// `latest` of the theorem, which is searched for up to `until`; nothing where it is not proved. The
  /// platform was followed from `earliest` to `share`, where it is within `off` of `at`, in the metric of
  /// `PoseCertifier::distance`.
  std::optional<double> latest(const CertifiedPoint& at, double off, double earliest, double share,
                               double until) noexcept;

 private:
  static constexpr int most = max_legs + 1;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most, most>;
  using LegVector = std::array<Interval, max_legs>;

  /// A point near the curve, and what proofs about its neighbourhood need, rounded outward.
  struct Point {
    Pose pose;
    double share = 0.0;
    Matrix inverse;            // C
    Vector tangent;            // d
    double defect = 0.0;       // g
    double residual = 0.0;     // eta
    LegBounds rod{}, entry{};  // at least |u_j| and |B_jj|
  };

  struct Arc {
    double radius = 0.0;  // of the ball
    double drift = 0.0;   // at least |s - s_k| on it
  };

  struct Onward {
    Arc arc;
    Point end;
  };

  struct System {
    std::array<std::array<Interval, most>, most> matrix;  // DH(0)
    std::array<Interval, most> residual;                  // H(0, 0)
  };

  double find_scale(const CertifiedPoint& at, double share) const noexcept;
  Interval middle_of(std::size_t leg, double share, double& q) const noexcept;
  System enclose(Point& point) const noexcept;
  bool evaluate(Point& point) const noexcept;
  bool prepare(Point& point, const Vector& onward) const noexcept;
  Point moved(const Point& point, const Vector& step) const noexcept;
  double lipschitz(const Point& point, double radius) const noexcept;
  std::optional<Arc> arc(const Point& point, double length) const noexcept;
  std::optional<Point> next(const Point& point, double length, double radius) const noexcept;
  std::optional<Onward> go_on(const Point& point, double earliest, double& length) const noexcept;
  int determinant_sign(Point point) const noexcept;
  double distance(const Point& a, const Point& b) const noexcept;

  Motions motions_;
  const PoseCertifier& poses_;
  const JointPath& path_;
  std::size_t size_, rotational_;
  double length_, robot_size_;
  double scale_ = 0.0;  // of z, over that of s
  std::array<LegForm, max_legs> legs_;
  AnchorBounds bounds_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_FOLD_H
