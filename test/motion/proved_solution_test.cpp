// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "motion/assembly_survey.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/random_robots.h"
#include <cmath>

namespace parallel_aspects {
namespace {

/// How far joint values are apart [rad or m]; whole turns do not count.
double apart(const Manipulator& robot, const JointVector& a, const JointVector& b) {
  double most = 0.0;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    const double difference = a[i] - b[i];
    const bool turns = robot.leg(j).actuated_by_angle();
    constexpr double turn = 2.0 * EIGEN_PI;
    most = std::max(most, std::abs(turns ? std::remainder(difference, turn) : difference));
  }
  return most;
}

Pose moved(const Manipulator& robot, const Pose& pose, double distance, test::RandomRobots& random) {
  TaskVector twist(static_cast<Eigen::Index>(robot.leg_count()));
  for (double& entry : coefficients_of(twist)) entry = random.uniform(-1.0, 1.0);
  twist *= distance / twist.norm();
  twist.head(static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot.task_space()))) /=
      robot.characteristic_length();
  return displaced(robot.motions(), pose, twist);
}

// Robots and configurations at random, in every task space and with every kind of leg. What is proved from a
// pose some way beside is that of the inverse problem, and poses in its ball have that sign of det A.
TEST(ProvedSolution, IsThatOfTheInverseProblem) {
  test::RandomRobots random(31);
  int tried = 0, proved = 0;
  for (int i = 0; i < 60; ++i)
    for (const TaskSpace space : test::all_task_spaces)
      for (const test::ActuationKind kind : test::all_actuation_kinds) {
        const auto robot = random.robot(space, kind);
        const Pose pose = random.pose(robot->motions());
        const WorkingMode mode = working_modes(*robot).back();
        const InverseSolution given = inverse(*robot, pose, mode);
        if (!given || test::sign_in_doubles(*robot, pose, mode) == 0) continue;
        ++tried;
        const SolutionProver prover{SegmentCertifier(robot)};
        const auto solution = prover.prove(given.q, moved(*robot, pose, 1e-7 * robot->size(), random));
        if (!solution) continue;
        const InverseSolution found = inverse(*robot, solution->pose, solution->mode);
        ASSERT_TRUE(found) << robot->name() << ' ' << to_string(space, pose);
        ASSERT_LT(apart(*robot, found.q, given.q), 1e-10 * std::max(1.0, robot->size())) << robot->name();
        for (int k = 0; k < 10; ++k) {
          const double away = solution->radius * random.uniform(0.0, 1.0);
          ASSERT_EQ(
              test::sign_in_doubles(*robot, moved(*robot, solution->pose, away, random), solution->mode),
              solution->determinant_sign)
              << robot->name() << ' ' << to_string(space, pose);
        }
        ++proved;
      }
  EXPECT_GT(tried, 300);
  EXPECT_GT(proved, 0.9 * tried) << "of " << tried;
}

// Values that no pose near by has are not proved to be its.
TEST(ProvedSolution, KnowsWhichValuesAPoseHas) {
  test::RandomRobots random(32);
  int far = 0, near = 0, known = 0;
  for (int i = 0; i < 60; ++i)
    for (const TaskSpace space : test::all_task_spaces)
      for (const test::ActuationKind kind : test::all_actuation_kinds) {
        const auto robot = random.robot(space, kind);
        CertifiedPoint point;
        point.pose = random.pose(robot->motions());
        const InverseSolution given = inverse(*robot, point.pose, working_modes(*robot).back());
        if (!given) continue;
        const PoseCertifier certifier(*robot);
        const TaskVector allowance = TaskVector::Constant(given.q.size(), 1e-8);
        const auto leg = static_cast<Eigen::Index>(random.uniform(0.0, 0.999 * given.q.size()));
        const RoundingUpward rounding;
        point.q = given.q;
        ++near;
        known += certifier.assembles_within(point, allowance);
        point.q[leg] += 1.1e-8;
        EXPECT_FALSE(certifier.assembles_within(point, allowance)) << robot->name();
        point.q[leg] -= 2.2e-8;
        EXPECT_FALSE(certifier.assembles_within(point, allowance)) << robot->name();
        ++far;
      }
  EXPECT_GT(far, 300);
  EXPECT_GT(known, 0.95 * near) << "of " << near;
}

}  // namespace
}  // namespace parallel_aspects
