// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_RANDOM_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_RANDOM_ROBOTS_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <gtest/gtest.h>

#include "support/robots.h"
#include <array>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace parallel_aspects::test {

inline constexpr std::array<TaskSpace, 6> all_task_spaces{TaskSpace::T1, TaskSpace::T2,  TaskSpace::SE2,
                                                          TaskSpace::T3, TaskSpace::SO3, TaskSpace::SE3};

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

  Eigen::Vector3d vector(bool planar = false) {
    const double x = uniform(-1.0, 1.0), y = uniform(-1.0, 1.0), z = uniform(-1.0, 1.0);
    return {x, y, planar ? 0.0 : z};
  }

  Eigen::Quaterniond orientation() {
    std::normal_distribution<double> normal;
    const double x = normal(engine_), y = normal(engine_), z = normal(engine_), w = normal(engine_);
    return Eigen::Quaterniond(w, x, y, z).normalized();
  }

  Pose pose(TaskSpace space, double spread = 1.0) {
    Pose result;
    if (has_translation(space)) result.position = spread * vector(is_planar(space));
    if (space == TaskSpace::T1) result.position.y() = 0.0;
    if (space == TaskSpace::SE2)
      result.orientation = Eigen::AngleAxisd(uniform(-EIGEN_PI, EIGEN_PI), Eigen::Vector3d::UnitZ());
    if (space == TaskSpace::SO3 || space == TaskSpace::SE3) result.orientation = orientation();
    return result;
  }

  Actuation actuation(ActuationKind kind, bool planar) {
    const Eigen::Vector3d axis = planar ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(vector().normalized());
    switch (kind) {
      case ActuationKind::revolute:
        return RevoluteActuation{vector(planar), axis, axis.unitOrthogonal(), uniform(0.5, 1.5)};
      case ActuationKind::prismatic:
        return PrismaticActuation{vector(planar), vector(planar).normalized()};
      case ActuationKind::strut:
        return StrutActuation{vector(planar), uniform(0.0, 0.5), sense()};
      case ActuationKind::elbow:
        return ElbowActuation{vector(planar), uniform(0.5, 1.5), uniform(0.5, 1.5), uniform(-3.0, 3.0),
                              sense()};
    }
    return StrutActuation{vector(planar)};
  }

  std::shared_ptr<const Manipulator> robot(TaskSpace space, ActuationKind kind) {
    const bool planar = is_planar(space);
    std::vector<Leg> legs;
    for (std::size_t j = 0; j < degrees_of_freedom(space); ++j) {
      legs.push_back(named_leg(j));
      legs[j].actuation = actuation(kind, planar);
      legs[j].anchor = vector(planar);
      legs[j].rod_length = uniform(0.8, 2.0);
    }
    return manipulator("random " + std::string(name(space)), space, std::move(legs));
  }

 private:
  static bool is_planar(TaskSpace space) {
    return space == TaskSpace::T1 || space == TaskSpace::T2 || space == TaskSpace::SE2;
  }

  double sense() { return uniform(0.0, 1.0) < 0.5 ? 1.0 : -1.0; }

  std::mt19937 engine_;
};

using SpaceAndActuation = std::tuple<TaskSpace, ActuationKind>;

/// Of a parametrised test.
inline std::string space_and_actuation_name(const testing::TestParamInfo<SpaceAndActuation>& info) {
  static const char* const kinds[] = {"revolute", "prismatic", "strut", "elbow"};
  return std::string(name(std::get<0>(info.param))) + "_" + kinds[static_cast<int>(std::get<1>(info.param))];
}

/// A planar robot whose workspace limits bind and, where asked for, those of actuated joints too.
inline std::shared_ptr<const Manipulator> bounded_robot(unsigned seed, TaskSpace space, bool limited) {
  RandomRobots random(seed);
  ManipulatorDescription description = random.robot(space, all_actuation_kinds[seed % 3])->description();
  WorkspaceBox box;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double middle = random.uniform(-0.7, 0.7), half = random.uniform(0.2, 1.2);
    box.lower[i] = middle - half;
    box.upper[i] = middle + half;
  }
  description.constraints.workspace = box;
  for (Leg& leg : description.legs) {
    if (!limited || random.uniform(0.0, 1.0) >= 0.7) continue;
    const double middle = random.uniform(-2.0, 2.0), half = random.uniform(0.3, 1.5);
    const bool is_strut = leg.kind().type == LegType::strut;
    leg.limits =
        is_strut ? JointLimits{0.5 * half, 0.5 * half + 1.0} : JointLimits{middle - half, middle + half};
  }
  return std::make_shared<const Manipulator>(description);
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_RANDOM_ROBOTS_H
