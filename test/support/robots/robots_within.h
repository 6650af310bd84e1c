// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ROBOTS_WITHIN_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ROBOTS_WITHIN_H

#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Core>

#include <algorithm>
#include <memory>
#include <random>
#include <variant>

namespace parallel_aspects::test {

/// Builds robots whose points and lengths differ from those of a description by at most a tolerance [m].
class RobotsWithin {
 public:
  RobotsWithin(double tolerance, std::mt19937_64& random) : tolerance_(tolerance), random_(random) {}

  std::shared_ptr<const Manipulator> draw(const Manipulator& described) {
    ManipulatorDescription description = described.description();
    for (Leg& leg : description.legs) {
      leg.tolerance = 0.0;
      move(leg.anchor);
      if (leg.rod_length > 0.0) change(leg.rod_length);
      std::visit([this](auto& actuation) { build(actuation); }, leg.actuation);
    }
    return std::make_shared<const Manipulator>(std::move(description));
  }

 private:
  // Half of them as far as they may, in which a proof that is too bold shows first.
  double share() {
    const double drawn = std::uniform_real_distribution<double>(-2.0, 2.0)(random_);
    return std::max(-1.0, std::min(1.0, drawn));
  }
  void change(double& length) { length += tolerance_ * share(); }
  void move(Eigen::Vector3d& point) {
    std::normal_distribution<double> each;
    const Eigen::Vector3d direction(each(random_), each(random_), each(random_));
    point += tolerance_ * share() * direction.normalized();
  }

  void build(RevoluteActuation& crank) {
    move(crank.center);
    change(crank.radius);
  }
  void build(PrismaticActuation& rail) { move(rail.origin); }
  void build(StrutActuation& strut) {
    move(strut.base);
    change(strut.length_at_zero);
  }
  void build(ElbowActuation& elbow) {
    move(elbow.base);
    change(elbow.inner_length);
    change(elbow.outer_length);
  }

  double tolerance_;
  std::mt19937_64& random_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ROBOTS_WITHIN_H
