// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/passive_limits.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double quarter_turn = 0.5 * EIGEN_PI;

// Wide enough for limits of a quarter of a turn that are rounded to four digits.
constexpr double angle_tolerance = 5e-4;

// Axes that miss a right angle by more would make the cones wrong in more than the last digits.
constexpr double perpendicular_tolerance = 1e-6;

bool are_perpendicular(const Vector3d& a, const Vector3d& b) {
  return std::abs(a.dot(b)) < perpendicular_tolerance;
}

/// The range of an angle that is `now` and grows with the joint value.
JointLimits range_of(const UniversalAxis& pivot, double now) {
  JointLimits range;
  range.lower = now + (pivot.limits.lower - pivot.value);
  range.upper = now + (pivot.limits.upper - pivot.value);
  return range;
}

}  // namespace

// Seen from what the first axis a is fixed in, with phi the elevation of the rod u over the plane across a,
// psi its azimuth there and g its direction there now, u = cos phi (cos psi g + sin psi a x g) + sin phi a.
// The second joint changes phi alone, the first psi. With cos phi > 0,
//   phi >= l  is  u.a >= cos(pi/2 - l),  and  phi <= h  is  u.(-a) >= cos(pi/2 + h);
//   psi in [l, h], not longer than half a turn, is  u.n >= 0  for the directions n at azimuth l + pi/2 and
//   h - pi/2.
std::optional<std::vector<LimitedDirection>> limited_directions(const UniversalAxis& first,
                                                                const UniversalAxis& second,
                                                                const Vector3d& rod) {
  const Vector3d u = rod.normalized(), a = first.axis;
  if (!are_perpendicular(a, second.axis) || !are_perpendicular(second.axis, u)) return std::nullopt;
  const Vector3d across = a.cross(second.axis);
  const double side = u.dot(across) < 0.0 ? -1.0 : 1.0;  // where the rod is on the other side, phi falls
  const Vector3d g = side * across, h = a.cross(g);
  const double elevation = std::atan2(u.dot(a), u.dot(g));
  JointLimits phi = range_of(second, side * elevation);
  if (side < 0.0) phi = {-phi.upper, -phi.lower};
  const JointLimits psi = range_of(first, 0.0);
  if (!(phi.lower >= -quarter_turn - angle_tolerance && phi.upper <= quarter_turn + angle_tolerance &&
        phi.lower < quarter_turn && phi.upper > -quarter_turn))
    return std::nullopt;
  if (psi.limited() && !(psi.upper - psi.lower <= EIGEN_PI)) return std::nullopt;
  std::vector<LimitedDirection> result;
  if (phi.lower > -quarter_turn) result.push_back({second.joint, a, quarter_turn - phi.lower});
  if (phi.upper < quarter_turn) result.push_back({second.joint, -a, quarter_turn + phi.upper});
  if (!psi.limited()) return result;
  result.push_back({first.joint, std::cos(psi.lower) * h - std::sin(psi.lower) * g, quarter_turn});
  result.push_back({first.joint, std::sin(psi.upper) * g - std::cos(psi.upper) * h, quarter_turn});
  return result;
}

namespace {

using Eigen::Vector3d;

// Of a rod that spins about its own axis.
constexpr double spin_tolerance = 1e-6;

double direction_of(const Vector3d& vector) { return std::atan2(vector.y(), vector.x()); }

class Search {
 public:
  Search(const ClosureSystem& system, const Eigen::VectorXd& values, const PlatformMotion& motion)
      : system_(system), values_(values), motion_(motion), to_task_(motion.task_frame.inverse()) {}

  FoundPassiveLimits run(const std::vector<RecognisedLeg>& legs, const std::vector<std::size_t>& bounded) {
    add_hinges();
    for (std::size_t j = 0; j < legs.size(); ++j) {
      if (motion_.space == TaskSpace::SO3 || !legs[j].leg.kind().has_straight_rod) continue;
      for (const SplitChain& chain : legs[j].chains)
        is_planar(motion_.space) ? add(j, legs[j].leg, chain) : add_cones(j, legs[j].leg, chain);
    }
    for (std::size_t variable = 0; variable < system_.in_loop().size(); ++variable)
      if (is_limited(variable) && !is_actuated(variable, legs) && !is_reported(joint(variable).name) &&
          std::find(bounded.begin(), bounded.end(), variable) == bounded.end())
        found_.missing.push_back(joint(variable).name);
    return std::move(found_);
  }

 private:
  // Pose coordinates are the values of these joints.
  void add_hinges() {
    for (std::size_t k = 0; k < motion_.hinge_chain.size(); ++k) {
      const auto variable = motion_.hinge_chain[k].variable;
      if (variable && is_limited(*variable))
        found_.hinges.push_back({joint(*variable).name, k, joint(*variable).limits});
    }
  }

  const TreeJoint& joint(std::size_t variable) const { return system_.tree().joint_of(variable); }

  bool is_limited(std::size_t variable) const {
    const JointLimits& limits = joint(variable).limits;
    const bool turns_freely =
        joint(variable).motion == JointMotion::revolute && limits.upper - limits.lower >= 2.0 * EIGEN_PI;
    return system_.in_loop()[variable] && limits.limited() && !turns_freely;
  }

  static bool is_actuated(std::size_t variable, const std::vector<RecognisedLeg>& legs) {
    return std::any_of(legs.begin(), legs.end(), [variable](const RecognisedLeg& leg) {
      return leg.chains.front().actuation.variable == variable;
    });
  }

