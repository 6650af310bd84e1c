// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_H

#include <memory>

#include "parallel_aspects/model/manipulator.h"

namespace parallel_aspects::test {

inline Leg planar_revolute_leg(const std::string& name, const Eigen::Vector2d& center, double crank,
                               double rod) {
  Leg leg;
  leg.name = name;
  leg.driven_joint = name + "_joint";
  leg.drive = RevoluteDrive{{center.x(), center.y(), 0.0}, Eigen::Vector3d::UnitZ(),
                            Eigen::Vector3d::UnitX(), crank};
  leg.rod_length = rod;
  return leg;
}

/// The paper's five-bar RR-RRR: A=(0,0), B=(9,0); leg 1: crank 8, rod 5; leg 2: crank 5, rod 8.
inline std::shared_ptr<const Manipulator> five_bar() {
  ManipulatorDescription description;
  description.name = "five_bar";
  description.task_space = TaskSpace::T2;
  description.legs = {planar_revolute_leg("leg_1", {0.0, 0.0}, 8.0, 5.0),
                      planar_revolute_leg("leg_2", {9.0, 0.0}, 5.0, 8.0)};
  return std::make_shared<const Manipulator>(description);
}

/// Bipod 2-RPR with base points (0,0) and (5,0) and struts limited to [2,6] and [4,9].
inline std::shared_ptr<const Manipulator> bipod() {
  ManipulatorDescription description;
  description.name = "bipod";
  description.task_space = TaskSpace::T2;
  for (const int j : {1, 2}) {
    Leg leg;
    leg.name = "leg_" + std::to_string(j);
    leg.driven_joint = leg.name + "_joint";
    leg.drive = StrutDrive{{j == 1 ? 0.0 : 5.0, 0.0, 0.0}};
    leg.limits = j == 1 ? JointLimits{2.0, 6.0} : JointLimits{4.0, 9.0};
    description.legs.push_back(leg);
  }
  return std::make_shared<const Manipulator>(description);
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_H
