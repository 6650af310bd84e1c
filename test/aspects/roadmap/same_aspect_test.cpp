// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include <cmath>
#include <limits>
#include <string>

namespace parallel_aspects {
namespace {

Pose at(double x, double y, double z = 0.0) {
  Pose pose;
  pose.position << x, y, z;
  return pose;
}

std::shared_ptr<const PoseRoadmap> roadmap_of(const std::shared_ptr<const Manipulator>& robot,
                                              std::size_t samples,
                                              const std::vector<WorkingMode>& modes = {}) {
  RoadmapOptions options;
  options.samples = samples;
  options.modes = modes;
  return compute_pose_roadmap(robot, options).roadmap;
}

void expect_path(const Manipulator& robot, const AspectComparison& comparison, const PoseInMode& first,
                 const PoseInMode& second) {
  ASSERT_GE(comparison.path.size(), 2U);
  EXPECT_EQ(comparison.path.front().position, first.pose.position);
  EXPECT_EQ(comparison.path.back().position, second.pose.position);
  EXPECT_EQ(comparison.path.front().orientation.coeffs(), first.pose.orientation.coeffs());
  EXPECT_EQ(comparison.path.back().orientation.coeffs(), second.pose.orientation.coeffs());
  const int sign = test::sign_in_doubles(robot, first.pose, first.mode);
  for (std::size_t i = 0; i + 1 < comparison.path.size(); ++i)
    for (int k = 0; k <= 200; ++k) {
      const Pose pose = pose_between(comparison.path[i], comparison.path[i + 1], k / 200.0);
      ASSERT_EQ(test::sign_in_doubles(robot, pose, first.mode), sign)
          << robot.name() << ' ' << to_string(first.mode) << ' ' << to_string(robot.task_space(), pose);
    }
}

// Random configurations: ways are free as doubles see them; and the answer does not depend on the order.
TEST(SameAspect, WaysAreFreeAtEveryPoint) {
  for (const char* name : {"stewart", "hexa", "six_pus"}) {
    const auto robot = test::shipped(name)->manipulator();
    test::PosePairs random(robot, 3);
    const WorkingMode mode = random.mode();
    const auto roadmap = roadmap_of(robot, 400, {mode});
    int answered = 0, unknown = 0;
    for (int i = 0; i < 60; ++i) {
      const PoseInMode first{random.reached(mode).value(), mode}, second{random.reached(mode).value(), mode};
      const AspectComparison comparison = same_aspect(*roadmap, first, second);
      const bool signs_agree =
          test::sign_in_doubles(*robot, first.pose, mode) == test::sign_in_doubles(*robot, second.pose, mode);
      EXPECT_FALSE(comparison.message.empty());
      EXPECT_EQ(comparison.answer == SameAspect::no, !signs_agree) << comparison.message;
      if (comparison.answer == SameAspect::yes) expect_path(*robot, comparison, first, second);
      EXPECT_EQ(comparison.answer == SameAspect::yes, !comparison.path.empty());
      ++(comparison.answer == SameAspect::unknown ? unknown : answered);
    }
    EXPECT_GT(answered, 40) << name << ", unknown " << unknown;
  }
}

// Against the certified map, which is found in quite another path.
TEST(SameAspect, AgreesWithTheMapOfTheFiveBar) {
  const auto robot = test::five_bar();
  const auto map = compute_aspect_map(robot).map;
  const auto roadmap = roadmap_of(robot, 300);
  test::PosePairs random(robot, 5);
  int same = 0, found = 0, different = 0;
  for (int i = 0; i < 800; ++i) {
    const WorkingMode mode = random.mode();
    const PoseInMode first{random.reached(mode).value(), mode}, second{random.reached(mode).value(), mode};
    const Location one = map->locate(first.pose, mode), other = map->locate(second.pose, mode);
    if (one.status != LocationStatus::inside || other.status != LocationStatus::inside) continue;
    const AspectComparison comparison = same_aspect(*roadmap, first, second);
    ++(one.aspect == other.aspect ? same : different);
    found += comparison.answer == SameAspect::yes;
    EXPECT_TRUE(comparison.answer != SameAspect::yes || one.aspect == other.aspect) << i;
    EXPECT_TRUE(comparison.answer != SameAspect::no || one.aspect != other.aspect) << i;
    if (comparison.answer == SameAspect::yes) expect_path(*robot, comparison, first, second);
  }
  EXPECT_GT(different, 50);
  EXPECT_GE(found, 0.97 * same) << "of " << same;
}

// The two aspects that the five-bar has in one mode and sign, 47.85 and 3.70 m^2: never one.
TEST(SameAspect, TheTwoAspectsOfOneSideAreNeverJoined) {
  const auto robot = test::five_bar();
  const auto roadmap = roadmap_of(robot, 1000);
  WorkingMode mode(2);
  mode.set_sign(0, -1);
  const AspectComparison comparison = same_aspect(*roadmap, {at(4.5, 3.55), mode}, {at(4.5, -11.71), mode});
  EXPECT_EQ(comparison.answer, SameAspect::unknown) << comparison.message;
  EXPECT_NE(comparison.searched_sign, 0);
  EXPECT_EQ(same_aspect(*roadmap, {at(4.5, 3.55), mode}, {at(4.6, 3.0), mode}).answer, SameAspect::yes);
}

TEST(SameAspect, SignsAndReachDistinguishConfigurations) {
  const auto robot = test::shipped("hexa")->manipulator();
  const SegmentCertifier certifier(robot);
  const Pose home = at(0.0, 0.0, -0.6);
  const WorkingMode mode(6), other = WorkingMode::from_index(6, 3);
  EXPECT_EQ(same_aspect(certifier, {home, mode}, {home, mode}).answer, SameAspect::yes);
  EXPECT_EQ(same_aspect(certifier, {home, mode}, {home, other}).answer, SameAspect::no);
  EXPECT_EQ(same_aspect(certifier, {home, mode}, {at(9.0, 0.0), mode}).answer, SameAspect::no);
  EXPECT_EQ(same_aspect(certifier, {at(9.0, 0.0), mode}, {home, mode}).answer, SameAspect::no);
  const Pose broken = at(std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_EQ(same_aspect(certifier, {home, mode}, {broken, mode}).answer, SameAspect::unknown);
}

// Opposite sides of the base plane mirror each other: det A changes its sign.
TEST(SameAspect, AboveAndBelowTheBaseAreDifferentAspectsOfAStewartPlatform) {
  const auto robot = test::shipped("stewart")->manipulator();
  const auto roadmap = roadmap_of(robot, 200);
  const WorkingMode mode(6);
  EXPECT_EQ(same_aspect(*roadmap, {at(0.0, 0.0, 1.3), mode}, {at(0.0, 0.0, -1.3), mode}).answer,
            SameAspect::no);
  EXPECT_EQ(same_aspect(*roadmap, {at(0.0, 0.0, 1.3), mode}, {at(0.1, 0.2, 1.2), mode}).answer,
            SameAspect::yes);
}

}  // namespace
}  // namespace parallel_aspects