  bool is_reported(const std::string& name) const {
    const auto is_of_joint = [&name](const auto& limit) { return limit.joint == name; };
    return std::any_of(found_.limits.begin(), found_.limits.end(), is_of_joint) ||
           std::any_of(found_.hinges.begin(), found_.hinges.end(), is_of_joint) ||
           std::any_of(found_.cones.begin(), found_.cones.end(), is_of_joint);
  }

  void add(std::size_t index, const Leg& leg, const SplitChain& chain) {
    const Vector3d rod = to_task_.linear() * (chain.p - chain.c);
    if (const Pivot* pivot = only_one(chain.proximal)) {
      const bool crank = leg.kind().has_crank;
      const double from =
          crank ? direction_of(leg.proximal_point(value(chain.actuation)) - leg.base_point()) : 0.0;
      add(index, crank ? PassiveAngle::crank_to_rod : PassiveAngle::base_to_rod, *pivot,
          direction_of(rod) - from);
    }
    const Pivot* pivot = only_one(chain.distal);
    if (pivot == nullptr || motion_.point_platform) return;
    const Vector3d heading = has_rotation(motion_.space)
                                 ? Vector3d(to_task_.linear() * motion_.platform.linear().col(0))
                                 : Vector3d(Vector3d::UnitX());
    add(index, PassiveAngle::rod_to_platform, *pivot, direction_of(heading) - direction_of(rod));
  }

  // In the order from the link that the axes of the cones are fixed in to the rod.
  void add_cones(std::size_t index, const Leg& leg, const SplitChain& chain) {
    const Vector3d rod = chain.p - chain.c;
    add_cones(BallJointCone{index, LegEnd::base, {}, 0.0}, base_axes(leg, chain), chain.proximal, 1.0, rod);
    if (motion_.point_platform) return;
    const Chain from_platform(chain.distal.rbegin(), chain.distal.rend());
    add_cones(BallJointCone{index, LegEnd::platform, {}, 0.0}, motion_.platform.linear(), from_platform, -1.0,
              rod);
  }

  void add_cones(BallJointCone cone, const Eigen::Matrix3d& axes, const Chain& group, double sense,
                 const Vector3d& rod) {
    const bool spins = group.size() == 3 && group.back().kind == PivotKind::revolute &&
                       group.back().axis.cross(rod.normalized()).norm() < spin_tolerance;
    if (group.size() != 2 && !spins) return;
    const auto first = universal_axis(group[0], sense), second = universal_axis(group[1], sense);
    if (!first || !second || (!first->limits.limited() && !second->limits.limited())) return;
    const auto directions = limited_directions(*first, *second, rod);
    if (!directions) return;
    for (const LimitedDirection& limited : *directions) {
      cone.axis = (axes.transpose() * limited.axis).normalized();
      cone.angle = limited.angle;
      found_.cones.push_back({limited.joint, cone});
    }
  }

  std::optional<UniversalAxis> universal_axis(const Pivot& pivot, double sense) const {
    if (pivot.kind != PivotKind::revolute || !pivot.variable) return std::nullopt;
    const JointLimits limits = is_limited(*pivot.variable) ? joint(*pivot.variable).limits : JointLimits{};
    return UniversalAxis{joint(*pivot.variable).name, sense * pivot.sense * pivot.axis, value(pivot), limits};
  }

  // Of what the axes of cones at the base end are given in (see BallJointCone), in the base frame.
  Eigen::Matrix3d base_axes(const Leg& leg, const SplitChain& chain) const {
    const Eigen::Matrix3d task = motion_.task_frame.linear();
    const RevoluteActuation* crank = leg.crank();
    if (crank == nullptr) return task;
    const Vector3d along = (leg.proximal_point(value(chain.actuation)) - crank->center).normalized();
    Eigen::Matrix3d axes;
    axes << along, crank->axis.cross(along), crank->axis;
    return task * axes;
  }

  // The revolute joint of a group that turns nothing else, if it is limited.
  const Pivot* only_one(const Chain& group) const {
    if (group.size() != 1 || group.front().kind != PivotKind::revolute) return nullptr;
    const Pivot& pivot = group.front();
    return pivot.variable && is_limited(*pivot.variable) ? &pivot : nullptr;
  }

  double value(const Pivot& pivot) const { return values_[static_cast<Eigen::Index>(*pivot.variable)]; }

  void add(std::size_t leg, PassiveAngle angle, const Pivot& pivot, double now) {
    const double along_normal = pivot.axis.dot(motion_.task_frame.linear().col(2));
    const double sense = pivot.sense * std::copysign(1.0, along_normal);
    const TreeJoint& limited = joint(*pivot.variable);
    if (is_reported(limited.name)) return;
    found_.limits.push_back({limited.name, leg, angle, now - sense * value(pivot), sense, limited.limits});
  }

  const ClosureSystem& system_;
  const Eigen::VectorXd& values_;
  const PlatformMotion& motion_;
  Eigen::Isometry3d to_task_;
  FoundPassiveLimits found_;
};

}  // namespace

FoundPassiveLimits find_passive_limits(const ClosureSystem& system, const Eigen::VectorXd& values,
                                       const PlatformMotion& motion, const std::vector<RecognisedLeg>& legs,
                                       const std::vector<std::size_t>& bounded) {
  return Search(system, values, motion).run(legs, bounded);
}

}  // namespace parallel_aspects
