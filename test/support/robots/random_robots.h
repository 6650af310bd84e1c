// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_RANDOM_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_RANDOM_ROBOTS_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include "support/robots/robots.h"
#include <array>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace parallel_aspects::test {

inline constexpr std::array<TaskSpace, 8> all_task_spaces{TaskSpace::T1, TaskSpace::T2,  TaskSpace::SE2,
                                                          TaskSpace::T3, TaskSpace::SO3, TaskSpace::SE3,
                                                          TaskSpace::R1, TaskSpace::R2};

enum class ActuationKind { revolute, prismatic, strut, elbow };
inline constexpr std::array<ActuationKind, 4> all_actuation_kinds{
    ActuationKind::revolute, ActuationKind::prismatic, ActuationKind::strut, ActuationKind::elbow};

/// Seeded random poses and general geometry. A planar task space (T1, T2, SE2) gets planar robots.
class RandomRobots {
 public:
  explicit RandomRobots(unsigned seed) : engine_(seed) {}

  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine_);
  }

  Eigen::Vector3d vector(bool planar = false);

  Eigen::Quaterniond orientation();

  /// Of R2, `motions` must be those of a robot.
  Pose pose(const Motions& motions, double spread = 1.0);

  Actuation actuation(ActuationKind kind, bool planar);

  std::shared_ptr<const Manipulator> robot(TaskSpace space, ActuationKind kind);

 private:
  static bool is_planar(TaskSpace space);

  double sense() { return uniform(0.0, 1.0) < 0.5 ? 1.0 : -1.0; }

  std::mt19937 engine_;
};

using SpaceAndActuation = std::tuple<TaskSpace, ActuationKind>;

/// The name of a case of a parametrized test, for gtest's TestParamInfo.
struct SpaceAndActuationName {
  template <class Info>
  std::string operator()(const Info& info) const {
    static const char* const kinds[] = {"revolute", "prismatic", "strut", "elbow"};
    return std::string(name(std::get<0>(info.param))) + "_" +
           kinds[static_cast<int>(std::get<1>(info.param))];
  }
};
inline constexpr SpaceAndActuationName space_and_actuation_name;

/// A planar robot whose workspace limits bind and, where asked for, those of actuated joints too.
std::shared_ptr<const Manipulator> bounded_robot(unsigned seed, TaskSpace space, bool limited);

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_RANDOM_ROBOTS_H
