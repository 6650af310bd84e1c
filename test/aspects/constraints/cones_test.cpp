// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/clearance_at.h"
#include "support/constrained_boxes.h"
#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <cmath>
#include <string>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::with;

/// Cones about where the rods are at some pose, of every kind and size: narrow, of half a turn and wider.
class ConesTest : public test::ConstrainedBoxes {
 protected:
  Constraints choose(const Manipulator& plain, const Start& start) override {
    const test::ClearanceAt at(plain, start.pose, start.q);
    const double angles[] = {0.9, 0.5 * EIGEN_PI, 2.3};
    Constraints constraints;
    for (std::size_t k = 0; k < 4; ++k) {
      BallJointCone cone{
          k % plain.leg_count(), k % 2 == 0 ? LegEnd::platform : LegEnd::base, {}, angles[k % 3]};
      const Eigen::Vector3d about =
          is_planar(plain.task_space())
              ? Eigen::Vector3d::UnitZ()
              : Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
      cone.axis = Eigen::AngleAxisd(0.8 * cone.angle, about) * at.seen_rod(cone.leg, cone.end).normalized();
      constraints.cones.push_back(cone);
    }
    return constraints;
  }

  double clearance(const Pose& pose) const override {
    return test::ClearanceAt(*robot, pose, inverse(*robot, pose, mode).q).of_cones();
  }
};

TEST_P(ConesTest, NoPoseContradictsItsBox) { expect_no_contradiction(); }

TEST_P(ConesTest, SmallBoxesAreDecidedOnEitherSide) { expect_small_boxes_decided(); }

TEST_P(ConesTest, SlopesAreThoseOfFiniteDifferences) {
  expect_slopes_of_finite_differences(robot->leg_count() + 1 + robot->constraints().cones.size());
}

TEST_P(ConesTest, FreeSegmentsStayInTheCones) { expect_free_segments_stay(ConstraintKind::cones); }

INSTANTIATE_TEST_SUITE_P(Robots, ConesTest, testing::ValuesIn(test::mapped_robots()), test::name_of);

Robot delta_with_cones(double at_crank, double at_platform) {
  const Robot plain = test::delta();
  Constraints constraints;
  for (std::size_t j = 0; j < 3; ++j) {
    constraints.cones.push_back({j, LegEnd::base, Eigen::Vector3d::UnitY(), at_crank});
    constraints.cones.push_back({j, LegEnd::platform, -Eigen::Vector3d::UnitZ(), at_platform});
  }
  return with(plain, constraints);
}

// Rods that hang down at the platform and to the side of the crank that its angle grows to: of the eight
// working modes one is left, and of that one aspect.
TEST(Cones, LeaveTheDeltaTheAspectThatItWorksIn) {
  MapOptions options;
  options.resolution = test::is_sanitized ? 0.2 : 0.08;
  options.extra_levels = 4;
  const MapResult found = compute_aspect_map(delta_with_cones(1.4, 0.8), options);
  ASSERT_TRUE(found.map) << found.message;
  if (test::is_sanitized) return;
  EXPECT_EQ(found.map->proved_count(), 1U);
  EXPECT_TRUE(found.map->unresolved().empty());
  ASSERT_EQ(found.map->aspects().size(), 1U);
  EXPECT_EQ(to_string(found.map->aspects()[0].mode), "(+,+,+)");
  Pose below;
  below.position = {0.0, 0.0, -0.8};
  EXPECT_EQ(found.map->locate(below, found.map->aspects()[0].mode).status, LocationStatus::inside);
}

Robot stewart_with_cones(double angle) {
  const Robot plain = test::shipped("stewart")->manipulator();
  Constraints constraints;
  const Pose home{{0.0, 0.0, 1.3}, Eigen::Quaterniond::Identity()};
  const JointVector q = inverse(*plain, home, WorkingMode(6)).q;
  const test::ClearanceAt at(*plain, home, q);
  for (std::size_t j = 0; j < 6; ++j)
    for (const LegEnd end : {LegEnd::base, LegEnd::platform})
      constraints.cones.push_back({j, end, at.seen_rod(j, end).normalized(), angle});
  return with(plain, constraints);
}

