// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_CONSTRAINTS_H
#define PARALLEL_ASPECTS_MODEL_CONSTRAINTS_H

#include "parallel_aspects/model/leg.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <bitset>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace parallel_aspects {

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
  /// distances do not tell where they are.
  std::vector<std::string> missing_joints;
};

/// In how many directions the platform can move away: 0 to 3.
std::size_t directions(TaskSpace space) noexcept;

/// Whether legs and platform stay in the x-y plane (T1, T2, SE2).
bool is_planar(TaskSpace space) noexcept;

/// What is wrong with the constraints for these legs, a message each.
Problems find_problems(const Constraints& constraints, TaskSpace space, const std::vector<Leg>& legs);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_CONSTRAINTS_H
