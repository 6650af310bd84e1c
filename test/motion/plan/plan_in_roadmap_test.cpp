// SPDX-License-Identifier: BSD-3-Clause
//
// Paths with six degrees of freedom, through serial gates too.
#include "motion/plan/followed_joints.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/plan_path.h"

#include <gtest/gtest.h>

#include "support/campaign_figures.h"
#include "support/index_at.h"
#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

/// By formulas of the test: the segments in their modes, and each crossing by the joints alone.
void expect_no_contradiction(const Robot& robot, const PlannedPath& path) {
  EXPECT_EQ(test::contradictions(*robot, path, 4000), 0);
  for (const PathCrossing& crossing : path.crossings) {
    const PathPoint &before = path.points[crossing.point], &behind = path.points[crossing.behind];
    ASSERT_EQ(crossing.behind, crossing.point + 1);
    EXPECT_EQ(before.pose.position, behind.pose.position);
    for (std::size_t j = 0; j < robot->leg_count(); ++j)
      EXPECT_EQ(before.mode.sign(j) != behind.mode.sign(j), j == crossing.leg);
    const test::Followed followed = test::follow(*robot, before.pose, before.q, behind.q);
    EXPECT_NE(followed.sign, 0);
    EXPECT_LT((followed.end.position - behind.pose.position).norm(), 1e-6 * robot->size());
    EXPECT_LT(followed.end.orientation.angularDistance(behind.pose.orientation), 1e-6);
  }
}

class PlanInRoadmapOf : public testing::TestWithParam<const char*> {};

TEST_P(PlanInRoadmapOf, PassesSerialGatesWithProof) {
  const Robot robot = test::shipped(GetParam())->mapped_manipulator();
  const std::vector<WorkingMode> modes = working_modes(*robot);
  test::PosePairs random(robot, 4);
  const WorkingMode first = random.mode();
  WorkingMode second = first;
  second.set_sign(2, -first.sign(2));
  const auto roadmap = test::roadmap_of(robot, {first, second}, 400);
  ASSERT_TRUE(roadmap);
  int found = 0, none = 0;
  const int pairs = test::is_sanitized ? 2 : 12;
  for (int i = 0; i < pairs; ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    const PathEnd from{random.reached(first).value(), first}, to{random.reached(second).value(), second};
    const int sign = test::sign_in_doubles(*robot, from.pose, first),
              other = test::sign_in_doubles(*robot, to.pose, second);
    EXPECT_NE(plan_in_roadmap(*roadmap, from, to).answer, SameAspect::yes) << "other modes";
    const PlannedPath path = plan_in_roadmap(*roadmap, from, to, {PathPolicy::serial});
    if (sign != other) {
      EXPECT_EQ(path.answer, SameAspect::no) << path.message;
      ++none;
      continue;
    }
    EXPECT_NE(path.answer, SameAspect::no) << path.message;
    if (!path) continue;
    ++found;
    EXPECT_EQ(path.crossings.size(), 1U);
    expect_no_contradiction(robot, path);
    const JointVector accelerations = test::usual_accelerations(*robot);
    if (accelerations.size() == 0) continue;
    const TimedPath timed =
        time_path(roadmap->certifier(), path, between_poses(TaskSpace::SE3), accelerations);
    EXPECT_LE(test::limits_taken(*robot, timed.waypoints, accelerations), 1.0);
  }
  std::printf("%s: %d found, %d of other signs, of %d\n", GetParam(), found, none, pairs);
  EXPECT_GE(2 * found, test::is_sanitized ? 0 : pairs - none);
}

INSTANTIATE_TEST_SUITE_P(Robots, PlanInRoadmapOf, testing::Values("hexa", "six_pus"),
                         [](const auto& each) { return std::string(each.param); });

