// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/round_trip.h"
#include "support/thoroughness.h"
#include <ostream>

namespace parallel_aspects {
namespace {

struct Case {
  std::shared_ptr<const Manipulator> robot;
  Eigen::Vector3d home;
  double spread;
  std::size_t max_solutions;
  int count = 10000;

  friend std::ostream& operator<<(std::ostream& out, const Case& each) { return out << each.robot->name(); }
};

class RoundTrip : public testing::TestWithParam<Case> {};

// Pose -> actuated joints in a random working mode -> all direct solutions contain the pose.
TEST_P(RoundTrip, FindsThePoseAgain) {
  const auto& [robot, home, spread, max_solutions, all] = GetParam();
  const int count = test::thinned(all);
  Pose center;
  center.position = home;
  const test::RoundTrips trips = test::round_trips(*robot, center, spread, count, 20260101);
  EXPECT_EQ(trips.made, count);
  EXPECT_EQ(trips.missed, 0) << trips.first_miss;
  EXPECT_EQ(trips.unsolved, 0) << trips.first_miss;
  EXPECT_EQ(trips.continuum, 0);
  EXPECT_LE(trips.max_solutions, max_solutions);
  EXPECT_LT(trips.worst_residual, 1e-12);
}

std::string robot_name(const testing::TestParamInfo<Case>& info) { return info.param.robot->name(); }

INSTANTIATE_TEST_SUITE_P(T2, RoundTrip,
                         testing::Values(Case{test::five_bar(), {4.0, 0.0, 0.0}, 12.0, 2},
                                         Case{test::bipod(), {2.0, 0.0, 0.0}, 9.0, 2}),
                         robot_name);
INSTANTIATE_TEST_SUITE_P(SE2, RoundTrip,
                         testing::Values(Case{test::three_rpr(), {5.0, 5.0, 0.0}, 25.0, 6},
                                         Case{test::three_rrr(), {-3.0, -3.0, 0.0}, 25.0, 6},
                                         Case{test::three_rrr_actuated_elbow(), {-3.0, -3.0, 0.0}, 25.0, 6},
                                         Case{test::three_prr(), {0.0, 0.0, 0.0}, 0.8, 6}),
                         robot_name);
INSTANTIATE_TEST_SUITE_P(T3, RoundTrip,
                         testing::Values(Case{test::delta(), {0.0, 0.0, -0.6}, 0.8, 2},
                                         Case{test::linear_delta(), {0.0, 0.0, 0.0}, 0.4, 2}),
                         robot_name);
INSTANTIATE_TEST_SUITE_P(SO3, RoundTrip,
                         testing::Values(Case{test::agile_eye(), {0.0, 0.0, 0.0}, 1.0, 8},
                                         Case{test::spherical_three_rrr(), {0.0, 0.0, 0.0}, 1.0, 8}),
                         robot_name);
INSTANTIATE_TEST_SUITE_P(R1, RoundTrip,
                         testing::Values(Case{test::four_bar(), {0.0, 0.0, 0.0}, 1.0, 2, 100000}),
                         robot_name);
INSTANTIATE_TEST_SUITE_P(R2, RoundTrip, testing::Values(Case{test::ankle(), {0.0, 0.0, 0.0}, 1.0, 8, 100000}),
                         robot_name);
// Six degrees of freedom take milliseconds each; the benchmark of the kinematics makes 10,000 of them.
INSTANTIATE_TEST_SUITE_P(SE3, RoundTrip,
                         testing::Values(Case{test::dietmaier(), {0.0, 0.0, 0.0}, 1.0, 40, 100},
                                         Case{test::planar_stewart(), {0.0, 0.0, 0.6}, 0.3, 40, 100},
                                         Case{test::stewart(), {0.0, 0.0, 0.6}, 0.3, 28, 100},
                                         Case{test::octahedral_stewart(), {0.0, 0.0, 0.6}, 0.3, 16, 100},
                                         Case{test::hexa(), {0.0, 0.0, -0.5}, 0.3, 40, 100},
                                         Case{test::six_pus(), {0.0, 0.0, 0.6}, 0.2, 40, 100}),
                         robot_name);

}  // namespace
}  // namespace parallel_aspects
