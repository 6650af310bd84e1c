// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_LEG_H
#define PARALLEL_ASPECTS_MODEL_LEG_H

#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <limits>
#include <string>
#include <string_view>
#include <variant>

namespace parallel_aspects {

/// The kinds of legs, for switches: without a default, so that the compiler asks for a new one.
enum class LegType {
  revolute,   ///< `RevoluteActuation`
  prismatic,  ///< `PrismaticActuation`
  strut,      ///< `StrutActuation`
  elbow,      ///< `ElbowActuation`
};

/// What follows from the kind of a leg, for all dimensions.
struct LegKind {
  LegType type;               ///< for switches
  std::string_view name;      ///< for people
  bool actuated_by_angle;     ///< the joint value is an angle [rad], not a length [m]
  bool moves_proximal_point;  ///< the joint value moves c; of other kinds it changes rho
  bool has_crank;             ///< c is the tip of a crank about `Leg::base_point`
  bool has_straight_rod;      ///< the rod is one straight link from c to p
  bool bounded_by_links;      ///< links alone bound the reach; of other kinds, limits of the joint do
};

/// The proximal point c runs on a circle: c(q) = center + radius (cos q e1 + sin q e2), with e1 =
/// zero_direction and e2 = axis x e1. Legs RRR, RUS, RSS, Delta, and spherical RRR. Joint value q in rad.
struct RevoluteActuation {
  /// What tells it from the other kinds.
  static constexpr LegKind kind{LegType::revolute, "actuated revolute joint", true, true, true, true, true};

  Eigen::Vector3d center;          ///< of the circle, in the task frame [m]
  Eigen::Vector3d axis;            ///< unit vector; q turns about it by the right-hand rule
  Eigen::Vector3d zero_direction;  ///< unit vector orthogonal to axis; from center to c at q = 0
  double radius;                   ///< [m], positive
};

/// The proximal point runs on a line: c(q) = origin + q direction. Legs PRR, PUS, PSS. Joint value q in
/// m.
struct PrismaticActuation {
  /// What tells it from the other kinds.
  static constexpr LegKind kind{
      LegType::prismatic, "actuated prismatic joint", false, true, false, true, false};

  Eigen::Vector3d origin;     ///< c at q = 0, in the task frame [m]
  Eigen::Vector3d direction;  ///< unit vector
};

/// The rod itself is actuated: c fixed, rho(q) = length_at_zero + sense q. Legs RPR, UPS, SPS. Actuation
/// value q in m.
struct StrutActuation {
  /// What tells it from the other kinds.
  static constexpr LegKind kind{LegType::strut, "strut", false, false, false, true, false};

  Eigen::Vector3d base;         ///< c, in the task frame [m]
  double length_at_zero = 0.0;  ///< rho at q = 0 [m]
  double sense = 1.0;           ///< +1 or -1
};

/// The elbow between two links is actuated: c fixed, and by the law of cosines
/// rho(q)^2 = inner^2 + outer^2 + 2 inner outer cos(angle_at_zero + sense q). Joint value q in rad.
struct ElbowActuation {
  /// What tells it from the other kinds.
  static constexpr LegKind kind{LegType::elbow, "actuated elbow", true, false, false, false, true};

  Eigen::Vector3d base;        ///< c, in the task frame [m]
  double inner_length;         ///< link on the base [m], positive
  double outer_length;         ///< link on the platform [m], positive
  double angle_at_zero = 0.0;  ///< between the two links at q = 0; 0 is stretched [rad]
  double sense = 1.0;          ///< +1 or -1
};

/// What the actuated joint of a leg moves: c, or rho. Each kind states its own `LegKind`, so that the
/// compiler asks for that of a new one.
using Actuation = std::variant<RevoluteActuation, PrismaticActuation, StrutActuation, ElbowActuation>;

/// Range of a joint value, both ends included, and its speed; unlimited by default. rad or m.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();    ///< least value [rad or m]
  double upper = std::numeric_limits<double>::infinity();     ///< greatest value [rad or m]
  double velocity = std::numeric_limits<double>::infinity();  ///< fastest change [rad/s or m/s], positive

  /// Whether the range, not the speed, has an end.
  bool limited() const noexcept {
    return lower > -std::numeric_limits<double>::infinity() ||
           upper < std::numeric_limits<double>::infinity();
  }

  /// Whether the value is in the range; false for NaN.
  bool contain(double value) const noexcept { return lower <= value && value <= upper; }
};

/// One leg of a fully parallel manipulator, as one scalar equation between its actuated joint and the pose:
///
///     f(X, q) = |p(X) - c(q)|^2 - rho(q)^2 = 0
///
/// p(X) is the anchor, fixed in the platform; c(q) the proximal point; rho(q) the distance between the two.
struct Leg {
  std::string name;                                  ///< for people; unique in a manipulator
  std::string actuated_joint;                        ///< name of the actuated joint; unique in a manipulator
  Actuation actuation;                               ///< what the actuated joint moves
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< in the platform frame [m]
  double rod_length =
      0.0;             ///< rho for revolute and actuated prismatic joints [m], positive; unused by the others
  JointLimits limits;  ///< of the joint value
  /// A robot as it is built may differ from these numbers: each of its points by a vector, and each of its
  /// lengths by a difference, of at most this [m]. Directions and angles are as they are. What maps and
  /// segments prove holds for every such robot; everything else is of the robot with these numbers.
  double tolerance = 0.0;

  Eigen::Vector3d proximal_point(double q) const noexcept;             ///< c(q) [m]
  Eigen::Vector3d proximal_point_derivative(double q) const noexcept;  ///< dc/dq [m/rad or 1]
  double squared_distance(double q) const noexcept;                    ///< rho(q)^2 [m^2]
  double squared_distance_derivative(double q) const noexcept;         ///< d(rho^2)/dq = 2 rho rho'

  /// f(X, q) [m^2]: zero when the leg is assembled.
  double residual(const Pose& pose, double q) const noexcept;

  /// What its kind tells.
  const LegKind& kind() const noexcept;

  /// Where the kind has a crank: what it is. Else null.
  const RevoluteActuation* crank() const noexcept;

  /// Whether the joint value is an angle [rad] rather than a length [m].
  bool actuated_by_angle() const noexcept { return kind().actuated_by_angle; }

  /// Whether B_jj can take this sign (+1 or -1). Both signs, except for a strut: its length is positive, so
  /// that B_jj always has the sign of its sense.
  bool has_branch(int sign) const noexcept;

  /// Whether it can have this joint value at all: the length of a strut must not be negative.
  bool can_have(double q) const noexcept;

  /// No |B_jj| is larger than this [m^2/rad or m]: that of rod and crank at right angles. 0 for a strut,
  /// which has no serial singularity: its |B_jj| is its length.
  double largest_entry() const noexcept;

  /// No anchor within reach of the leg is farther from `base_point()` than this [m]; infinite for a prismatic
  /// actuated joint or a strut without limits.
  double longest_reach() const noexcept;

  /// The fixed point that `longest_reach` counts from, in the task frame [m].
  Eigen::Vector3d base_point() const noexcept;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_LEG_H
