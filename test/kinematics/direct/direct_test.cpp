// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/round_trip.h"
#include <limits>

namespace parallel_aspects {
namespace {

JointVector joint_values(std::initializer_list<double> values) {
  JointVector q(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), q.data());
  return q;
}

Pose planar(double x, double y, double phi) {
  Pose pose;
  pose.position << x, y, 0.0;
  pose.orientation = Eigen::AngleAxisd(phi, Eigen::Vector3d::UnitZ());
  return pose;
}

// Innocenti and Parenti-Castelli; three of their six, with det A of rows (u, A_i x u), which is ours with the
// columns in another order: an even one.
TEST(Direct, SixSolutionsOfThe3Rpr) {
  const auto robot = test::three_rpr();
  const DirectResult result = direct(*robot, joint_values({14.98, 15.38, 12.0}));
  ASSERT_EQ(result.status, DirectStatus::solved);
  ASSERT_EQ(result.solutions.size(), 6U);
  const std::vector<std::pair<Pose, double>> published{
      {planar(-8.72659533, 12.17566975, -0.98697424), -29158.46},
      {planar(-14.89612810, 1.58296166, 0.24530953), 9522.98},
      {planar(14.67394366, -3.01260312, 2.13290437), 39129.27}};
  for (const auto& [pose, determinant] : published) {
    const AssemblyMode* mode = test::closest(*robot, result, pose);
    EXPECT_LT(test::pose_distance(*robot, mode->pose, pose), 1e-7);
    EXPECT_NEAR(8.0 * mode->determinant, 8.0 * determinant, 0.1) << to_string(TaskSpace::SE2, pose);
    EXPECT_FALSE(mode->near_singular);
  }
}

TEST(Direct, IsSortedByFallingDeterminantAndRefined) {
  const DirectResult result = direct(*test::three_rpr(), joint_values({14.98, 15.38, 12.0}));
  for (const AssemblyMode& mode : result.solutions) EXPECT_LT(mode.residual, 1e-15);
  for (std::size_t i = 1; i < result.solutions.size(); ++i)
    EXPECT_LE(result.solutions[i].determinant, result.solutions[i - 1].determinant);
}

TEST(Direct, DeltaHasTwoSolutionsThatMirrorEachOtherInThePlaneOfTheElbows) {
  const auto robot = test::delta();
  const DirectResult result = direct(*robot, joint_values({0.3, 0.3, 0.3}));
  ASSERT_EQ(result.status, DirectStatus::solved);
  ASSERT_EQ(result.solutions.size(), 2U);
  EXPECT_NEAR(result.solutions[0].pose.position.z() + result.solutions[1].pose.position.z(),
              2.0 * -0.235 * std::sin(0.3), 1e-12);
  EXPECT_EQ(working_modes(*robot).size(), 8U);
}

TEST(Direct, OutOfReachIsSolvedWithNoSolution) {
  EXPECT_EQ(direct(*test::bipod(), joint_values({2.0, 2.0})).status, DirectStatus::solved);
  EXPECT_TRUE(direct(*test::bipod(), joint_values({2.0, 2.0})).solutions.empty());
  const DirectResult planar_result = direct(*test::three_rpr(), joint_values({1.0, 1.0, 100.0}));
  EXPECT_EQ(planar_result.status, DirectStatus::solved);
  EXPECT_TRUE(planar_result.solutions.empty());
}

TEST(Direct, AbsurdDrivesEndAtOnce) {
  for (const auto& robot : {test::bipod(), test::three_rpr(), test::three_prr(), test::linear_delta(),
                            test::dietmaier(), test::six_pus()})
    for (const double value : {1e20, 1e40, 1e100, 1e160, 1e308}) {
      const auto n = static_cast<Eigen::Index>(robot->leg_count());
      const DirectResult result = direct(*robot, JointVector::Constant(n, value));
      for (const AssemblyMode& mode : result.solutions) EXPECT_TRUE(mode.pose.position.allFinite());
      if (value > 1e30) {
        EXPECT_EQ(result.status, DirectStatus::unsolved) << robot->name() << " at " << value;
      }
    }
}

TEST(Direct, StrutOfNegativeLengthDoesNotAssemble) {
  const DirectResult result = direct(*test::three_rpr(), joint_values({14.98, -15.38, 12.0}));
  EXPECT_EQ(result.status, DirectStatus::solved);
  EXPECT_TRUE(result.solutions.empty());
}

// Base points 5 apart, legs 2 and 3 or 9 and 4: the circles touch, from outside and from inside.
TEST(Direct, TouchingCirclesAreOneFlaggedSolution) {
  for (const auto& q :
       {joint_values({2.0, 3.0}), joint_values({9.0, 4.0}), joint_values({2.0, 3.0 - 1e-16})}) {
    const DirectResult result = direct(*test::bipod(), q);
    ASSERT_EQ(result.solutions.size(), 1U);
    EXPECT_TRUE(result.solutions[0].near_singular);
  }
}

TEST(Direct, WrongOrInfiniteDrivesAreUnsolved) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(direct(*test::three_rpr(), joint_values({1.0, nan, 1.0})).status, DirectStatus::unsolved);
  EXPECT_EQ(direct(*test::delta(), joint_values({1.0, inf, 1.0})).status, DirectStatus::unsolved);
  EXPECT_EQ(direct(*test::delta(), joint_values({1.0, 1.0})).status, DirectStatus::unsolved);
}

