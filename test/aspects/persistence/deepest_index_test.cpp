// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/persistence/deepest_index.h"

#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/connectivity.h"

#include <gtest/gtest.h>

#include "support/configuration_at.h"
#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

struct Subject {
  const char* name;
  std::function<std::shared_ptr<const Manipulator>()> make;
  test::Held held;    // of a slice; empty for a map
  double resolution;  // 0 for what suits the robot
  double loosest;     // gap that is allowed; over a bound near 1, or as a share of it
};

/// The largest index of each aspect, against poses that are evaluated by formulas of the test alone.
class DeepestIndexTest : public testing::TestWithParam<Subject> {
 protected:
  /// All tests of a subject look at one map.
  static MapResult map_of(const Subject& subject) {
    static std::map<std::string, MapResult> results;
    const auto known = results.find(subject.name);
    if (known != results.end()) return known->second;
    const auto robot = subject.make();
    MapOptions options;
    if (!subject.held.empty()) options.slice = test::slice_of(robot, subject.held);
    if (subject.resolution > 0.0) options.resolution = subject.resolution;
    if (test::is_sanitized) options.modes = {WorkingMode(robot->leg_count())};
    return results[subject.name] = compute_aspect_map(robot, options);
  }

  void SetUp() override {
    const MapResult result = map_of(GetParam());
    ASSERT_TRUE(result.map) << result.message;
    map = result.map;
  }

  /// Of that map, for all tests of the subject.
  const std::optional<MapBasins>& depths(ParallelIndex index) const {
    static std::map<std::pair<std::string, ParallelIndex>, std::optional<MapBasins>> results;
    const auto [entry, is_new] = results.try_emplace({GetParam().name, index});
    if (is_new) entry->second = find_basins(*map, index, BasinDetail::depths);
    return entry->second;
  }

  double index_at(ParallelIndex index, const Pose& pose, const WorkingMode& mode) const {
    const test::ConfigurationAt<long double> at(*map->manipulator(), pose, mode);
    return static_cast<double>(
        std::abs(index == ParallelIndex::normalised ? at.parallel() : at.determinant()));
  }

  std::string text(const Pose& pose, const WorkingMode& mode) const {
    return GetParam().name + (" at " + to_string(map->manipulator()->task_space(), pose)) + " in " +
           to_string(mode);
  }

  /// In a leaf that is not outside: small ones, which lie where much happens, are as probable as large ones.
  MapPosition draw(std::size_t mode) {
    const AspectMap::Contents& contents = map->contents();
    for (;;) {
      const auto node = static_cast<NodeIndex>(random() % contents.tree.node_count());
      const LeafState state = contents.tree.state(node, mode);
      if (!state.may_be(1) && !state.may_be(-1)) continue;
      const Box box = contents.tree.box(node);
      MapPosition position{contents.tree.place(node).root, {}};
      for (std::size_t i = 0; i < box.dimension; ++i)
        position.point[i] = test::uniform(random, box.lower[i], box.upper[i]);
      return position;
    }
  }

  std::shared_ptr<const AspectMap> map;
  std::mt19937_64 random{29};
};

// Images of symmetries included.
TEST_P(DeepestIndexTest, NoPoseHasALargerIndex) {
  const AspectMap::Contents& contents = map->contents();
  for (const ParallelIndex index : {ParallelIndex::normalised, ParallelIndex::determinant}) {
    const auto& basins = depths(index);
    ASSERT_TRUE(basins);
    int found = 0;
    for (int n = 0; n < test::thinned(10000) && !HasFailure(); ++n) {
      const std::size_t k = random() % contents.modes.size();
      const Pose pose = contents.tree.space().pose(draw(k));
      const Location location = map->locate(pose, contents.modes[k]);
      if (!location) continue;
      ++found;
      const double upper = basins->deepest[static_cast<std::size_t>(location.aspect - 1)].upper;
      EXPECT_LE(index_at(index, pose, contents.modes[k]), upper * (1.0 + 1e-12))
          << text(pose, contents.modes[k]) << ", aspect " << location.aspect;
    }
    EXPECT_GT(found, test::thinned(200));
  }
}

TEST_P(DeepestIndexTest, WitnessesHaveTheIndexTheyStandFor) {
  const AspectMap::Contents& contents = map->contents();
  for (const int sign : {1, -1}) {
    const IndexOfMode what{0, sign, ParallelIndex::normalised};
    IndexCells cells(contents, what);
    DeepestIndex deepest(cells, find_index_peaks(contents, what, {}), {});
    deepest.search();
    for (const auto& [id, range] : deepest.ranges()) {
      const IndexPeak& peak = deepest.peaks().at(id);
      EXPECT_EQ(peak.index, range.lower);
      const Pose pose = contents.tree.space().pose(peak.at);
      const double index = index_at(ParallelIndex::normalised, pose, contents.modes[0]);
      EXPECT_GE(index, range.lower - 1e-9) << text(pose, contents.modes[0]);
      EXPECT_LE(index, range.upper + 1e-9) << text(pose, contents.modes[0]);
      EXPECT_EQ(map->aspects()[static_cast<std::size_t>(id - 1)].determinant_sign, sign);
    }
  }
}

TEST_P(DeepestIndexTest, TheBoundsAreClose) {
  const auto& basins = depths(ParallelIndex::normalised);
  ASSERT_TRUE(basins);
  for (std::size_t i = 0; i < basins->deepest.size(); ++i) {
    const IndexRange& range = basins->deepest[i];
    EXPECT_LE(range.upper - range.lower, GetParam().loosest)
        << "aspect " << i + 1 << ": " << range.lower << " to " << range.upper;
  }
}

// Both ways to the bounds: modes that are images, and every mode by itself.
TEST_P(DeepestIndexTest, ImagesOfModesAgreeWithTheirOwnBounds) {
  const auto& images = depths(ParallelIndex::normalised);
  const auto own = find_basins(*map, ParallelIndex::normalised, BasinDetail::basins);
  ASSERT_TRUE(images && own);
  for (std::size_t i = 0; i < images->deepest.size(); ++i) {
    EXPECT_LE(images->deepest[i].lower, own->deepest[i].upper);
    EXPECT_GE(images->deepest[i].upper, own->deepest[i].lower);
  }
  for (std::size_t i = 0; i < images->bottlenecks.size(); ++i) {
    EXPECT_EQ(images->bottlenecks[i].lower, 0.0);
    EXPECT_GT(images->bottlenecks[i].upper, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, DeepestIndexTest,
                         testing::Values(Subject{"five_bar", test::five_bar, {}, 0.0, 0.05},
                                         Subject{"bipod", test::bipod, {}, 0.0, 0.05},
                                         Subject{
                                             "three_rrr_slice", test::three_rrr, {{"phi", 0.3}}, 0.0, 1.0},
                                         Subject{"delta_slice", test::delta, {{"z", -0.6}}, 0.0, 0.05},
                                         Subject{"delta", test::delta, {}, 0.12, 1.0},
                                         Subject{"three_rrr", test::three_rrr, {}, 2.0, 1.0}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace parallel_aspects
