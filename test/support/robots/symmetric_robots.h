// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SYMMETRIC_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SYMMETRIC_ROBOTS_H

#include "aspects/symmetry/rigid_symmetry.h"
#include "parallel_aspects/model/manipulator.h"

#include <Eigen/LU>

#include "support/robots/random_robots.h"
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace parallel_aspects::test {

/// Random robots that a given motion, its own inverse, takes onto themselves to the last digit: pairs of legs
/// that it exchanges, and one that it leaves where it is where the number is odd.
class SymmetricRobots {
 public:
  SymmetricRobots(unsigned seed, const Eigen::Matrix3d& motion) : random_(seed), motion_(motion) {}

  std::shared_ptr<const Manipulator> robot(TaskSpace space, ActuationKind kind, bool limited) {
    const bool planar = space == TaskSpace::T1 || space == TaskSpace::T2 || space == TaskSpace::SE2;
    std::vector<Leg> legs;
    while (legs.size() < degrees_of_freedom(space)) {
      Leg leg = named_leg(legs.size());
      leg.actuation = random_.actuation(kind, planar);
      leg.anchor = random_.vector(planar);
      leg.rod_length = random_.uniform(1.2, 2.0);
      if (limited) leg.limits = limits(kind);
      if (legs.size() + 1 == degrees_of_freedom(space)) {
        make_own_image(leg, planar);
        legs.push_back(leg);
      } else {
        legs.push_back(leg);
        legs.push_back(image(leg, named_leg(legs.size())));
      }
    }
    return manipulator("symmetric", space, std::move(legs));
  }

 private:
  JointLimits limits(ActuationKind kind) {
    if (kind == ActuationKind::strut) return {0.1, random_.uniform(1.0, 2.5)};
    return {random_.uniform(-2.0, -1.0), random_.uniform(1.0, 2.0)};
  }

  Eigen::Vector3d fixed(const Eigen::Vector3d& vector) const { return 0.5 * (vector + motion_ * vector); }

  /// A direction that is its own image or the opposite of it.
  Eigen::Vector3d own_direction(const Eigen::Vector3d& guess) const {
    const Eigen::Vector3d same = fixed(guess), opposite = 0.5 * (guess - motion_ * guess);
    return (same.norm() > opposite.norm() ? same : opposite).normalized();
  }

  /// Its limits must be the same both ways round; where no direction to count angles from is its own image
  /// there are none.
  void make_own_image(Leg& leg, bool planar) {
    leg.anchor = fixed(leg.anchor);
    leg.limits.upper = leg.limits.limited() && leg.limits.lower < 0.0 ? -leg.limits.lower : leg.limits.upper;
    if (auto* revolute = std::get_if<RevoluteActuation>(&leg.actuation)) {
      revolute->center = fixed(revolute->center);
      if (!planar) revolute->axis = own_direction(random_.vector());
      revolute->zero_direction = direction_across(revolute->axis, planar);
      if (motion_ * revolute->zero_direction != revolute->zero_direction) leg.limits = {};
    }
    if (auto* prismatic = std::get_if<PrismaticActuation>(&leg.actuation)) {
      prismatic->origin = fixed(prismatic->origin);
      prismatic->direction = own_direction(prismatic->direction);
    }
    if (auto* strut = std::get_if<StrutActuation>(&leg.actuation)) strut->base = fixed(strut->base);
    if (auto* elbow = std::get_if<ElbowActuation>(&leg.actuation)) {
      elbow->base = fixed(elbow->base);
      elbow->angle_at_zero = 0.0;
    }
  }

  /// One that is its own image, if there is one.
  Eigen::Vector3d direction_across(const Eigen::Vector3d& axis, bool planar) {
    const Eigen::Vector3d guess = fixed(random_.vector(planar));
    const Eigen::Vector3d across = guess - axis * axis.dot(guess);
    return across.norm() > 1e-3 ? Eigen::Vector3d(across.normalized()) : axis.unitOrthogonal();
  }

  Leg image(const Leg& leg, const Leg& named) {
    Leg result = leg;
    result.name = named.name;
    result.actuated_joint = named.actuated_joint;
    result.anchor = motion_ * leg.anchor;
    const bool around = random_.uniform(0.0, 1.0) < 0.5;
    bool reversed = false;
    if (auto* revolute = std::get_if<RevoluteActuation>(&result.actuation)) {
      revolute->center = motion_ * revolute->center;
      revolute->axis = motion_ * revolute->axis * (around ? -1.0 : 1.0);
      revolute->zero_direction = motion_ * revolute->zero_direction;
      reversed = around == (motion_.determinant() > 0.0);
    }
    if (auto* prismatic = std::get_if<PrismaticActuation>(&result.actuation)) {
      prismatic->origin = motion_ * prismatic->origin;
      prismatic->direction = motion_ * prismatic->direction * (around ? -1.0 : 1.0);
      reversed = around;
    }
    if (auto* strut = std::get_if<StrutActuation>(&result.actuation)) strut->base = motion_ * strut->base;
    if (auto* elbow = std::get_if<ElbowActuation>(&result.actuation)) elbow->base = motion_ * elbow->base;
    if (reversed) {
      result.limits.lower = -leg.limits.upper;
      result.limits.upper = -leg.limits.lower;
    }
    return result;
  }

  RandomRobots random_;
  Eigen::Matrix3d motion_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SYMMETRIC_ROBOTS_H
