// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_MANIPULATOR_H
#define PARALLEL_ASPECTS_MODEL_MANIPULATOR_H

#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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
  /// What distinguishes it from the other kinds.
  static constexpr LegKind kind{LegType::revolute, "actuated revolute joint", true, true, true, true, true};

  Eigen::Vector3d center;          ///< of the circle, in the task frame [m]
  Eigen::Vector3d axis;            ///< unit vector; q turns about it by the right-hand rule
  Eigen::Vector3d zero_direction;  ///< unit vector orthogonal to axis; from center to c at q = 0
  double radius;                   ///< [m], positive
};

/// The proximal point runs on a line: c(q) = origin + q direction. Legs PRR, PUS, PSS. Joint value q in
/// m.
struct PrismaticActuation {
  /// What distinguishes it from the other kinds.
  static constexpr LegKind kind{
      LegType::prismatic, "actuated prismatic joint", false, true, false, true, false};

  Eigen::Vector3d origin;     ///< c at q = 0, in the task frame [m]
  Eigen::Vector3d direction;  ///< unit vector
};

/// The rod itself is actuated: c fixed, rho(q) = length_at_zero + sense q. Legs RPR, UPS, SPS. Actuation
/// value q in m.
struct StrutActuation {
  /// What distinguishes it from the other kinds.
  static constexpr LegKind kind{LegType::strut, "strut", false, false, false, true, false};

  Eigen::Vector3d base;         ///< c, in the task frame [m]
  double length_at_zero = 0.0;  ///< rho at q = 0 [m]
  double sense = 1.0;           ///< +1 or -1
};

/// The elbow between two links is actuated: c fixed, and by the law of cosines
/// rho(q)^2 = inner^2 + outer^2 + 2 inner outer cos(angle_at_zero + sense q). Joint value q in rad.
struct ElbowActuation {
  /// What distinguishes it from the other kinds.
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

/// What can bound an aspect besides singularities.
enum class ConstraintKind {
  actuated_limits,  ///< limits of the actuated joints
  passive_limits,   ///< limits of joints that are not actuated
  cones,            ///< how far the rods lean in their ball joints
  self_collision,   ///< links of two legs that touch
  obstacles,        ///< links or the platform that touch something in the surroundings
  workspace,        ///< a box that the operational point must stay in
  margins,          ///< how near to singularities configurations may come
};

/// Every kind of constraint, in the order in which they are named.
inline constexpr std::array<ConstraintKind, 7> all_constraint_kinds{
    ConstraintKind::actuated_limits, ConstraintKind::passive_limits, ConstraintKind::cones,
    ConstraintKind::self_collision,  ConstraintKind::obstacles,      ConstraintKind::workspace,
    ConstraintKind::margins};

/// Bit k stands for the k-th of `all_constraint_kinds`.
using ConstraintKinds = std::bitset<all_constraint_kinds.size()>;

/// Its place in `all_constraint_kinds`.
inline std::size_t index_of(ConstraintKind kind) noexcept { return static_cast<std::size_t>(kind); }

/// "actuated_limits", "passive_limits", "cones", "self_collision", "obstacles", "workspace" or "margins".
std::string_view name(ConstraintKind kind) noexcept;

/// The kind of that name; nothing for any other text.
std::optional<ConstraintKind> constraint_named(std::string_view text) noexcept;

/// What is measured by a passive joint of a planar leg.
enum class PassiveAngle {
  base_to_rod,      ///< from the x axis to the rod
  crank_to_rod,     ///< from the crank to the rod
  rod_to_platform,  ///< from the rod to the x axis of the platform
};

/// The limits of a passive joint. The angle, counter-clockwise in the plane and up to full turns, is
/// `offset` + `sense` q for the joint value q.
struct PassiveLimit {
  std::string joint;                               ///< name of the passive joint
  std::size_t leg = 0;                             ///< index of the leg that it is in
  PassiveAngle angle = PassiveAngle::base_to_rod;  ///< what it measures
  double offset = 0.0;                             ///< [rad]
  double sense = 1.0;                              ///< +1 or -1
  JointLimits limits;                              ///< [rad]
};

/// The two ends of the rod or strut of a leg.
enum class LegEnd { base, platform };

/// "base" or "platform".
std::string_view name(LegEnd end) noexcept;

/// How far a rod or strut leans in the ball joint at one of its ends: for u from its end at the base to that
/// at the platform, u.axis >= |u| |axis| cos(angle). The axis is fixed in
///  - the platform, and given in its frame, at the end there;
///  - the crank, at the other end of the rod of an actuated revolute joint: x points from that joint to the
///    ball joint, z along the axis that its angle grows about, and y is z cross x;
///  - the base, and given in the task frame, at that end of all other legs.
/// In the plane the axis is in it, and its z is 0.
struct BallJointCone {
  std::size_t leg = 0;                              ///< index, from 0; not one with an actuated elbow
  LegEnd end = LegEnd::base;                        ///< where the ball joint is
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector, to the last digits
  double angle = 0.5 * EIGEN_PI;                    ///< half the opening, between 0 and pi [rad]
};

/// One end of the range of a passive joint of a universal joint, as a cone that the rod is in just where the
/// joint is within that end. What a universal joint lets a rod do is what all its cones have in common.
struct PassiveCone {
  std::string joint;   ///< name of the passive joint
  BallJointCone cone;  ///< whose angle is half a turn or less
};

/// The range of a joint of the passive chain of R1 or R2, whose value is a pose coordinate, up to full turns.
struct HingeLimit {
  std::string joint;      ///< name of the passive joint
  std::size_t hinge = 0;  ///< which of the pose coordinates, from 0
  JointLimits limits;     ///< [rad]

