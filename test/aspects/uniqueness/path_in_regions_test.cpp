// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <vector>

// Paths of the 3-RPR that are proved to lie in one uniqueness domain, against the direct solver.

namespace parallel_aspects {
namespace {

using test::uniform;

const Uniqueness& regions_of_struts() {
  static const std::shared_ptr<const Uniqueness> uniqueness = [] {
    UniquenessOptions options;
    options.most_cells = 24000;
    return compute_uniqueness(test::three_rpr(), options).uniqueness;
  }();
  return *uniqueness;
}

const Manipulator& robot() { return *regions_of_struts().map->manipulator(); }

JointVector values_at(const Pose& pose) { return inverse(robot(), pose, working_modes(robot()).front()).q; }

Pose random_pose(std::mt19937_64& random) {
  return Pose::planar(uniform(random, -32.0, 32.0), uniform(random, -32.0, 32.0),
                      uniform(random, -EIGEN_PI, EIGEN_PI));
}

Pose moved(const Pose& pose, double by, std::mt19937_64& random) {
  const double phi = 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w());
  return Pose::planar(pose.position.x() + uniform(random, -by, by),
                      pose.position.y() + uniform(random, -by, by), phi + 0.1 * uniform(random, -by, by));
}

bool holds(const std::vector<std::size_t>& regions, const std::optional<std::size_t>& region) {
  return region && std::find(regions.begin(), regions.end(), *region) != regions.end();
}

/// No pose of the path is outside of the regions, and no other pose of the same values is inside of them.
void try_to_refute(const Pose& from, const Pose& to, const std::vector<std::size_t>& regions) {
  constexpr int samples = 100;
  for (int k = 0; k <= samples; ++k) {
    const Pose pose = pose_between(from, to, k / static_cast<double>(samples));
    const auto region = regions_of_struts().locate(pose);
    EXPECT_TRUE(!region || holds(regions, region));
    for (const AssemblyMode& mode : direct(robot(), values_at(pose)).solutions) {
      const bool same = (mode.pose.position - pose.position).norm() < 1e-6 &&
                        mode.pose.orientation.angularDistance(pose.orientation) < 1e-6;
      EXPECT_TRUE(same || !holds(regions, regions_of_struts().locate(mode.pose)))
          << from.position.transpose() << " to " << to.position.transpose() << ", " << k;
    }
  }
}

TEST(PathInRegions, IsInOneDomainWhereThatIsProved) {
  std::mt19937_64 random(41);
  int proved = 0, across = 0, tried = 0;
  for (int i = 0; i < test::thinned(4000); ++i) {
    const Pose from = random_pose(random), to = moved(from, 2.0, random);
    if (!regions_of_struts().locate(from) || !regions_of_struts().locate(to)) continue;
    ++tried;
    const auto regions = regions_of_struts().regions_along({from, to});
    if (!regions) continue;
    ++proved;
    across += regions->size() > 1 ? 1 : 0;
    try_to_refute(from, to, *regions);
  }
  EXPECT_GT(proved, tried / 2);
  EXPECT_GT(across, tried / 100);
}

// Whatever leads from one solution to another in its aspect.
TEST(PathInRegions, IsNotInOneDomainBetweenSolutionsOfTheSameValues) {
  std::mt19937_64 random(42);
  int pairs = 0;
  for (int i = 0; i < test::thinned(600); ++i) {
    const Pose from = random_pose(random);
    const auto region = regions_of_struts().locate(from);
    if (!region) continue;
    for (const AssemblyMode& mode : direct(robot(), values_at(from)).solutions) {
      const auto other = regions_of_struts().locate(mode.pose);
      if (!other || *other == *region) continue;
      ++pairs;
      EXPECT_FALSE(regions_of_struts().regions_along({from, mode.pose}));
    }
  }
  EXPECT_GT(pairs, 20);
}

// There and back through a strip: at two poses of each value of its lengths, which are the same.
TEST(PathInRegions, IsNotProvedThatCrossesAStripTwice) {
  std::mt19937_64 random(43);
  for (int across = 0, tried = 0; across < 6; ++tried) {
    ASSERT_LT(tried, 20000) << "only " << across << " segments that cross a strip";
    const Pose from = random_pose(random), to = moved(from, 2.0, random);
    if (!regions_of_struts().locate(from) || !regions_of_struts().locate(to)) continue;
    const auto regions = regions_of_struts().regions_along({from, to});
    if (!regions || regions->size() == 1) continue;
    ++across;
    EXPECT_FALSE(regions_of_struts().regions_along({from, to, from}));
  }
}

}  // namespace
}  // namespace parallel_aspects