TEST(Cones, BoundTheRoadmapOfAStewartPlatform) {
  RoadmapOptions options;
  options.samples = test::thinned(400);
  options.largest_rotation = 0.7;
  const Robot robot = stewart_with_cones(0.6);
  const RoadmapResult result = compute_pose_roadmap(robot, options);
  ASSERT_TRUE(result.roadmap) << result.message;
  std::size_t poses = 0;
  for (const RoadmapSide& side : result.roadmap->sides())
    for (const std::uint32_t index : side.poses) {
      const Pose& pose = result.roadmap->poses()[index];
      EXPECT_GT(test::ClearanceAt(*robot, pose, inverse(*robot, pose, side.mode).q).of_cones(), -1e-9);
      ++poses;
    }
  EXPECT_GT(poses, test::is_sanitized ? 0U : 10U);
  EXPECT_LT(poses, result.roadmap->poses().size());
}

TEST(Cones, AreNamedWhereTheyFail) {
  const SegmentCertifier certifier(stewart_with_cones(0.35));
  const WorkingMode mode(6);
  PoseInMode inside{{{0.0, 0.0, 1.3}, Eigen::Quaterniond::Identity()}, mode}, outside = inside;
  outside.pose.position.x() = 0.5;
  const AspectComparison answer = same_aspect(certifier, inside, outside);
  EXPECT_EQ(answer.answer, SameAspect::no);
  EXPECT_EQ(answer.message,
            "The second configuration lies in no aspect: the constraint cones does not hold there.");
  outside.pose.position.x() = 0.05;
  EXPECT_EQ(same_aspect(certifier, inside, outside).answer, SameAspect::yes);
}

std::string problem_with(const Robot& plain, const BallJointCone& cone) {
  Constraints constraints;
  constraints.cones.push_back(cone);
  try {
    with(plain, constraints);
  } catch (const InvalidDescription& invalid) {
    return invalid.problems().size() == 1 ? invalid.problems().front() : "several problems";
  }
  return "";
}

TEST(Cones, ThatDoNotFitTheLegsAreRefused) {
  const auto says = [](const std::string& problem, const std::string& part) {
    return problem.find(part) != std::string::npos;
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  EXPECT_EQ(problem_with(test::delta(), {2, LegEnd::base, x, 3.0}), "");
  EXPECT_TRUE(
      says(problem_with(test::delta(), {3, LegEnd::base, x, 3.0}), "names leg 4, but the robot has 3"));
  EXPECT_TRUE(says(problem_with(test::delta(), {0, LegEnd::base, 2.0 * x, 1.0}), "not a unit vector"));
  EXPECT_TRUE(
      says(problem_with(test::delta(), {0, LegEnd::base, x * std::nan(""), 1.0}), "not a unit vector"));
  EXPECT_TRUE(
      says(problem_with(test::five_bar(), {0, LegEnd::base, Eigen::Vector3d::UnitZ(), 1.0}), "of the plane"));
  for (const double angle : {0.0, -1.0, static_cast<double>(EIGEN_PI), 4.0, std::nan("")})
    EXPECT_TRUE(says(problem_with(test::delta(), {1, LegEnd::platform, x, angle}),
                     "The cone at the platform end of leg 2 has an angle of"))
        << angle;
  EXPECT_TRUE(says(problem_with(test::agile_eye(), {0, LegEnd::base, x, 1.0}), "SO3"));
  EXPECT_TRUE(says(problem_with(test::three_rrr_actuated_elbow(), {0, LegEnd::base, x, 1.0}), "elbow"));
}

}  // namespace
}  // namespace parallel_aspects
