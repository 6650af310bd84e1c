// SPDX-License-Identifier: BSD-3-Clause
// Maps in shards: the same whoever computes which shard and however the space is divided, and in agreement
// with maps that are computed as one.
#include "aspects/shards/sharded_map.h"

#include "aspects/shards/shard.h"
#include "aspects/tree/neighbour_leaves.h"
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

namespace fs = std::filesystem;

/// Does the last task first, and each in a copy of its bytes as another process would.
class BackwardCrew final : public ShardCrew {
 public:
  bool is_first() const override { return true; }
  std::optional<PartResults> perform(std::size_t count, std::size_t parts, const ShardFunction& work,
                                     const MapControl&) override {
    PartResults results(parts, std::vector<Bytes>(count));
    for (std::size_t i = count; i-- > 0;) {
      const std::vector<Bytes> result = work(i);
      for (std::size_t part = 0; part < parts; ++part) results[part][i] = result[part];
    }
    return results;
  }
  std::vector<Bytes> gather(std::size_t parts, const PartFunction& work) override {
    std::vector<Bytes> results(parts);
    for (std::size_t part = parts; part-- > 0;) results[part] = work(part);
    return results;
  }
  Bytes tell_all(Bytes bytes) override { return bytes; }
};

class ShardedMaps : public testing::Test {
 protected:
  ShardedMaps() {
    std::string pattern = (fs::temp_directory_path() / "shards_XXXXXX").string();
    folder_ = mkdtemp(pattern.data()) == nullptr ? "" : pattern;
  }
  ~ShardedMaps() override { fs::remove_all(folder_); }

  std::string folder(const std::string& name) const { return folder_ + "/" + name; }

  static ShardPlan plan_of(const Manipulator& robot, double resolution, std::uint32_t level,
                           int extra_levels) {
    MapOptions options;
    options.resolution = resolution;
    options.extra_levels = extra_levels;
    ShardPlan plan;
    EXPECT_EQ(make_shard_plan(robot, options, level, plan), "");
    return plan;
  }

  ShardedMap computed(const ShardPlan& plan, const std::string& name, ShardCrew&& crew = LoneCrew()) const {
    const auto map = compute_sharded_map(plan, folder(name), crew, {}, {});
    EXPECT_TRUE(map);
    return map.value_or(ShardedMap());
  }

  std::string folder_;
};

void expect_equal(const ShardedMap& a, const ShardedMap& b) {
  ASSERT_EQ(a.aspects.size(), b.aspects.size());
  for (std::size_t i = 0; i < a.aspects.size(); ++i) {
    EXPECT_EQ(a.aspects[i].mode, b.aspects[i].mode);
    EXPECT_EQ(a.aspects[i].determinant_sign, b.aspects[i].determinant_sign);
    EXPECT_EQ(a.aspects[i].inside.of_level, b.aspects[i].inside.of_level);
    EXPECT_EQ(a.aspects[i].inside.measure, b.aspects[i].inside.measure);
  }
  EXPECT_EQ(a.unresolved, b.unresolved);
  EXPECT_EQ(a.proved_count, b.proved_count);
  EXPECT_EQ(a.undecided.of_level, b.undecided.of_level);
  EXPECT_EQ(a.rounds, b.rounds);
}

struct Case {
  const char* name;
  std::shared_ptr<const Manipulator> robot;
  double resolution;
};

std::vector<Case> cases() {
  return {{"five_bar", test::five_bar(), 0.4},
          {"three_rpr", test::three_rpr(), 2.0},
          {"three_rrr", test::three_rrr(), 2.0},
          {"agile_eye", test::agile_eye(), 0.4},
          {"delta", test::delta(), 0.1}};
}

TEST_F(ShardedMaps, AreTheSameInAnyOrderAndAgainFromTheirFiles) {
  for (const auto& [name, robot, resolution] : cases()) {
    SCOPED_TRACE(name);
    const ShardPlan plan = plan_of(*robot, resolution, 2, 3);
    const ShardedMap map = computed(plan, std::string(name) + "_forward");
    EXPECT_GT(map.aspects.size(), 0U);
    expect_equal(map, computed(plan, std::string(name) + "_backward", BackwardCrew()));
    expect_equal(map, computed(plan, std::string(name) + "_forward"));
  }
}

