// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/round_trip.h"
#include <algorithm>
#include <tuple>

namespace parallel_aspects {
namespace {

class Jacobians : public testing::TestWithParam<test::SpaceAndActuation> {};

constexpr double step = 1e-5;
constexpr double tolerance = 1e-8;

// df/dX = 2 A, by central differences along each column's motion.
TaskMatrix differences_by_pose(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  const auto n = static_cast<Eigen::Index>(robot.leg_count());
  TaskMatrix result(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const TaskVector twist = step * TaskVector::Unit(n, k);
    const Pose ahead = displaced(robot.motions(), pose, twist);
    const Pose behind = displaced(robot.motions(), pose, -twist);
    result.col(k) = (residuals(robot, ahead, q) - residuals(robot, behind, q)) / (4.0 * step);
  }
  return result;
}

// df/dq = -2 B, entry by entry: f_j depends on no other actuated joint, so a full matrix of differences must
// be diagonal.
TaskMatrix differences_by_joint(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  const auto n = static_cast<Eigen::Index>(robot.leg_count());
  TaskMatrix result(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const JointVector change = step * JointVector::Unit(n, k);
    result.col(k) = (residuals(robot, pose, q + change) - residuals(robot, pose, q - change)) / (-4.0 * step);
  }
  return result;
}

TEST_P(Jacobians, MatchCentralDifferences) {
  const auto [space, kind] = GetParam();
  test::RandomRobots random(20260102);
  for (int i = 0; i < 2000; ++i) {
    const auto robot = random.robot(space, kind);
    const Pose pose = random.pose(robot->motions());
    JointVector q(static_cast<Eigen::Index>(robot->leg_count()));
    for (double& each : coefficients_of(q)) each = random.uniform(-2.0, 2.0);
    const TaskMatrix a = direct_matrix(*robot, pose, q);
    const TaskMatrix b = inverse_diagonal(*robot, pose, q).asDiagonal().toDenseMatrix();
    ASSERT_LT((a - differences_by_pose(*robot, pose, q)).cwiseAbs().maxCoeff(), tolerance)
        << test::describe(*robot, pose, q);
    ASSERT_LT((b - differences_by_joint(*robot, pose, q)).cwiseAbs().maxCoeff(), tolerance)
        << test::describe(*robot, pose, q);
  }
}

// A t = B q': along a motion that all legs follow, the actuated joints run as the matrices say.
TEST_P(Jacobians, RelateVelocities) {
  const auto [space, kind] = GetParam();
  test::RandomRobots random(20260103);
  int compared = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto robot = random.robot(space, kind);
    const Pose pose = random.pose(robot->motions());
    const auto n = static_cast<Eigen::Index>(robot->leg_count());
    TaskVector twist(n);
    for (double& each : coefficients_of(twist)) each = random.uniform(-1.0, 1.0);
    const WorkingMode mode = working_modes(*robot).back();
    const InverseSolution here = inverse(*robot, pose, mode);
    const InverseSolution ahead = inverse(*robot, displaced(robot->motions(), pose, step * twist), mode);
    const InverseSolution behind = inverse(*robot, displaced(robot->motions(), pose, -step * twist), mode);
    if (here.status != InverseStatus::solved || ahead.q.size() != n || behind.q.size() != n) continue;
    const TaskVector b = inverse_diagonal(*robot, pose, here.q);
    if (b.cwiseAbs().minCoeff() < 0.2) continue;
    ++compared;
    TaskVector rate = ahead.q - behind.q;
    if (robot->leg(0).actuated_by_angle())
      for (double& each : coefficients_of(rate)) each = std::remainder(each, 2.0 * EIGEN_PI);
    const TaskVector left = direct_matrix(*robot, pose, here.q) * twist;
    const TaskVector right = b.cwiseProduct(rate / (2.0 * step));
    ASSERT_LT((left - right).cwiseAbs().maxCoeff(), 1e-5) << test::describe(*robot, pose, here.q);
  }
  EXPECT_GT(compared, 50);
}

// What the kind of a leg and `largest_entry` say, on random robots.
TEST_P(Jacobians, HaveEntriesOfBUpToTheLargest) {
  const auto [space, kind] = GetParam();
  test::RandomRobots random(20260104);
  double largest_share = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const auto robot = random.robot(space, kind);
    const Pose pose = random.pose(robot->motions());
    const InverseSolution found = inverse(*robot, pose, working_modes(*robot).front());
    if (found.status != InverseStatus::solved) continue;
    const TaskVector b = inverse_diagonal(*robot, pose, found.q);
    for (std::size_t j = 0; j < robot->leg_count(); ++j) {
      const Leg& leg = robot->leg(j);
      const double q = found.q[static_cast<Eigen::Index>(j)];
      EXPECT_TRUE(leg.can_have(q));
      EXPECT_EQ(leg.kind().moves_proximal_point, !leg.proximal_point_derivative(q).isZero(0.0));
      EXPECT_EQ(leg.kind().has_crank, leg.crank() != nullptr);
      EXPECT_EQ(leg.kind().bounded_by_links, std::isfinite(leg.longest_reach()));
      EXPECT_EQ(leg.kind().name == "strut", leg.largest_entry() == 0.0);
      if (leg.largest_entry() == 0.0) continue;
      const double share = std::abs(b[static_cast<Eigen::Index>(j)]) / leg.largest_entry();
      EXPECT_LE(share, 1.0 + 1e-9) << test::describe(*robot, pose, found.q);
      largest_share = std::max(largest_share, share);
    }
  }
  EXPECT_GT(largest_share, kind == test::ActuationKind::strut ? -1.0 : 0.9);
}

INSTANTIATE_TEST_SUITE_P(EverySpaceAndActuation, Jacobians,
                         testing::Combine(testing::ValuesIn(test::all_task_spaces),
                                          testing::ValuesIn(test::all_actuation_kinds)),
                         test::space_and_actuation_name);

}  // namespace
}  // namespace parallel_aspects
