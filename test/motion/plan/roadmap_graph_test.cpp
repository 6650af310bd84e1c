// SPDX-License-Identifier: BSD-3-Clause
//
// The graph over a roadmap: its gates by formulas of the test.
#include "motion/plan/followed_joints.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/plan_path.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <atomic>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

/// Four working modes around one, by the postures of two legs.
std::vector<WorkingMode> some_modes(const Robot& robot) {
  const WorkingMode first = test::PosePairs(robot, 4).mode();
  std::vector<WorkingMode> modes;
  for (const int one : {1, -1})
    for (const int other : {1, -1}) {
      WorkingMode mode = first;
      mode.set_sign(1, one);
      mode.set_sign(4, other);
      modes.push_back(mode);
    }
  return modes;
}

void expect_passable(const Robot& robot, const RoadmapPart& from, const RoadmapPart& to, std::size_t leg,
                     const GateCrossing& crossing) {
  ASSERT_EQ(crossing.segment.size(), 3U);
  for (std::size_t i = 0; i < 2; ++i)
    for (int k = 0; k <= 300; ++k) {
      const Pose pose = pose_between(crossing.segment[i], crossing.segment[i + 1], k / 300.0);
      EXPECT_EQ(test::sign_in_doubles(*robot, pose, from.mode), from.determinant_sign);
      EXPECT_EQ(test::sign_in_doubles(*robot, pose, to.mode), from.determinant_sign);
    }
  const Pose inner = crossing.segment.back();
  const JointVector before = inverse(*robot, inner, from.mode).q, behind = inverse(*robot, inner, to.mode).q;
  JointVector end = behind;
  const auto k = static_cast<Eigen::Index>(leg);
  if (robot->leg(leg).actuated_by_angle())
    end[k] = before[k] + std::remainder(behind[k] - before[k], 2.0 * EIGEN_PI);
  const test::Followed followed = test::follow(*robot, inner, before, end);
  EXPECT_NE(followed.sign, 0);
  EXPECT_LT((followed.end.position - inner.position).norm(), 1e-6 * robot->size());
  EXPECT_LT(followed.end.orientation.angularDistance(inner.orientation), 1e-6);
}

class RoadmapGraphOf : public testing::TestWithParam<const char*> {};

TEST_P(RoadmapGraphOf, HasGatesThatAreNotContradicted) {
  const Robot robot = test::shipped(GetParam())->mapped_manipulator();
  const auto roadmap = test::roadmap_of(robot, some_modes(robot), 300);
  ASSERT_TRUE(roadmap);
  const auto found = compute_roadmap_graph(*roadmap);
  ASSERT_TRUE(found);
  int crossings = 0;
  for (const Neighbours& gate : found->graph.gates) {
    const RoadmapPart &from = found->parts[static_cast<std::size_t>(gate.first - 1)],
                      &to = found->parts[static_cast<std::size_t>(gate.second - 1)];
    EXPECT_TRUE(gate.proved);
    EXPECT_EQ(from.determinant_sign, to.determinant_sign);
    for (std::size_t j = 0; j < robot->leg_count(); ++j)
      EXPECT_EQ(from.mode.sign(j) != to.mode.sign(j), j == gate.leg);
    double before = 1.0;
    for (const GateCrossing& crossing : gate.crossings) {
      EXPECT_LE(crossing.index, before);
      before = crossing.index;
      expect_passable(robot, from, to, gate.leg, crossing);
      ++crossings;
    }
  }
  std::printf("%s: %zu parts, %zu gates, %d crossings, %zu sets\n", GetParam(), found->parts.size(),
              found->graph.gates.size(), crossings, found->graph.sets.size());
  EXPECT_GE(crossings, test::is_sanitized ? 1 : 8);
  EXPECT_EQ(found->graph.proved_set_count, 2U);
}

INSTANTIATE_TEST_SUITE_P(Robots, RoadmapGraphOf, testing::Values("hexa", "six_pus"),
                         [](const auto& each) { return std::string(each.param); });

// Each component is one part of one set, and no set has two signs.
TEST(RoadmapGraph, DividesTheComponentsIntoSets) {
  const Robot robot = test::shipped("six_pus")->mapped_manipulator();
  const auto roadmap = test::roadmap_of(robot, some_modes(robot), 200);
  const auto found = compute_roadmap_graph(*roadmap);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->parts.size(), roadmap->component_count());
  std::set<int> seen;
  for (std::size_t i = 0; i < found->graph.sets.size(); ++i)
    for (const int id : found->graph.sets[i].aspects) {
      EXPECT_TRUE(seen.insert(id).second);
      EXPECT_EQ(found->parts[static_cast<std::size_t>(id - 1)].determinant_sign,
                found->graph.sets[i].determinant_sign);
      EXPECT_EQ(found->graph.set_of(id), i);
    }
  EXPECT_EQ(seen.size(), found->parts.size());
  std::size_t samples = 0, expected = 0;
  for (const RoadmapPart& part : found->parts) samples += part.samples;
  for (const RoadmapSide& side : roadmap->sides()) expected += side.poses.size();
  EXPECT_EQ(samples, expected);
}

TEST(RoadmapGraph, HasNoGatesWhereThereAreNone) {
  const Robot stewart = test::shipped("stewart")->mapped_manipulator();
  const auto of_stewart = compute_roadmap_graph(*test::roadmap_of(stewart, {}, 200));
  ASSERT_TRUE(of_stewart);
  EXPECT_TRUE(of_stewart->graph.gates.empty());
  EXPECT_EQ(of_stewart->graph.sets.size(), of_stewart->parts.size());
  Margins margins;
  margins.serial = 0.01;
  const Robot hexa = test::shipped("hexa")->mapped_manipulator()->with_margins(margins);
  const auto of_hexa = compute_roadmap_graph(*test::roadmap_of(hexa, some_modes(hexa), 100));
  ASSERT_TRUE(of_hexa);
  EXPECT_TRUE(of_hexa->graph.gates.empty());
}

TEST(RoadmapGraph, IsNothingWhereCancelled) {
  const Robot robot = test::shipped("six_pus")->mapped_manipulator();
  const std::atomic<bool> cancelled(true);
  MapControl control;
  control.cancelled = &cancelled;
  EXPECT_FALSE(compute_roadmap_graph(*test::roadmap_of(robot, some_modes(robot), 50), control));
}

}  // namespace
}  // namespace parallel_aspects