// Without refinement an aspect is a connected set of inside leaves, and two are apart where no chain of
// undecided leaves links them, which does not depend on the division. Whole maps of one shard have no borders
// at all.
TEST_F(ShardedMaps, DoNotDependOnTheDivision) {
  for (const auto& [name, robot, resolution] : cases()) {
    SCOPED_TRACE(name);
    const double coarse = 2.0 * resolution;
    const ShardedMap whole = computed(plan_of(*robot, coarse, 0, 0), std::string(name) + "_0");
    for (const std::uint32_t level : {1U, 2U, 3U}) {
      const ShardedMap map = computed(plan_of(*robot, coarse, level, 0), name + std::to_string(level));
      ASSERT_EQ(map.aspects.size(), whole.aspects.size()) << "level " << level;
      EXPECT_EQ(map.proved_count, whole.proved_count) << "level " << level;
      EXPECT_EQ(map.unresolved.empty(), whole.unresolved.empty());
      for (std::size_t i = 0; i < map.aspects.size(); ++i)
        EXPECT_NEAR(map.aspects[i].inside.measure, whole.aspects[i].inside.measure,
                    1e-9 * whole.aspects[i].inside.measure);
    }
  }
}

// Whatever one computation proves the other cannot contradict.
TEST_F(ShardedMaps, AgreeWithMapsComputedAsOne) {
  for (const auto& [name, robot, resolution] : cases()) {
    SCOPED_TRACE(name);
    MapOptions options;
    options.resolution = resolution;
    options.extra_levels = 4;
    const MapResult whole = compute_aspect_map(robot, options, {});
    ASSERT_EQ(whole.status, MapStatus::complete);
    const ShardedMap map = computed(plan_of(*robot, resolution, 2, 4), name);
    EXPECT_LE(map.proved_count, whole.map->count_at_most().value_or(map.proved_count));
    double inside = 0.0, least = 0.0;
    for (const ShardedMap::Part& part : map.aspects) inside += part.inside.measure;
    for (const Aspect& aspect : whole.map->aspects()) least += aspect.measure_lower;
    EXPECT_LE(inside, least + whole.map->measure_undecided() + 1e-9 * least);
    EXPECT_LE(least, inside + map.undecided.measure + 1e-9 * inside);
  }
}

TEST_F(ShardedMaps, OfTheFiveBarHaveTenAspects) {
  const ShardedMap map = computed(plan_of(*test::five_bar(), 0.1, 3, 6), "five_bar");
  EXPECT_EQ(map.proved_count, 10U);
  std::vector<double> measures;
  for (const ShardedMap::Part& part : map.aspects) measures.push_back(part.inside.measure);
  std::sort(measures.rbegin(), measures.rend());
  // Areas by brute force, each twice.
  const std::vector<double> areas{193.58, 193.58, 135.35, 135.35, 109.78, 109.78, 47.85, 47.85, 3.70, 3.70};
  ASSERT_GE(measures.size(), areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(measures[i], areas[i], 0.04 * areas[i] + 0.5);
}

TEST_F(ShardedMaps, DamagedFilesAreComputedAnew) {
  const ShardPlan plan = plan_of(*test::five_bar(), 0.4, 1, 2);
  const ShardedMap map = computed(plan, "five_bar");
  for (const char* damage : {"", "no shard", "AAAAAAAAAAAAAAAAAAAAAAAA"}) {
    std::ofstream(folder("five_bar") + "/shard_2") << damage;
    std::vector<std::string> notes;
    LoneCrew crew;
    const auto again = compute_sharded_map(plan, folder("five_bar"), crew, {},
                                           [&notes](const std::string& note) { notes.push_back(note); });
    ASSERT_TRUE(again);
    expect_equal(map, *again);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes.front().find("shard_2' is not used"), std::string::npos) << notes.front();
  }
}

TEST_F(ShardedMaps, AFileOfAnotherShardIsComputedAnew) {
  const ShardPlan plan = plan_of(*test::five_bar(), 0.4, 1, 2);
  const ShardedMap map = computed(plan, "five_bar");
  fs::copy_file(folder("five_bar") + "/shard_1", folder("five_bar") + "/shard_2",
                fs::copy_options::overwrite_existing);
  expect_equal(map, computed(plan, "five_bar"));
}

