// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/disjoint_sets.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::uniform;

std::shared_ptr<const AspectMap> whole_map(const Robot& robot) {
  const MapResult result = compute_aspect_map(robot);
  EXPECT_TRUE(result.map) << result.message;
  return result.map;
}

// The ten aspects of the paper's five-bar; in an RR-RRR the sign of det A is the assembly mode.
TEST(AspectGraph, JoinsTheTenAspectsOfTheFiveBarIntoTwoSets) {
  const auto map = whole_map(test::five_bar());
  const auto graph = compute_aspect_graph(*map);
  ASSERT_TRUE(graph);
  ASSERT_EQ(graph->sets.size(), 2U);
  EXPECT_EQ(graph->proved_set_count, 2U);
  for (const AspectSet& set : graph->sets) {
    EXPECT_EQ(set.aspects.size(), 5U);
    for (const int id : set.aspects)
      EXPECT_EQ(map->aspects()[static_cast<std::size_t>(id - 1)].determinant_sign, set.determinant_sign);
  }
}

// Against random poses that are reached in some mode with the sign of the set.
TEST(AspectGraph, MeasuresTheWorkspaceOfASetOnce) {
  const Robot robot = test::five_bar();
  const auto map = whole_map(robot);
  const auto graph = compute_aspect_graph(*map);
  ASSERT_TRUE(graph);
  std::mt19937_64 random(5);
  const int samples = 200000;
  const Box& region = map->region();
  std::map<int, int> hits;
  for (int i = 0; i < samples; ++i) {
    const Pose pose = Pose::planar(uniform(random, region.lower[0], region.upper[0]),
                                   uniform(random, region.lower[1], region.upper[1]));
    for (const int sign : {1, -1})
      for (const WorkingMode& mode : working_modes(*robot))
        if (test::sign_at(*robot, pose, mode).value_or(0) == sign) {
          ++hits[sign];
          break;
        }
  }
  for (const AspectSet& set : graph->sets) {
    const double area = region.measure() * hits[set.determinant_sign] / samples;
    EXPECT_NEAR(set.workspace_lower, area, 0.03 * area);
    EXPECT_LT(set.workspace_lower, 1.01 * area);
  }
}

/// Which poses of a grid one can get to from which, by plain arithmetic at many points: in one working mode
/// from a point to the next, and from mode to mode beside where a leg just does not reach any more.
class Flood {
 public:
  static constexpr int cells = 60, steps = 10;

  Flood(const Manipulator& robot, const Box& region, int sign)
      : robot_(robot), region_(region), sign_(sign), modes_(working_modes(robot)), sets_(count()) {
    for (std::size_t mode = 0; mode < modes_.size(); ++mode)
      for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
          if (!is_free(center(x, y), mode)) continue;
          join(x, y, x + 1, y, mode);
          join(x, y, x, y + 1, mode);
          for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) turn(x, y, dx, dy, mode);
        }
  }

  std::uint32_t set(int x, int y, std::size_t mode) { return sets_.find(item(x, y, mode)); }
  bool is_free(const Pose& pose, std::size_t mode) const {
    return test::sign_at(robot_, pose, modes_[mode]).value_or(0) == sign_;
  }
  Pose center(double x, double y) const {
    return Pose::planar(region_.lower[0] + (x + 0.5) * region_.width(0) / cells,
                        region_.lower[1] + (y + 0.5) * region_.width(1) / cells);
  }
  const std::vector<WorkingMode>& modes() const { return modes_; }

 private:
  std::size_t count() const { return modes_.size() * cells * cells; }
  std::uint32_t item(int x, int y, std::size_t mode) const {
    return static_cast<std::uint32_t>((mode * cells + static_cast<std::size_t>(y)) * cells +
                                      static_cast<std::size_t>(x));
  }

  void join(int x, int y, int to_x, int to_y, std::size_t mode) {
    if (to_x >= cells || to_y >= cells) return;
    for (int i = 1; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      if (!is_free(center(x + share * (to_x - x), y + share * (to_y - y)), mode)) return;
    }
    sets_.unite(item(x, y, mode), item(to_x, to_y, mode));
  }

  /// Straight on until one leg alone does not reach, in this mode and in the other one of this leg.
  void turn(int x, int y, int dx, int dy, std::size_t mode) {
    constexpr int fine = 200;
    for (int i = 1; i <= fine; ++i) {
      const Pose pose =
          center(x + dx * i / static_cast<double>(fine), y + dy * i / static_cast<double>(fine));
      std::vector<std::size_t> beyond;
      for (std::size_t j = 0; j < robot_.leg_count(); ++j)
        if (squared_inverse_entry(robot_.leg(j), pose.transform(robot_.leg(j).anchor)) < 0.0)
          beyond.push_back(j);
      if (beyond.size() > 1) return;
      if (beyond.size() == 1) return unite_postures(x, y, pose, mode, beyond.front());
      if (!is_free(pose, mode)) return;
    }
  }

  void unite_postures(int x, int y, const Pose& end, std::size_t mode, std::size_t leg) {
    WorkingMode flipped = modes_[mode];
    flipped.set_sign(leg, -flipped.sign(leg));
    std::size_t other = 0;
    while (modes_[other] != flipped) ++other;
    const Pose start = center(x, y);
    for (int i = 0; i < 200; ++i)
      if (!is_free(pose_between(start, end, i / 200.0), other)) return;
    sets_.unite(item(x, y, mode), item(x, y, other));
  }

  const Manipulator& robot_;
  Box region_;
  int sign_;
  std::vector<WorkingMode> modes_;
  DisjointSets sets_;
};

