// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_problem.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/round_trip.h"
#include <tuple>

namespace parallel_aspects {
namespace {

using SpaceAndActuation = std::tuple<TaskSpace, test::ActuationKind>;

class Completeness : public testing::TestWithParam<SpaceAndActuation> {};

std::size_t max_solutions(TaskSpace space) {
  switch (space) {
    case TaskSpace::T1:
    case TaskSpace::T2:
    case TaskSpace::T3:
    case TaskSpace::R1:
      return 2;
    case TaskSpace::SE2:
      return 6;
    case TaskSpace::SO3:
    case TaskSpace::R2:
      return 8;
    case TaskSpace::SE3:
      return 40;
  }
  return 0;
}

// A second method: whatever Newton's method finds from random poses must be in the list.
void check_against_newton(const Manipulator& robot, const JointVector& q, const DirectResult& result,
                          test::RandomRobots& random, int starts) {
  for (int i = 0; i < starts; ++i) {
    const Refinement found = refined(robot, random.pose(robot.motions(), 2.0), q);
    if (found.residual > 1e-14 || found.singular_value < 1e-4) continue;
    const AssemblyMode* mode = test::closest(robot, result, found.pose);
    ASSERT_NE(mode, nullptr) << test::describe(robot, found.pose, q);
    ASSERT_LT(test::pose_distance(robot, mode->pose, found.pose), 1e-8)
        << test::describe(robot, found.pose, q);
  }
}

TEST_P(Completeness, NewtonFromRandomPosesFindsNothingElse) {
  const auto [space, kind] = GetParam();
  const bool slow = space == TaskSpace::SE3;
  test::RandomRobots random(20260109);
  int tested = 0;
  for (int i = 0; i < 20000 && tested < (slow ? 20 : 300); ++i) {
    const auto robot = random.robot(space, kind);
    const Pose pose = random.pose(robot->motions());
    const InverseSolution solution = inverse(*robot, pose, working_modes(*robot).back());
    if (solution.status == InverseStatus::out_of_reach) continue;
    ++tested;
    const DirectResult result = direct(*robot, solution.q);
    ASSERT_EQ(result.status, DirectStatus::solved) << test::describe(*robot, pose, solution.q);
    ASSERT_LE(result.solutions.size(), max_solutions(space)) << test::describe(*robot, pose, solution.q);
    ASSERT_EQ(result.solutions.size() % 2, 0U) << test::describe(*robot, pose, solution.q);
    check_against_newton(*robot, solution.q, result, random, slow ? 100 : 30);
  }
  EXPECT_GT(tested, slow ? 15 : 100);
}

std::string case_name(const testing::TestParamInfo<SpaceAndActuation>& info) {
  static const char* const kinds[] = {"revolute", "prismatic", "strut", "elbow"};
  return std::string(name(std::get<0>(info.param))) + "_" + kinds[static_cast<int>(std::get<1>(info.param))];
}

INSTANTIATE_TEST_SUITE_P(EverySpaceAndActuation, Completeness,
                         testing::Combine(testing::ValuesIn(test::all_task_spaces),
                                          testing::ValuesIn(test::all_actuation_kinds)),
                         case_name);

}  // namespace
}  // namespace parallel_aspects