TEST_F(ShardedMaps, FoldersOfAnotherMapAreRefused) {
  computed(plan_of(*test::five_bar(), 0.4, 1, 2), "five_bar");
  LoneCrew crew;
  const ShardPlan other = plan_of(*test::five_bar(), 0.2, 1, 2);
  EXPECT_THROW(compute_sharded_map(other, folder("five_bar"), crew, {}, {}), InvalidDescription);
}

TEST_F(ShardedMaps, SayNothingOfModesThatAreNotAskedFor) {
  const ShardPlan plan = plan_of(*test::three_rrr(), 2.0, 1, 0);
  const auto tree = grow_shard(plan, 3, {});
  ASSERT_TRUE(tree);
  std::vector<bool> modes(plan.map.modes.size(), true);
  const auto all = records_of(*tree, plan.place(3), modes, {});
  modes[0] = false;
  const auto some = records_of(*tree, plan.place(3), modes, {});
  ASSERT_TRUE(all && some);
  for (const int sign : {1, -1}) {
    EXPECT_TRUE((*some)[part_of(0, sign)].empty());
    EXPECT_EQ((*some)[part_of(1, sign)], (*all)[part_of(1, sign)]);
    Bytes bytes = (*all)[part_of(1, sign)];
    const SignRecord record = sign_record(bytes);
    EXPECT_GT(record.border.size(), 0U);
    for (const auto& leaf : record.border) EXPECT_LT(leaf.label, record.label_count());
    bytes.resize(bytes.size() - 1);
    EXPECT_THROW(sign_record(bytes), InvalidDescription);
  }
}

TEST_F(ShardedMaps, ShardsFinerThanTheMapAreRefused) {
  MapOptions options;
  options.resolution = 5.0;
  ShardPlan plan;
  EXPECT_NE(make_shard_plan(*test::five_bar(), options, 9, plan).find("finer than the map"),
            std::string::npos);
}

TEST_F(ShardedMaps, EndWhenCancelled) {
  const std::atomic<bool> cancelled{true};
  LoneCrew crew;
  const ShardPlan plan = plan_of(*test::five_bar(), 0.4, 1, 2);
  EXPECT_FALSE(compute_sharded_map(plan, folder("five_bar"), crew, {{}, &cancelled}, {}));
}

// Of a tree whose leaves are all of one level, the neighbours of a leaf are the places across its faces.
TEST(PlaceAcross, FindsTheNeighbours) {
  for (const auto& space : {make_pose_space(TaskSpace::T2, Box{2, {0, 0}, {1, 1}}, 1.0),
                            make_pose_space(TaskSpace::SE2, Box{2, {0, 0}, {1, 1}}, 1.0),
                            make_pose_space(TaskSpace::SO3, Box{}, 1.0)}) {
    PoseTree tree(space, 1);
    for (NodeIndex node = 0; tree.place(node).level < 2; ++node) {
      tree.state(node, 0) = LeafState::undecided(true, true);
      tree.divide(node, [](std::size_t) { return true; });
    }
    for (NodeIndex node = 0; node < tree.node_count(); ++node)
      if (tree.state(node, 0).is_pending()) tree.state(node, 0) = LeafState::inside(1);
    for (NodeIndex node = 0; node < tree.node_count(); ++node) {
      if (!tree.state(node, 0).is_inside()) continue;
      std::vector<NodeIndex> neighbours = neighbour_leaves(tree, 0, node);
      std::sort(neighbours.begin(), neighbours.end());
      neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
      std::vector<NodeIndex> across;
      for (std::size_t axis = 0; axis < tree.dimension(); ++axis)
        for (const bool upper : {false, true})
          if (const auto place = place_across(*space, tree.place(node), {axis, upper}))
            for (NodeIndex other = 0; other < tree.node_count(); ++other)
              if (tree.place(other).level == place->level && tree.place(other).root == place->root &&
                  tree.place(other).cell == place->cell)
                across.push_back(other);
      std::sort(across.begin(), across.end());
      across.erase(std::unique(across.begin(), across.end()), across.end());
      EXPECT_EQ(neighbours, across) << "node " << node << " of " << tree.root_count() << " roots";
    }
  }
}

}  // namespace
}  // namespace parallel_aspects