  /// Whether it leaves out any angle.
  bool is_limited() const noexcept;
};

/// Widths of the links, which are segments with round ends [m]: a link touches what is closer to its middle
/// line than half of that.
struct LinkThickness {
  double crank = 0.0;              ///< of every crank [m], 0 or more
  double rod = 0.0;                ///< of every rod [m], 0 or more
  std::optional<double> platform;  ///< of the segments between the anchors; without, they touch nothing
};

/// The links of a planar leg: the crank on the base, the rod on the platform.
enum class LinkKind { crank, rod };

/// "crank_1", "rod_1" and so on: legs are counted from 1.
struct LinkName {
  LinkKind kind = LinkKind::crank;  ///< which of the two links
  std::size_t leg = 0;              ///< index, from 0

  /// Whether both name one link.
  friend bool operator==(const LinkName& a, const LinkName& b) noexcept {
    return a.kind == b.kind && a.leg == b.leg;
  }
};

/// "crank_1", as people write it.
std::string to_string(const LinkName& link);

/// Cranks and rods of different legs must not touch each other. Links that are joined to each other are not
/// tested: the crank and the rod of one leg, rods with one anchor, cranks with one centre.
struct SelfCollision {
  std::vector<std::array<LinkName, 2>> ignored;  ///< pairs that pass each other, as in different planes
};

/// A ball, or in the plane a disc.
struct BallObstacle {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< in the task frame [m]
  double radius = 0.0;                               ///< [m]
};

/// A box, or in the plane a rectangle.
struct BoxObstacle {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();                 ///< in the task frame [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< about z in the plane
  Eigen::Vector3d half_size = Eigen::Vector3d::Zero();              ///< along its own axes [m]
};

/// Something in the surroundings that links and platform must not touch.
struct Obstacle {
  std::string name;                               ///< for messages
  std::variant<BallObstacle, BoxObstacle> shape;  ///< in the task frame [m]
};

/// The operational point must stay in it, in the task frame [m]; as many numbers count as the platform can
/// move in directions.
struct WorkspaceBox {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();  ///< corner with the smallest coordinates
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();  ///< corner with the largest
};

/// The least indices of the configurations that count, so that they keep away from singularities. 0 asks
/// nothing.
struct Margins {
  double parallel = 0.0;  ///< of `parallel_index`, 0 to below 1
  double serial = 0.0;    ///< of every `serial_indices`, 0 to below 1
  double det_a = 0.0;     ///< of |det A|, in the unit of `direct_determinant`; 0 or more

  /// Whether anything is asked.
  bool any() const noexcept { return parallel > 0.0 || serial > 0.0 || det_a > 0.0; }
};

/// How one of the margins is written, and which numbers it takes: 0 to below `bound`.
struct NamedMargin {
  std::string_view name;     ///< "parallel", "serial" or "det_a"
  double Margins::*member;   ///< where it is
  double bound;              ///< infinite where there is none
  std::string_view range;    ///< the same in words
  std::string_view meaning;  ///< what it is the least of
};

/// Every margin, in the order in which they are named.
inline constexpr std::array<NamedMargin, 3> named_margins{
    {{"parallel", &Margins::parallel, 1.0, "from 0 to below 1",
      "the least parallel index, which is 0 at parallel singularities and 1 at most"},
     {"serial", &Margins::serial, 1.0, "from 0 to below 1",
      "the least |B_jj| over its largest on that leg, which is 0 at serial singularities and 1 at most"},
     {"det_a", &Margins::det_a, std::numeric_limits<double>::infinity(), "0 or a positive number",
      "the least |det A|, in its unit"}}};

/// What bounds the motions of a manipulator besides singularities and the limits of its actuated joints,
/// which its legs hold. What is not there is not asked.
struct Constraints {
  LinkThickness thickness;                      ///< for self-collision and obstacles
  std::vector<PassiveLimit> passive_limits;     ///< none: passive joints are not limited
  std::vector<PassiveCone> passive_cones;       ///< more limits of passive joints
  std::vector<HingeLimit> hinge_limits;         ///< still more, of the chain that holds the platform
  std::vector<BallJointCone> cones;             ///< none: rods and struts may lean as they like
  std::optional<SelfCollision> self_collision;  ///< none: links may touch each other
  std::vector<Obstacle> obstacles;              ///< what links and platform must not touch
  std::optional<WorkspaceBox> workspace;        ///< none: the operational point may be anywhere
  Margins margins;                              ///< from singularities