// Base and platform congruent, all lengths equal: the platform runs on a circle.
TEST(Direct, ParallelogramIsAContinuum) {
  const test::Points corners = test::on_circle(1.0, {0.0, 100.0, 250.0});
  const auto robot = test::manipulator("parallelogram", TaskSpace::SE2, test::struts(corners, corners));
  EXPECT_EQ(direct(*robot, joint_values({0.7, 0.7, 0.7})).status, DirectStatus::continuum);
}

// All anchors in one point that the legs can meet: the platform spins about it.
TEST(Direct, PlatformOnOnePointIsAContinuumWhereTheLegsMeet) {
  const Eigen::Vector3d anchor(0.3, 0.1, 0.0);
  const auto robot =
      test::manipulator("one point", TaskSpace::SE2,
                        test::struts(test::on_circle(1.0, {0.0, 120.0, 240.0}), test::Points(3, anchor)));
  EXPECT_EQ(direct(*robot, joint_values({1.0, 1.0, 1.0})).status, DirectStatus::continuum);
  EXPECT_EQ(direct(*robot, joint_values({1.0, 1.0, 1.2})).status, DirectStatus::solved);
}

TEST(Direct, DeltaWithCoincidingSpheresIsAContinuum) {
  const test::Points corners = test::on_circle(1.0, {0.0, 120.0, 240.0});
  const auto robot = test::manipulator("one sphere", TaskSpace::T3, test::struts(corners, corners));
  EXPECT_EQ(direct(*robot, joint_values({0.5, 0.5, 0.5})).status, DirectStatus::continuum);
  EXPECT_EQ(direct(*robot, joint_values({0.5, 0.5, 0.6})).status, DirectStatus::solved);
}

// Bonev, Chablat and Wenger, "Working and assembly modes of the Agile Eye": eight working modes; of the eight
// direct solutions four are trivial, with the platform axes along the base axes whatever the actuated joints
// (all B_jj = 0), and four are assembly modes.
TEST(Direct, AgileEyeHasFourAssemblyModesBesidesTheTrivialOnes) {
  const auto robot = test::agile_eye();
  EXPECT_EQ(working_modes(*robot).size(), 8U);
  test::RandomRobots random(7);
  for (int i = 0; i < 1000; ++i) {
    const JointVector q =
        joint_values({random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)});
    const DirectResult result = direct(*robot, q);
    ASSERT_EQ(result.status, DirectStatus::solved);
    ASSERT_EQ(result.solutions.size(), 8U) << q.transpose();
    const auto trivial = [&](const AssemblyMode& mode) {
      return inverse_diagonal(*robot, mode.pose, q).cwiseAbs().maxCoeff() < 1e-7;
    };
    EXPECT_EQ(std::count_if(result.solutions.begin(), result.solutions.end(), trivial), 4) << q.transpose();
    for (const AssemblyMode& mode : result.solutions)
      EXPECT_EQ(mode.serially_singular, trivial(mode)) << q.transpose();
  }
}

// Dietmaier, "The Stewart-Gough platform of general geometry can have 40 real postures", 1998.
TEST(Direct, AllFortySolutionsOfDietmaier) {
  const DirectResult result = direct(*test::dietmaier(), test::dietmaier_lengths());
  EXPECT_EQ(result.status, DirectStatus::solved);
  EXPECT_EQ(result.solutions.size(), 40U);
  for (const AssemblyMode& mode : result.solutions) EXPECT_LT(mode.residual, 1e-13);
}

// With base and platform each in a plane, every solution has a mirror image in the plane of the base, with
// the base points and lengths the same and det A of the other sign: reflecting the base plane and the
// platform's own plane.
TEST(Direct, PlanarStewartPlatformsHaveMirrorPairs) {
  for (const auto& robot : {test::planar_stewart(), test::stewart(), test::octahedral_stewart()}) {
    test::RandomRobots random(11);
    for (int i = 0; i < 20; ++i) {
      Pose pose = random.pose(TaskSpace::SE3, 0.3);
      pose.position.z() += 0.6;
      const JointVector q = inverse(*robot, pose, WorkingMode(6)).q;
      const DirectResult result = direct(*robot, q);
      SCOPED_TRACE(test::describe(*robot, pose, q));
      ASSERT_EQ(result.status, DirectStatus::solved);
      EXPECT_EQ(result.solutions.size() % 2, 0U);
      for (const AssemblyMode& mode : result.solutions) {
        const Eigen::Quaterniond& e = mode.pose.orientation;
        Pose mirrored{mode.pose.position, Eigen::Quaterniond(e.w(), -e.x(), -e.y(), e.z())};
        mirrored.position.z() *= -1.0;
        const AssemblyMode* found = test::closest(*robot, result, mirrored);
        ASSERT_NE(found, nullptr);
        EXPECT_LT(test::pose_distance(*robot, found->pose, mirrored), 1e-8);
        EXPECT_NEAR(found->determinant, -mode.determinant, 1e-12);
      }
    }
  }
}

// Base and platform congruent, all lengths equal: the platform translates on a sphere, parallel to itself.
TEST(Direct, CongruentStewartPlatformIsNotSolvedInSilence) {
  const test::Points corners = test::on_circle(0.5, {0.0, 50.0, 130.0, 170.0, 250.0, 300.0});
  const auto robot = test::manipulator("congruent", TaskSpace::SE3, test::struts(corners, corners));
  EXPECT_NE(direct(*robot, joint_values({0.7, 0.7, 0.7, 0.7, 0.7, 0.7})).status, DirectStatus::solved);
}

}  // namespace
}  // namespace parallel_aspects