Robot limited_five_bar(std::mt19937_64& random) {
  std::vector<Leg> legs{
      test::planar_revolute_leg(0, {0.0, 0.0}, uniform(random, 0.8, 1.6), uniform(random, 0.8, 1.6)),
      test::planar_revolute_leg(1, {uniform(random, 0.4, 1.2), 0.0}, uniform(random, 0.8, 1.6),
                                uniform(random, 0.8, 1.6))};
  for (Leg& leg : legs) {
    const double middle = uniform(random, -3.0, 3.0), half = uniform(random, 0.3, 1.6);
    leg.limits = JointLimits{middle - half, middle + half};
  }
  return test::manipulator("limited five-bar", TaskSpace::T2, std::move(legs));
}

// Limits keep some legs from being stretched or folded, so that sets of one sign are apart.
TEST(AspectGraph, NoFloodJoinsWhatIsProvedApart) {
  int apart = 0, joined = 0;
  const int robots = test::is_sanitized ? 2 : 12;
  for (int seed = 1; seed <= robots; ++seed) {
    std::mt19937_64 random(static_cast<unsigned>(seed));
    const Robot robot = limited_five_bar(random);
    const auto map = whole_map(robot);
    const auto graph = compute_aspect_graph(*map);
    ASSERT_TRUE(graph);
    for (const int sign : {1, -1}) {
      Flood flood(*robot, map->region(), sign);
      std::map<std::uint32_t, std::size_t> group_of_flood;
      for (std::size_t mode = 0; mode < flood.modes().size(); ++mode)
        for (int y = 0; y < Flood::cells; ++y)
          for (int x = 0; x < Flood::cells; ++x) {
            const Location at = map->locate(flood.center(x, y), flood.modes()[mode]);
            if (!at || !flood.is_free(flood.center(x, y), mode)) continue;
            const std::size_t group = graph->set_group[graph->set_of(at.aspect)];
            const auto [known, is_new] = group_of_flood.emplace(flood.set(x, y, mode), group);
            joined += !is_new;
            ASSERT_EQ(known->second, group)
                << "seed " << seed << ", sign " << sign << ", cell " << x << ' ' << y;
          }
    }
    apart += graph->proved_set_count > 2;
  }
  EXPECT_GT(joined, 1000);
  if (!test::is_sanitized) {
    EXPECT_GT(apart, 0) << "robots with sets of one sign that are apart";
  }
}

// A serial margin shuts out what gates lead through, so that leaves prove nothing apart.
TEST(AspectGraph, SetsOfOneSignAreNotProvedApartUnderASerialMargin) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10; ++i) {
    const auto map = whole_map(limited_five_bar(random)->with_margins({0.0, 0.05, 0.0}));
    const auto graph = compute_aspect_graph(*map);
    ASSERT_TRUE(graph);
    EXPECT_LE(graph->proved_set_count, 2U);
  }
}

// What joins the aspects of some working modes may lead through others.
TEST(AspectGraph, SetsOfOneSignAreNotProvedApartWhereModesAreLeftOut) {
  MapOptions options;
  options.modes = {*WorkingMode::from_signs({1, 1}), *WorkingMode::from_signs({-1, -1})};
  const auto map = test::map_of(test::five_bar(), options);
  const auto graph = compute_aspect_graph(*map);
  ASSERT_TRUE(graph);
  EXPECT_GT(graph->sets.size(), 2U);
  EXPECT_EQ(graph->proved_set_count, 2U);
}

TEST(AspectGraph, EndsWhereItIsCancelled) {
  const auto map = whole_map(test::five_bar());
  const std::atomic<bool> cancelled(true);
  MapControl control;
  control.cancelled = &cancelled;
  EXPECT_FALSE(compute_aspect_graph(*map, control));
}

}  // namespace
}  // namespace parallel_aspects
