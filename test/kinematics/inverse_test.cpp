// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/round_trip.h"
#include "support/thoroughness.h"
#include <tuple>

namespace parallel_aspects {
namespace {

class Inverse : public testing::TestWithParam<test::SpaceAndActuation> {};

// Every mode that can reach assembles with the pose, and has the signs of B that name it.
TEST_P(Inverse, AssemblesWithTheSignsOfItsMode) {
  const auto [space, kind] = GetParam();
  test::RandomRobots random(20260104);
  int solved = 0;
  for (int i = 0; i < test::thinned(2000); ++i) {
    const auto robot = random.robot(space, kind);
    const Pose pose = random.pose(robot->motions());
    for (const InverseSolution& solution : inverse_in_all_modes(*robot, pose)) {
      if (solution.status != InverseStatus::solved) continue;
      ++solved;
      const double residual = residuals(*robot, pose, solution.q).cwiseAbs().maxCoeff();
      ASSERT_LT(residual, 1e-12 * robot->size() * robot->size()) << test::describe(*robot, pose, solution.q);
      const TaskVector b = inverse_diagonal(*robot, pose, solution.q);
      for (Eigen::Index j = 0; j < b.size(); ++j)
        ASSERT_TRUE(std::abs(b[j]) < 1e-9 ||
                    (b[j] > 0.0) == (solution.mode.sign(static_cast<std::size_t>(j)) > 0))
            << test::describe(*robot, pose, solution.q) << " mode " << to_string(solution.mode);
    }
  }
  EXPECT_GT(solved, test::thinned(500));
}

// Where the squared entry of B is negative no joint value assembles: the best that a scan of the actuated
// joint reaches.
TEST_P(Inverse, OutOfReachMeansThatNoDriveValueAssembles) {
  const auto [space, kind] = GetParam();
  test::RandomRobots random(20260105);
  for (int i = 0; i < test::thinned(300); ++i) {
    const auto robot = random.robot(space, kind);
    const Pose pose = random.pose(robot->motions());
    const Leg& leg = robot->leg(0);
    const bool reachable = squared_inverse_entry(leg, pose.transform(leg.anchor)) >= 0.0;
    bool below = false, above = false;
    for (double q = -6.0; q <= 6.0; q += 1e-3) (leg.residual(pose, q) < 0.0 ? below : above) = true;
    EXPECT_EQ(reachable, below && above) << test::describe(*robot, pose, JointVector());
  }
}

INSTANTIATE_TEST_SUITE_P(EverySpaceAndActuation, Inverse,
                         testing::Combine(testing::ValuesIn(test::all_task_spaces),
                                          testing::ValuesIn(test::all_actuation_kinds)),
                         test::space_and_actuation_name);

TEST(InverseModes, AreAsManyAsTheFieldSays) {
  EXPECT_EQ(working_modes(*test::bipod()).size(), 1U);
  EXPECT_EQ(working_modes(*test::five_bar()).size(), 4U);
  EXPECT_EQ(working_modes(*test::three_rpr()).size(), 1U);
  EXPECT_EQ(working_modes(*test::three_rrr()).size(), 8U);
  EXPECT_EQ(working_modes(*test::delta()).size(), 8U);
  EXPECT_EQ(working_modes(*test::agile_eye()).size(), 8U);
  EXPECT_EQ(working_modes(*test::hexa()).size(), 64U);
  EXPECT_EQ(working_modes(*test::stewart()).size(), 1U);
}

}  // namespace
}  // namespace parallel_aspects
