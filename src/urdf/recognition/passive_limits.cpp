// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/passive_limits.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

double direction_of(const Vector3d& vector) { return std::atan2(vector.y(), vector.x()); }

class Search {
 public:
  Search(const ClosureSystem& system, const Eigen::VectorXd& values, const PlatformMotion& motion)
      : system_(system), values_(values), motion_(motion), to_task_(motion.task_frame.inverse()) {}

  FoundPassiveLimits run(const std::vector<RecognisedLeg>& legs) {
    for (std::size_t j = 0; j < legs.size(); ++j)
      if (is_planar(motion_.space) && !std::holds_alternative<ElbowActuation>(legs[j].leg.actuation))
        for (const SplitChain& chain : legs[j].chains) add(j, legs[j].leg, chain);
    for (std::size_t variable = 0; variable < system_.in_loop().size(); ++variable)
      if (is_limited(variable) && !is_actuated(variable, legs) && !is_reported(joint(variable).name))
        found_.missing.push_back(joint(variable).name);
    return std::move(found_);
  }

 private:
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
    return std::any_of(found_.limits.begin(), found_.limits.end(),
                       [&name](const PassiveLimit& limit) { return limit.joint == name; });
  }

  void add(std::size_t index, const Leg& leg, const SplitChain& chain) {
    const Vector3d rod = to_task_.linear() * (chain.p - chain.c);
    if (const Pivot* pivot = only_one(chain.proximal)) {
      const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation);
      const double from =
          crank != nullptr ? direction_of(leg.proximal_point(value(chain.actuation)) - crank->center) : 0.0;
      add(index, crank != nullptr ? PassiveAngle::crank_to_rod : PassiveAngle::base_to_rod, *pivot,
          direction_of(rod) - from);
    }
    const Pivot* pivot = only_one(chain.distal);
    if (pivot == nullptr || motion_.point_platform) return;
    const Vector3d heading = has_rotation(motion_.space)
                                 ? Vector3d(to_task_.linear() * motion_.platform.linear().col(0))
                                 : Vector3d(Vector3d::UnitX());
    add(index, PassiveAngle::rod_to_platform, *pivot, direction_of(heading) - direction_of(rod));
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
                                       const PlatformMotion& motion, const std::vector<RecognisedLeg>& legs) {
  return Search(system, values, motion).run(legs);
}

}  // namespace parallel_aspects