/// The least parallel index of a path by the formula of the test, at many poses.
double least_index(const Manipulator& robot, const PlannedPath& path) {
  long double least = 1.0;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int k = 0; k <= 400; ++k) {
      const Pose pose = pose_between(path.points[i].pose, path.points[i + 1].pose, k / 400.0);
      const JointVector q = inverse(robot, pose, path.points[i].mode).q;
      least = std::min(least, test::IndexAt(robot, pose, q).parallel());
    }
  return static_cast<double>(least);
}

Pose pose_of(const std::array<double, 7>& coordinates) {
  return *pose_from_coordinates(TaskSpace::SE3, Eigen::Map<const PoseCoordinates>(coordinates.data(), 7));
}

// From above the base to below it, by a passage that no sampled segment of a larger roadmap finds either.
TEST(PlanInRoadmap, FindsNarrowPassages) {
  const Robot robot = test::shipped("stewart")->mapped_manipulator();
  const auto roadmap = test::roadmap_of(robot, {}, 250);
  const WorkingMode mode = working_modes(*robot).front();
  for (const auto& [from, to] :
       std::vector<std::pair<Pose, Pose>>{{pose_of({-0.123, -0.025, -0.028, -0.548, 0.019, 0.729, 0.410}),
                                           pose_of({0.075, 0.297, -1.206, -0.288, 0.118, -0.157, 0.937})},
                                          {pose_of({-0.614, 0.208, -1.206, 0.017, 0.046, -0.134, 0.990}),
                                           pose_of({-0.430, 0.239, 0.665, 0.568, 0.003, -0.510, 0.647})}}) {
    EXPECT_EQ(same_aspect(*roadmap, {from, mode}, {to, mode}, SearchEffort::brief).answer,
              SameAspect::unknown);
    if (test::is_sanitized) continue;
    const PlannedPath path = plan_in_roadmap(*roadmap, {from, mode}, {to, mode});
    ASSERT_TRUE(path) << path.message;
    EXPECT_EQ(test::contradictions(*robot, path, 100000), 0);
  }
}

// The gates near the start lead to where the goal is not reached from.
TEST(PlanInRoadmap, SearchesForGatesFromTheGoalToo) {
  const Robot robot = test::shipped("six_pus")->mapped_manipulator();
  const WorkingMode first = *WorkingMode::from_signs({-1, -1, -1, -1, -1, -1}),
                    second = *WorkingMode::from_signs({-1, -1, -1, -1, 1, -1});
  const auto roadmap = test::roadmap_of(robot, {first, second}, 250);
  const PathEnd from{pose_of({-0.027722, -0.091143, 0.140326, 0.237397, -0.725320, 0.098226, 0.638675}),
                     first},
      to{pose_of({-0.130427, 0.026886, 0.424601, -0.818384, 0.085476, -0.431796, 0.369450}), second};
  const PlannedPath path = plan_in_roadmap(*roadmap, from, to, {PathPolicy::serial});
  if (test::is_sanitized) return;
  ASSERT_TRUE(path) << path.message;
  EXPECT_EQ(path.points.front().pose.position, from.pose.position);
  EXPECT_EQ(path.points.front().q, inverse(*robot, from.pose, first).q);
  EXPECT_EQ(path.points.back().pose.position, to.pose.position);
  expect_no_contradiction(robot, path);
  EXPECT_TRUE(time_path(roadmap->certifier(), path, between_poses(TaskSpace::SE3),
                        test::usual_accelerations(*robot)));
}

// With a margin, which every pose keeps, the gates too.
TEST(PlanInRoadmap, PassesSerialGatesWithinFurtherConstraints) {
  Margins margins;
  margins.parallel = 0.01;
  const Robot robot = test::shipped("hexa")->mapped_manipulator()->with_margins(margins);
  test::PosePairs random(robot, 4);
  const WorkingMode first = random.mode();
  WorkingMode second = first;
  second.set_sign(1, -first.sign(1));
  const auto roadmap = test::roadmap_of(robot, {first, second}, 400);
  ASSERT_TRUE(roadmap);
  int found = 0;
  for (int i = 0; i < (test::is_sanitized ? 2 : 16); ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    const PathEnd from{random.reached(first).value(), first}, to{random.reached(second).value(), second};
    const PlannedPath path = plan_in_roadmap(*roadmap, from, to, {PathPolicy::serial});
    if (!path) continue;
    ++found;
    expect_no_contradiction(robot, path);
    EXPECT_GE(least_index(*robot, path), 0.01);
  }
  std::printf("hexa with a margin: %d found\n", found);
  EXPECT_GT(found, test::is_sanitized ? -1 : 0);
}

