// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/domain_watch.h"

#include "parallel_aspects/aspects/uniqueness.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

/// Regions 0 and 1 over one set, and 2 over another, which domains share with either. The region of a pose is
/// its x; none where that is negative.
std::shared_ptr<const Uniqueness> made_up() {
  auto uniqueness = std::make_shared<Uniqueness>();
  for (const std::size_t over : {0U, 0U, 1U}) {
    BasicRegion region;
    region.aspect = 1;
    region.over = over;
    region.is_unique = true;
    uniqueness->basic_regions.push_back(region);
  }
  uniqueness->domains = {{1, false, {0, 2}, 1.0}, {1, false, {1, 2}, 1.0}};
  uniqueness->region_of = [](const Pose& pose, const WorkingMode&) -> std::optional<std::size_t> {
    if (pose.position.x() < 0.0) return std::nullopt;
    return static_cast<std::size_t>(pose.position.x());
  };
  return uniqueness;
}

Pose in_region(int region) { return Pose::planar(region, 0.0, 0.0); }

// A region is one of a working mode: here that which has its index.
TEST(DomainWatch, LooksInTheWorkingModeOfThePose) {
  Uniqueness by_mode = *made_up();
  by_mode.region_of = [](const Pose&, const WorkingMode& mode) -> std::optional<std::size_t> {
    return mode.index();
  };
  DomainWatch watch(std::make_shared<const Uniqueness>(by_mode), 0.0);
  const Pose pose = in_region(0);
  EXPECT_EQ(watch.update(pose, WorkingMode::from_index(3, 0), 0.0).region, 0U);
  EXPECT_FALSE(watch.update(pose, WorkingMode::from_index(3, 2), 1.0).warns);
  EXPECT_TRUE(watch.update(pose, WorkingMode::from_index(3, 1), 2.0).warns);
}

TEST(DomainWatch, WarnsWhereNoDomainHoldsBothForSomeTime) {
  DomainWatch watch(made_up(), 0.1);
  EXPECT_FALSE(watch.update(in_region(0), {}, 0.0).warns);
  EXPECT_EQ(watch.state().sharing, DomainSharing::shared);
  EXPECT_FALSE(watch.update(in_region(2), {}, 0.5).warns);
  EXPECT_EQ(watch.state().sharing, DomainSharing::shared);
  EXPECT_FALSE(watch.update(in_region(1), {}, 1.0).warns);
  EXPECT_EQ(watch.state().sharing, DomainSharing::apart);
  EXPECT_FALSE(watch.update(in_region(1), {}, 1.05).warns);
  EXPECT_TRUE(watch.update(in_region(1), {}, 1.11).warns);
  EXPECT_TRUE(watch.state().changed);
  EXPECT_EQ(watch.state().before, 2U);
  EXPECT_EQ(watch.state().since, 1.0);
  EXPECT_TRUE(watch.update(in_region(1), {}, 1.2).warns);
  EXPECT_FALSE(watch.state().changed);
  EXPECT_TRUE(watch.update(in_region(2), {}, 1.3).warns);
  EXPECT_FALSE(watch.update(in_region(2), {}, 1.41).warns);
  EXPECT_TRUE(watch.state().changed);
  EXPECT_EQ(watch.state().before, 1U);
  EXPECT_EQ(watch.state().since, 1.3);
}

TEST(DomainWatch, IsNotMovedByFlutterNorByPosesOfNoRegion) {
  DomainWatch watch(made_up(), 0.1);
  watch.update(in_region(0), {}, 0.0);
  for (int i = 1; i < 100; ++i) EXPECT_FALSE(watch.update(in_region(i % 2), {}, 0.05 * i).warns);
  watch.restart();
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(watch.update(in_region(-1), {}, 10.0 + i).reference);
  EXPECT_EQ(watch.update(in_region(1), {}, 20.0).reference, 1U);
  EXPECT_FALSE(watch.update(in_region(0), {}, 20.5).warns);
  EXPECT_FALSE(watch.update(in_region(-1), {}, 30.0).warns);
  EXPECT_FALSE(watch.state().region);
  EXPECT_TRUE(watch.update(in_region(0), {}, 30.1).warns);
  watch.restart();
  EXPECT_FALSE(watch.state().warns);
  EXPECT_FALSE(watch.update(in_region(0), {}, 40.0).warns);
}

// Solutions of one aspect of a 3-RPR with a strut held.
TEST(DomainWatch, DistinguishesSolutionsOfOneAspect) {
  const auto robot = test::three_rpr()->with_constraints({});
  UniquenessOptions options;
  options.slice = test::slice_of(robot, {{robot->leg(0).actuated_joint, 14.98}});
  const UniquenessResult result = compute_uniqueness(robot, options);
  ASSERT_TRUE(result) << result.message;
  const auto& regions = result.uniqueness->basic_regions;
  int pairs = 0;
  for (const BasicRegion& from : regions)
    for (const BasicRegion& to : regions) {
      if (&from == &to || from.aspect != to.aspect || from.over != to.over || from.measure_lower < 10.0)
        continue;
      DomainWatch watch(result.uniqueness, 0.0);
      EXPECT_FALSE(watch.update(from.pose, {}, 0.0).warns);
      ASSERT_TRUE(watch.state().region);
      EXPECT_EQ(*watch.state().region, static_cast<std::size_t>(&from - regions.data()));
      EXPECT_TRUE(watch.update(to.pose, {}, 1.0).warns);
      EXPECT_EQ(watch.state().sharing, DomainSharing::apart);
      ++pairs;
    }
  EXPECT_GE(pairs, 12);
}

// Where there are no regions there is nothing to warn of.
TEST(DomainWatch, IsSilentWhereEachAspectIsADomain) {
  const UniquenessResult result = compute_uniqueness(test::bipod());
  ASSERT_TRUE(result) << result.message;
  DomainWatch watch(result.uniqueness, 0.0);
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(watch.update(Pose::planar(2.5, i - 2.5, 0.0), {}, i).warns);
}

}  // namespace
}  // namespace parallel_aspects
