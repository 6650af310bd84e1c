// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/pose_roadmap.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/roadmap/pose_sampler.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

namespace parallel_aspects {
namespace {

std::shared_ptr<const Manipulator> shipped(const std::string& name) {
  return test::shipped(name)->manipulator();
}

RoadmapOptions options_of(std::size_t samples, unsigned threads = 0) {
  RoadmapOptions options;
  options.samples = samples;
  options.threads = threads;
  return options;
}

std::shared_ptr<const PoseRoadmap> roadmap_of(const std::shared_ptr<const Manipulator>& robot,
                                              const RoadmapOptions& options) {
  const RoadmapResult result = compute_pose_roadmap(robot, options);
  EXPECT_EQ(result.status, MapStatus::complete) << result.message;
  return result.roadmap;
}

void expect_consistent(const RoadmapSide& side) {
  DisjointSets sets(side.poses.size());
  std::size_t links = 0;
  for (std::uint32_t a = 0; a < side.links.size(); ++a)
    for (const std::uint32_t b : side.links[a]) {
      sets.unite(a, b);
      ++links;
    }
  std::vector<std::size_t> sizes(side.component_sizes.size(), 0);
  for (std::uint32_t i = 0; i < side.poses.size(); ++i) {
    ++sizes.at(side.component[i]);
    for (std::uint32_t k = 0; k < i; ++k)
      ASSERT_EQ(sets.find(i) == sets.find(k), side.component[i] == side.component[k]);
  }
  EXPECT_EQ(sizes, side.component_sizes);
  EXPECT_TRUE(std::is_sorted(sizes.rbegin(), sizes.rend()));
  EXPECT_EQ(links, 2 * (side.poses.size() - sizes.size())) << "a forest";
}

// Every pose has the sign of its side, and along every link doubles see that sign and every leg in reach.
TEST(PoseRoadmap, EveryLinkIsFreeAtRandomPoints) {
  for (const char* name : {"stewart", "hexa", "six_pus"}) {
    const auto robot = shipped(name);
    const auto roadmap = roadmap_of(robot, options_of(test::is_sanitized ? 20 : 60));
    test::PosePairs random(robot, 7);
    std::size_t links = 0;
    for (const RoadmapSide& side : roadmap->sides()) {
      expect_consistent(side);
      for (std::uint32_t a = 0; a < side.links.size(); ++a)
        for (const std::uint32_t b : side.links[a]) {
          ++links;
          for (int i = 0; i < 20; ++i) {
            const Pose pose = pose_between(roadmap->poses()[side.poses[a]], roadmap->poses()[side.poses[b]],
                                           random.uniform(0.0, 1.0));
            ASSERT_EQ(test::sign_in_doubles(*robot, pose, side.mode), side.determinant_sign)
                << name << ' ' << to_string(side.mode) << ' ' << to_string(TaskSpace::SE3, pose);
          }
        }
    }
    EXPECT_GT(links, test::is_sanitized ? 10U : 50U) << name;
  }
}

bool same(const PoseRoadmap& a, const PoseRoadmap& b) {
  if (a.poses().size() != b.poses().size() || a.sides().size() != b.sides().size()) return false;
  for (std::size_t i = 0; i < a.poses().size(); ++i)
    if (a.poses()[i].position != b.poses()[i].position ||
        a.poses()[i].orientation.coeffs() != b.poses()[i].orientation.coeffs())
      return false;
  for (std::size_t i = 0; i < a.sides().size(); ++i) {
    const RoadmapSide &one = a.sides()[i], &other = b.sides()[i];
    if (one.mode != other.mode || one.determinant_sign != other.determinant_sign ||
        one.poses != other.poses || one.links != other.links || one.component != other.component)
      return false;
  }
  return true;
}

TEST(PoseRoadmap, TheSeedDecidesAndTheThreadsDoNot) {
  const auto robot = shipped("stewart");
  const auto one = roadmap_of(robot, options_of(300, 1));
  EXPECT_TRUE(same(*one, *roadmap_of(robot, options_of(300, 1))));
  EXPECT_TRUE(same(*one, *roadmap_of(robot, options_of(300, 2))));
  RoadmapOptions other = options_of(300, 1);
  other.seed = 2;
  EXPECT_FALSE(same(*one, *roadmap_of(robot, other)));
}

// Both signs of det A are found on the platform's two sides, each mostly one piece.
TEST(PoseRoadmap, StewartHasTwoSidesEachMostlyConnected) {
  const auto roadmap = roadmap_of(shipped("stewart"), options_of(1000));
  ASSERT_EQ(roadmap->sides().size(), 2U);
  EXPECT_EQ(roadmap->proved_count(), 2U);
  for (const RoadmapSide& side : roadmap->sides())
    EXPECT_GT(static_cast<double>(side.component_sizes.front()),
              0.8 * static_cast<double>(side.poses.size()));
  EXPECT_NE(roadmap->side(WorkingMode(6), 1), nullptr);
  EXPECT_EQ(roadmap->side(WorkingMode::from_index(6, 1), 1), nullptr);
}

// The samples of another roadmap lie in components of this one; all samples of a component of theirs in one.
TEST(RoadmapLocation, NamesTheComponentThatAProvedSegmentLeadsTo) {
  const auto robot = shipped("stewart");
  const auto roadmap = roadmap_of(robot, options_of(300));
  RoadmapOptions options = options_of(100);
  options.seed = 2;
  const auto others = roadmap_of(robot, options);
  std::size_t located = 0;
  for (const RoadmapSide& side : others->sides())
    for (const std::uint32_t index : side.poses) {
      const Pose& pose = others->poses()[index];
      const RoadmapLocation location = locate(*roadmap, pose, side.mode);
      EXPECT_EQ(location.determinant_sign, side.determinant_sign);
      if (!location.component) continue;
      ++located;
      EXPECT_LT(*location.component, roadmap->side(side.mode, side.determinant_sign)->component_sizes.size());
    }
  EXPECT_GT(located, 80U) << "of 100";
  const RoadmapSide& side = roadmap->sides().front();
  const Pose& sample = roadmap->poses()[side.poses.back()];
  EXPECT_EQ(locate(*roadmap, sample, side.mode).component, side.component.back());
}

TEST(RoadmapLocation, IsUnknownWhereNothingIsProved) {
  const auto roadmap = roadmap_of(shipped("stewart"), options_of(100));
  Pose far;
  far.position << 100.0, 0.0, 0.0;
  const RoadmapLocation location = locate(*roadmap, far, WorkingMode(6));
  EXPECT_EQ(location.determinant_sign, 0);
  EXPECT_FALSE(location.component);
  const Pose& sample = roadmap->poses().front();
  EXPECT_FALSE(locate(*roadmap, sample, WorkingMode(6), {0, 100}).component) << "no budget";
  Pose no_number = sample;
  no_number.position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(locate(*roadmap, no_number, WorkingMode(6)).component);
}

TEST(PoseRoadmap, HexaHasBothSignsInEveryMode) {
  const auto roadmap = roadmap_of(shipped("hexa"), options_of(test::is_sanitized ? 20 : 100));
  EXPECT_EQ(roadmap->sides().size(), 128U);
}

TEST(PoseRoadmap, ModesAndRotationsAreThoseAskedFor) {
  RoadmapOptions options = options_of(100);
  options.modes = {WorkingMode::from_index(6, 5)};
  options.largest_rotation = 0.3;
  options.region = Box{3, {-0.1, -0.1, -0.7}, {0.1, 0.1, -0.5}};
  const auto roadmap = roadmap_of(shipped("hexa"), options);
  for (const RoadmapSide& side : roadmap->sides()) EXPECT_EQ(side.mode, options.modes.front());
  for (const Pose& pose : roadmap->poses()) {
    EXPECT_LE(pose.orientation.angularDistance(Eigen::Quaterniond::Identity()), 0.3 + 1e-12);
    EXPECT_LE(pose.position.head<2>().cwiseAbs().maxCoeff(), 0.1);
    EXPECT_LE(std::abs(pose.position.z() + 0.6), 0.1);
  }
}

// Whatever the legs would allow beyond it.
TEST(PoseRoadmap, PosesStayInTheTaskSpace) {
  test::RandomRobots random(9);
  for (const TaskSpace space : test::all_task_spaces) {
    const auto robot = random.robot(space, test::ActuationKind::revolute);
    PoseSampler sampler(robot, 1, std::nullopt, EIGEN_PI);
    int drawn = 0;
    for (int i = 0; i < 1000; ++i) {
      const auto pose = sampler.draw();
      if (!pose) continue;
      ++drawn;
      const auto again = pose_from_coordinates(robot->motions(), pose_coordinates(space, *pose));
      ASSERT_TRUE(again);
      EXPECT_LT((again->position - pose->position).norm(), 1e-14) << name(space);
      EXPECT_LT(again->orientation.angularDistance(pose->orientation), 1e-7) << name(space);
    }
    EXPECT_GT(drawn, 10) << name(space);
  }
}

TEST(PoseRoadmap, BadOptionsAreRefusedWithASentence) {
  const auto robot = shipped("stewart");
  std::vector<RoadmapOptions> bad(10, options_of(10));
  bad[0].samples = 0;
  bad[1].samples = 1000000;
  bad[2].neighbors = 0;
  bad[3].neighbors = 1000;
  bad[4].largest_rotation = std::numeric_limits<double>::quiet_NaN();
  bad[5].largest_rotation = 4.0;
  bad[6].modes = {WorkingMode(5)};
  bad[7].region = Box{3, {1.0, 0.0, 0.0}, {0.0, 1.0, 1.0}};
  bad[8].region = Box{3, {100.0, 100.0, 100.0}, {101.0, 101.0, 101.0}};
  bad[9].region = Box{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  for (const RoadmapOptions& options : bad) {
    const RoadmapResult result = compute_pose_roadmap(robot, options);
    EXPECT_EQ(result.status, MapStatus::refused);
    EXPECT_EQ(result.roadmap, nullptr);
    EXPECT_FALSE(result.message.empty());
  }
}

// Struts without limits reach everywhere; a region bounds them.
TEST(PoseRoadmap, UnboundedRobotsNeedARegion) {
  RoadmapOptions options = options_of(100);
  EXPECT_EQ(compute_pose_roadmap(test::dietmaier(), options).status, MapStatus::refused);
  options.region = Box{3, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  const auto roadmap = roadmap_of(test::dietmaier(), options);
  ASSERT_EQ(roadmap->sides().size(), 2U);
  for (const RoadmapSide& side : roadmap->sides()) expect_consistent(side);
}

// From the calling thread, rising, and up to the end.
TEST(PoseRoadmap, ReportsItsProgress) {
  std::vector<double> shares;
  MapControl control;
  control.progress = [&shares](double share) { shares.push_back(share); };
  ASSERT_EQ(compute_pose_roadmap(shipped("hexa"), options_of(20), control).status, MapStatus::complete);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  ASSERT_GT(shares.size(), 10U);
  EXPECT_DOUBLE_EQ(shares.back(), 1.0);
}

// Work of many minutes, cancelled while poses are drawn, while links are proved, and before it began.
TEST(PoseRoadmap, EndsSoonWhenCancelled) {
  for (const double share : {-1.0, 0.05, 0.1, 0.11}) {
    std::atomic<bool> cancelled{share < 0.0};
    MapControl control;
    control.cancelled = &cancelled;
    control.progress = [&](double done) {
      if (done >= share) cancelled = true;
    };
    const RoadmapResult result =
        compute_pose_roadmap(shipped("hexa"), options_of(test::thinned(3000)), control);
    EXPECT_EQ(result.status, MapStatus::cancelled) << share;
    EXPECT_EQ(result.roadmap, nullptr);
  }
}

}  // namespace
}  // namespace parallel_aspects