TEST(PlanInRoadmap, PassesNoGateThatASerialMarginShutsOut) {
  Margins margins;
  margins.serial = 0.01;
  const Robot robot = test::shipped("hexa")->mapped_manipulator()->with_margins(margins);
  test::PosePairs random(robot, 4);
  const WorkingMode first = random.mode();
  WorkingMode second = first;
  second.set_sign(1, -first.sign(1));
  const auto roadmap = test::roadmap_of(robot, {first, second}, 50);
  ASSERT_TRUE(roadmap);
  const PlannedPath path = plan_in_roadmap(*roadmap, {random.reached(first).value(), first},
                                           {random.reached(second).value(), second}, {PathPolicy::serial});
  EXPECT_EQ(path.answer, SameAspect::no);
  EXPECT_NE(path.message.find("serial margin"), std::string::npos) << path.message;
}

TEST(PlanInRoadmap, HasClearAndShortPaths) {
  const Robot robot = test::shipped("stewart")->mapped_manipulator();
  const auto roadmap = test::roadmap_of(robot, {}, 1000);
  const WorkingMode mode = working_modes(*robot).front();
  test::PosePairs random(robot, 20261123);
  int clearer = 0;
  double length_of_short = 0.0, length_of_clear = 0.0;
  for (int i = 0; i < (test::is_sanitized ? 3 : 60); ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    const PathEnd from{random.reached(mode).value(), mode}, to{random.reached(mode).value(), mode};
    const PlannedPath shortest = plan_in_roadmap(*roadmap, from, to,
                                                 {PathPolicy::stay, PathPreference::shortest, {}}),
                      clear =
                          plan_in_roadmap(*roadmap, from, to, {PathPolicy::stay, PathPreference::clear, {}});
    ASSERT_EQ(shortest.answer, clear.answer);
    if (!shortest) continue;
    EXPECT_EQ(test::contradictions(*robot, shortest, 2000), 0);
    EXPECT_EQ(test::contradictions(*robot, clear, 2000), 0);
    EXPECT_GE(clear.least_index, shortest.least_index);
    EXPECT_LE(test::path_length(*robot, shortest), test::path_length(*robot, clear));
    length_of_short += test::path_length(*robot, shortest);
    length_of_clear += test::path_length(*robot, clear);
    clearer += clear.least_index > 1.01 * shortest.least_index ? 1 : 0;
  }
  EXPECT_GT(clearer, test::is_sanitized ? -1 : 0);
  EXPECT_LE(length_of_short, length_of_clear);
}

