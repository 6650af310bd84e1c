// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/clearance_at.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <random>
#include <regex>

namespace parallel_aspects {
namespace {

std::shared_ptr<const Mechanism> loaded(const std::string& robot, const std::string& constraints,
                                        const std::string& urdf = "") {
  return load_mechanism(urdf.empty() ? test::source_file("urdf/" + robot + ".urdf") : urdf, robot + ".urdf",
                        test::source_file("config/robots/" + robot + ".yaml") + "\n" + constraints,
                        robot + ".yaml");
}

// The URDF with limits on joints that turn freely.
std::string limited(const std::string& robot, const std::string& joints, double lower, double upper) {
  const std::string limit = "<limit lower=\"" + std::to_string(lower) + "\" upper=\"" +
                            std::to_string(upper) + "\" effort=\"1\" velocity=\"1\"/>";
  const std::regex free("<joint name=\"(" + joints + ")\" type=\"continuous\">");
  return std::regex_replace(test::source_file("urdf/" + robot + ".urdf"), free,
                            "<joint name=\"$1\" type=\"revolute\">" + limit);
}

TEST(ConstraintsConfig, IsReadWhole) {
  const auto mechanism = loaded("five_bar", R"(
constraints:
  thickness: {crank: 0.35, rod: 0.25, platform: 0.1}
  cones: [{leg: 2, end: base, axis: [3.0, 4.0], angle: 2.5}]
  self_collision: {ignore: [[rod_2, crank_1]]}
  obstacles:
    - {name: post, center: [4.5, 3.0], radius: 0.5}
    - {center: [1.0, -2.0], size: [2.0, 1.0], rotation: [0.5]}
  workspace: {lower: [0.0, 1.0], upper: [8.0, 9.0]}
  margins: {parallel: 0.05, serial: 0.1, det_a: 3.0}
)");
  const Constraints& found = mechanism->manipulator()->constraints();
  EXPECT_EQ(found.thickness.crank, 0.35);
  EXPECT_EQ(found.thickness.rod, 0.25);
  EXPECT_EQ(found.thickness.platform, 0.1);
  ASSERT_EQ(found.cones.size(), 1U);
  EXPECT_EQ(found.cones[0].leg, 1U);
  EXPECT_EQ(found.cones[0].end, LegEnd::base);
  EXPECT_LT((found.cones[0].axis - Eigen::Vector3d(0.6, 0.8, 0.0)).norm(), 1e-15);
  EXPECT_EQ(found.cones[0].angle, 2.5);
  ASSERT_TRUE(found.self_collision);
  ASSERT_EQ(found.self_collision->ignored.size(), 1U);
  EXPECT_EQ(to_string(found.self_collision->ignored[0][0]), "rod_2");
  EXPECT_EQ(to_string(found.self_collision->ignored[0][1]), "crank_1");
  EXPECT_EQ(found.margins.parallel, 0.05);
  EXPECT_EQ(found.margins.serial, 0.1);
  EXPECT_EQ(found.margins.det_a, 3.0);
  ASSERT_EQ(found.obstacles.size(), 2U);
  EXPECT_EQ(found.obstacles[0].name, "post");
  EXPECT_EQ(std::get<BallObstacle>(found.obstacles[0].shape).radius, 0.5);
  const auto& box = std::get<BoxObstacle>(found.obstacles[1].shape);
  EXPECT_EQ(box.half_size, Eigen::Vector3d(1.0, 0.5, 0.0));
  EXPECT_NEAR(Eigen::AngleAxisd(box.orientation).angle(), 0.5, 1e-15);
  ASSERT_TRUE(found.workspace);
  EXPECT_EQ(found.workspace->upper, Eigen::Vector3d(8.0, 9.0, 0.0));
}

// Each message by its remedy.
TEST(ConstraintsConfig, RefusesMarginsThatAreNone) {
  const auto problem = [](const std::string& margins) -> std::string {
    try {
      loaded("five_bar", "constraints: {margins: " + margins + "}");
    } catch (const InvalidDescription& invalid) {
      return invalid.problems().size() == 1 ? invalid.problems().front() : "several problems";
    }
    return "";
  };
  EXPECT_EQ(problem("{parallel: 0.0}"), "");
  EXPECT_EQ(problem("{parallel: 1.0}"),
            "five_bar.yaml has a constraints.margins.parallel of 1; it must be from 0 to below 1: the least "
            "parallel index, which is 0 at parallel singularities and 1 at most.");
  EXPECT_EQ(problem("{det_a: -1.0}"),
            "five_bar.yaml has a constraints.margins.det_a of -1; it must be 0 or a positive number: the "
            "least |det A|, in its unit.");
  EXPECT_TRUE(test::has(problem("{paralel: 0.1}"), "did you mean 'parallel'"));
  EXPECT_TRUE(test::has(problem("[0.1]"), "write {parallel: 0.05, serial: 0.1}"));
}

TEST(ConstraintsConfig, CanSwitchLimitsOff) {
  EXPECT_TRUE(loaded("bipod", "")->manipulator()->leg(0).limits.limited());
  EXPECT_FALSE(
      loaded("bipod", "constraints: {actuated_limits: false}")->manipulator()->leg(0).limits.limited());
  const std::string urdf = limited("five_bar", "elbow_1_joint", -1.0, 2.0);
  EXPECT_EQ(loaded("five_bar", "", urdf)->manipulator()->constraints().passive_limits.size(), 1U);
  EXPECT_TRUE(loaded("five_bar", "constraints: {passive_limits: false}", urdf)
                  ->manipulator()
                  ->constraints()
                  .passive_limits.empty());
}

// Axes of any length that a double holds.
TEST(ConstraintsConfig, NormalisesAxesOfCones) {
  const auto axis = [](const std::string& numbers) {
    const auto mechanism =
        loaded("delta", "constraints: {cones: [{leg: 1, end: platform, axis: " + numbers + ", angle: 0.6}]}");
    return mechanism->manipulator()->constraints().cones.at(0).axis;
  };
  EXPECT_EQ(axis("[0, 0, -1e300]"), -Eigen::Vector3d::UnitZ());
  EXPECT_EQ(axis("[1e-310, 0, 0]"), Eigen::Vector3d::UnitX());
  EXPECT_LT((axis("[1e200, 1e200, 0]") - Eigen::Vector3d(1.0, 1.0, 0.0).normalized()).norm(), 1e-15);
}

TEST(ConstraintsConfig, ReadsTheConesOfADelta) {
  const auto mechanism = load_mechanism(test::source_file("urdf/delta.urdf"), "delta.urdf",
                                        test::source_file("test/data/delta_with_cones.yaml"), "delta.yaml");
  const Manipulator& robot = *mechanism->manipulator();
  ASSERT_EQ(robot.constraints().cones.size(), 9U);
  EXPECT_EQ(robot.constraint_kinds().count(), 1U);
  const AssembledConfiguration home = mechanism->assembled();
  EXPECT_GT(test::ClearanceAt(robot, home.pose, home.q).of_cones(), 0.1);
}

struct Limited {
  const char* robot;
  const char* joints;
  std::size_t told, missing;
  double lower, upper;
};

class PassiveLimits : public testing::TestWithParam<Limited> {};

// What the limits of the joints of the URDF say when its loops are closed, against the angles between links.
TEST_P(PassiveLimits, AgreeWithTheClosedLoops) {
  const Limited& limits = GetParam();
  const auto mechanism =
      loaded(limits.robot, "", limited(limits.robot, limits.joints, limits.lower, limits.upper));
  const Manipulator& robot = *mechanism->manipulator();
  ASSERT_EQ(robot.constraints().passive_limits.size() + robot.constraints().passive_cones.size(),
            limits.told);
  ASSERT_EQ(robot.constraints().missing_joints.size(), limits.missing);
  if (limits.told == 0) return;
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> entries(-1.0, 1.0);
  const AssembledConfiguration start = mechanism->assembled();
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism->joint_names().size()));
  int inside = 0, outside = 0;
  for (int i = 0; i < 3000; ++i) {
    TaskVector step(static_cast<Eigen::Index>(robot.leg_count()));
    for (double& entry : coefficients_of(step)) entry = entries(random);
    const auto angles = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot.task_space()));
    step.tail(step.size() - angles) *= 0.7 * robot.size();
    const Pose pose = displaced(robot.motions(), start.pose, step);
    for (const InverseSolution& solution : inverse_in_all_modes(robot, pose)) {
      if (solution.status != InverseStatus::solved || !mechanism->complete(pose, solution.q, positions))
        continue;
      const double clearance = test::ClearanceAt(robot, pose, solution.q).of_passive_joints();
      if (std::abs(clearance) < 1e-6) continue;
      bool within = true;
      for (std::size_t k = 0; k < mechanism->joint_names().size(); ++k) {
        const JointLimits& range = mechanism->joint_limits()[k];
        if (!range.limited()) continue;
        const double middle = 0.5 * (range.lower + range.upper);
        const bool turns = std::regex_match(mechanism->joint_names()[k], std::regex(limits.joints));
        const double off = positions[static_cast<Eigen::Index>(k)] - middle;
        const double turned = turns ? std::remainder(off, 2.0 * EIGEN_PI) : 0.0;
        within = within && std::abs(turned) <= 0.5 * (range.upper - range.lower);
      }
      (within ? inside : outside) += 1;
      ASSERT_EQ(within, clearance > 0.0)
          << to_string(robot.task_space(), pose) << " in " << to_string(solution.mode);
    }
  }
  EXPECT_GT(inside, 10);
  EXPECT_GT(outside, 10);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, PassiveLimits,
    testing::Values(Limited{"five_bar", "elbow_[12]_joint", 2, 0, -1.0, 2.5},
                    Limited{"three_rpr", "pivot_[123]_joint|platform_joint", 4, 0, -1.5, 1.7},
                    Limited{"three_prr", "elbow_[123]_joint|platform_joint", 4, 0, -1.0, 1.2},
                    Limited{"delta", "rod_1_left_(pitch|roll)_joint", 0, 2, -3.0, 3.0},
                    Limited{"delta", "rod_2_left_(pitch|roll)_joint", 4, 0, -1.5, 0.9},
                    Limited{"delta", "rod_3_left_roll_joint", 2, 0, -0.3, 0.4},
                    Limited{"delta", "rod_3_left_pitch_joint", 0, 1, -0.3, 0.4}),
    [](const auto& each) { return std::string(each.param.robot) + "_" + std::to_string(each.index); });

}  // namespace
}  // namespace parallel_aspects