  /// Limited joints that none of `passive_limits`, `passive_cones` and `hinge_limits` stands for, since
  /// distances do not determine where they are.
  std::vector<std::string> missing_joints;
};

/// In how many directions the platform can move away: 0 to 3.
std::size_t directions(TaskSpace space) noexcept;

/// Whether legs and platform stay in the x-y plane (T1, T2, SE2).
bool is_planar(TaskSpace space) noexcept;

/// What is wrong with the constraints for these legs, a message each.
Problems find_problems(const Constraints& constraints, TaskSpace space, const std::vector<Leg>& legs);

/// What a manipulator is made of; plain data that `Manipulator` checks.
struct ManipulatorDescription {
  std::string name;                      ///< for people and messages
  TaskSpace task_space = TaskSpace::T2;  ///< where the platform moves
  std::vector<Leg> legs;                 ///< as many as the task space has degrees of freedom
  std::string base_frame = "base_link";  ///< link that `task_frame` is given in
  Eigen::Isometry3d task_frame = Eigen::Isometry3d::Identity();  ///< task frame in the base frame [m]
  Constraints constraints{};                                     ///< none by default
  HingePair hinges{};                                            ///< what holds the platform, in R2
};

/// A fully parallel manipulator (Definition 1 of the paper) with one distance equation a leg. Immutable.
class Manipulator {
 public:
  /// Throws `InvalidDescription` with every problem: wrong number of legs; lengths that are not finite and
  /// positive; directions that are not unit or not orthogonal; empty or repeated names; limits that are NaN
  /// or crossed; constraints that do not fit the legs.
  explicit Manipulator(ManipulatorDescription description);

  /// What it was made of; what follows are parts of it.
  const ManipulatorDescription& description() const noexcept { return description_; }
  const std::string& name() const noexcept { return description_.name; }     ///< for people and messages
  TaskSpace task_space() const noexcept { return description_.task_space; }  ///< where the platform moves
  /// The task space with the passive chain that it stands on in R2.
  Motions motions() const noexcept { return {description_.task_space, description_.hinges}; }
  const std::vector<Leg>& legs() const noexcept { return description_.legs; }         ///< see `JointVector`
  const Leg& leg(std::size_t index) const { return description_.legs[index]; }        ///< below `leg_count()`
  std::size_t leg_count() const noexcept { return description_.legs.size(); }         ///< 1 to `max_legs`
  const std::string& base_frame() const noexcept { return description_.base_frame; }  ///< as tf names it
  const Constraints& constraints() const noexcept { return description_.constraints; }  ///< none by default

  /// In the base frame.
  const Eigen::Isometry3d& task_frame() const noexcept { return description_.task_frame; }

  /// The kinds of constraints that there are, limits of actuated joints among them.
  ConstraintKinds constraint_kinds() const noexcept;

  /// The same manipulator with no constraints but those of these kinds that it has. Links of a planar robot
  /// that has no `self_collision` become segments without thickness there.
  /// Throws `InvalidDescription` where a kind is asked for that does not fit the legs.
  std::shared_ptr<const Manipulator> with_constraints(ConstraintKinds kinds) const;

  /// The same manipulator with other margins. Throws `InvalidDescription` where they are out of their range.
  std::shared_ptr<const Manipulator> with_margins(const Margins& margins) const;

  /// The same manipulator with a tolerance for each leg: this share of its size (see `Leg::tolerance`).
  /// Throws `InvalidDescription` where it is negative or not finite.
  std::shared_ptr<const Manipulator> with_tolerance(double share) const;

  /// The largest tolerance of a leg [m]; 0 by default.
  double tolerance() const noexcept;

  /// Root mean square distance of the anchors from the operational point [m]; the length that makes rotations
  /// and displacements comparable. 1 when the platform does not turn or all anchors are at the operational
  /// point.
  double characteristic_length() const noexcept { return characteristic_length_; }

  /// Size of the robot: the longest distance between two base points plus the longest reach of a leg that has
  /// one [m]. Residuals are judged relative to it.
  double size() const noexcept { return size_; }

  /// Whether every joint value is finite and inside its limits; `q` must have `leg_count()` entries.
  bool within_limits(const JointVector& q) const noexcept;

 private:
  ManipulatorDescription description_;
  double characteristic_length_;
  double size_;
};

/// How far two poses are apart: root mean square displacement of the anchors [m], in floating point.
inline double anchor_distance(const Manipulator& manipulator, const Pose& a, const Pose& b) noexcept {
  double sum = 0.0;
  for (const Leg& leg : manipulator.legs())
    sum += (a.transform(leg.anchor) - b.transform(leg.anchor)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(manipulator.leg_count()));
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_MANIPULATOR_H
