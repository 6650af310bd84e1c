// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/charts.h"

#include "aspects/boxes/box_classifier.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include <array>
#include <optional>

namespace parallel_aspects {
namespace {

class ReachablePositions : public testing::TestWithParam<test::SpaceAndActuation> {};

// Maps search for poses nowhere else. Rails of random robots point every way.
TEST_P(ReachablePositions, HoldEveryPoseThatAllLegsReach) {
  const auto& [space, kind] = GetParam();
  test::RandomRobots random(20261128);
  int reached = 0;
  for (int i = 0; i < 300; ++i) {
    const auto robot = random.robot(space, kind);
    const auto modes = working_modes(*robot);
    const std::optional<Box> box = make_box_classifier(*robot, modes)->reachable_positions();
    if (!box) continue;
    for (int k = 0; k < 50; ++k) {
      const Pose pose = random.pose(space, 3.0);
      if (!inverse(*robot, pose, modes.front())) continue;
      ++reached;
      ASSERT_TRUE(box->contains({pose.position.x(), pose.position.y(), pose.position.z()}))
          << to_string(space, pose) << " of number " << i << ", x from " << box->lower[0] << " to "
          << box->upper[0];
    }
  }
  EXPECT_GT(reached, 100);
}

constexpr std::array kinds_that_end{test::ActuationKind::revolute, test::ActuationKind::elbow};

// A rail has no end, but in T1 one across the slide has an end to what it reaches.
INSTANTIATE_TEST_SUITE_P(OfRails, ReachablePositions,
                         testing::Values(test::SpaceAndActuation{TaskSpace::T1,
                                                                 test::ActuationKind::prismatic}),
                         test::space_and_actuation_name);
INSTANTIATE_TEST_SUITE_P(OfCranks, ReachablePositions,
                         testing::Combine(testing::Values(TaskSpace::T1, TaskSpace::T2, TaskSpace::SE2,
                                                          TaskSpace::T3),
                                          testing::ValuesIn(kinds_that_end)),
                         test::space_and_actuation_name);

}  // namespace
}  // namespace parallel_aspects