// About half a turn, rounding would decide which way round a segment goes.
TEST(PlanInRoadmap, LeavesNoSegmentThatTurnsByMoreThanAQuarter) {
  ManipulatorDescription description = test::shipped("stewart")->mapped_manipulator()->description();
  for (Leg& leg : description.legs) leg.limits = JointLimits{0.1, 10.0};
  const Robot robot = std::make_shared<const Manipulator>(description);
  const auto roadmap = test::roadmap_of(robot, {}, 40);
  ASSERT_TRUE(roadmap);
  const WorkingMode mode = working_modes(*robot).front();
  test::PosePairs random(robot, 4);
  int divided = 0;
  for (int i = 0; i < (test::is_sanitized ? 10 : 200); ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    const Pose from = random.reached(mode).value(), to = random.reached(mode).value();
    if (from.orientation.angularDistance(to.orientation) < 0.5 * EIGEN_PI ||
        roadmap->certifier().prove(from, to, mode).verdict != SegmentVerdict::free)
      continue;
    const PlannedPath path = plan_in_roadmap(*roadmap, {from, mode}, {to, mode});
    ASSERT_TRUE(path) << path.message;
    EXPECT_EQ(path.points.size(), 3U);
    for (std::size_t k = 0; k + 1 < path.points.size(); ++k)
      EXPECT_LE(path.points[k].pose.orientation.angularDistance(path.points[k + 1].pose.orientation),
                0.5 * EIGEN_PI * (1.0 + 1e-9));
    EXPECT_NEAR(path.turned, from.orientation.angularDistance(to.orientation), 1e-9);
    EXPECT_EQ(test::contradictions(*robot, path, 2000), 0);
    ++divided;
  }
  std::printf("%d segments are divided\n", divided);
  EXPECT_GT(divided, test::is_sanitized ? -1 : 0);
}

// No is proved by signs alone. Links of this roadmap turn by up to half a turn, and their halves are other
// motions, not all of them free.
TEST(PlanInRoadmap, SaysNotNoWhereTheSignsAreEqual) {
  const Robot robot = test::shipped("hexa")->mapped_manipulator();
  test::PosePairs random(robot, 1);
  const WorkingMode mode = random.mode();
  const auto roadmap = test::roadmap_of(robot, {mode}, 200);
  int pairs = 0, found = 0;
  while (pairs < (test::is_sanitized ? 3 : 40)) {
    SCOPED_TRACE("pair " + std::to_string(pairs));
    const PathEnd from{random.reached(mode).value(), mode}, to{random.reached(mode).value(), mode};
    if (test::sign_in_doubles(*robot, from.pose, mode) != test::sign_in_doubles(*robot, to.pose, mode))
      continue;
    ++pairs;
    const PlannedPath path = plan_in_roadmap(*roadmap, from, to);
    EXPECT_NE(path.answer, SameAspect::no) << path.message;
    if (!path) continue;
    ++found;
    EXPECT_EQ(test::contradictions(*robot, path, 2000), 0);
    for (std::size_t k = 0; k + 1 < path.points.size(); ++k)
      EXPECT_LE(path.points[k].pose.orientation.angularDistance(path.points[k + 1].pose.orientation),
                0.5 * EIGEN_PI * (1.0 + 1e-9));
  }
  std::printf("%d of %d found\n", found, pairs);
  EXPECT_GE(found, test::is_sanitized ? 0 : 38);
}

TEST(PlanInRoadmap, NamesWhatKeepsAnEndOut) {
  const Robot robot = test::shipped("stewart")->mapped_manipulator();
  const auto roadmap = test::roadmap_of(robot, {}, 10);
  Pose far;
  far.position = {9.0, 0.0, 1.3};
  const PlannedPath path = plan_in_roadmap(*roadmap, {Pose(), {}}, {far, {}});
  EXPECT_EQ(path.answer, SameAspect::no);
  EXPECT_NE(path.message.find("no aspect holds the start: the actuated joint of leg"), std::string::npos)
      << path.message;
}

TEST(PlanInRoadmap, EndsWhereItIsCancelled) {
  const Robot robot = test::shipped("six_pus")->mapped_manipulator();
  test::PosePairs random(robot, 4);
  const WorkingMode first = random.mode();
  WorkingMode second = first;
  second.set_sign(0, -first.sign(0));
  const auto roadmap = test::roadmap_of(robot, {first, second}, 100);
  const std::atomic<bool> cancelled(true);
  MapControl control;
  control.cancelled = &cancelled;
  const PlannedPath path =
      plan_in_roadmap(*roadmap, {random.reached(first).value(), first},
                      {random.reached(second).value(), second}, {PathPolicy::serial}, control);
  EXPECT_NE(path.answer, SameAspect::yes);
}

}  // namespace
}  // namespace parallel_aspects
