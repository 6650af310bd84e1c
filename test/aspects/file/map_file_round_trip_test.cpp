// SPDX-License-Identifier: BSD-3-Clause
// A map that was saved and loaded, or sent as bytes, gives every answer that it gave before.
#include "aspects/file/map_file_fixture.h"
#include "aspects/map/map_contents.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <functional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace parallel_aspects {
namespace {

using test::leaves;
using test::MapFile;
using test::random_pose;
using test::RobotPtr;

auto numbers(const Box& box) { return std::make_tuple(box.dimension, box.lower, box.upper); }

auto numbers(const Aspect& aspect) {
  return std::make_tuple(aspect.id, aspect.mode.index(), aspect.determinant_sign, aspect.measure,
                         aspect.measure_lower, aspect.measure_upper, aspect.inside_leaves,
                         numbers(aspect.bounds), aspect.deepest_clearance, aspect.unresolved_with);
}

void expect_equal(const AspectMap& one, const AspectMap& other) {
  EXPECT_EQ(one.working_modes(), other.working_modes());
  EXPECT_EQ(numbers(one.region()), numbers(other.region()));
  EXPECT_EQ(std::make_tuple(one.resolution(), one.proved_count(), one.unresolved(), one.measure_undecided(),
                            one.seconds()),
            std::make_tuple(other.resolution(), other.proved_count(), other.unresolved(),
                            other.measure_undecided(), other.seconds()));
  ASSERT_EQ(one.aspects().size(), other.aspects().size());
  for (std::size_t i = 0; i < one.aspects().size(); ++i) {
    const Aspect &a = one.aspects()[i], &b = other.aspects()[i];
    EXPECT_EQ(numbers(a), numbers(b)) << "aspect " << i + 1;
    EXPECT_EQ(a.deepest.position, b.deepest.position);
    EXPECT_EQ(a.deepest.orientation.coeffs(), b.deepest.orientation.coeffs());
  }
  EXPECT_TRUE(leaves(one) == leaves(other));
}

// The number of poses that are inside an aspect.
int expect_equal_locations(const AspectMap& one, const AspectMap& other, int count) {
  std::mt19937_64 random(7);
  int inside = 0;
  for (int i = 0; i < count; ++i) {
    const Pose pose = random_pose(one, random);
    for (const WorkingMode& mode : one.working_modes()) {
      const Location a = one.locate(pose, mode), b = other.locate(pose, mode);
      EXPECT_EQ(std::make_tuple(a.status, a.aspect), std::make_tuple(b.status, b.aspect))
          << to_string(one.manipulator()->task_space(), pose) << " in mode " << to_string(mode);
      if (a.status == LocationStatus::inside) ++inside;
    }
  }
  return inside;
}

struct Case {
  const char* name;
  std::function<RobotPtr()> make;
  double resolution;
};

RobotPtr slider() {
  Leg leg = test::planar_revolute_leg(0, {0.0, 0.0}, 1.0, 3.0);
  return test::manipulator("slider", TaskSpace::T1, {leg});
}

class RoundTrip : public MapFile, public testing::WithParamInterface<Case> {};

TEST_P(RoundTrip, EveryAnswerIsTheSame) {
  const RobotPtr robot = GetParam().make();
  MapOptions options = coarse(GetParam().resolution);
  options.modes = working_modes(*robot);
  if (test::is_sanitized && options.modes.size() > 2) options.modes.resize(2);
  options.extra_levels = 3;
  const MapResult computed = compute_aspect_map(robot, options);
  ASSERT_EQ(computed.status, MapStatus::complete) << computed.message;
  ASSERT_FALSE(computed.map->aspects().empty());
  const auto graph = compute_aspect_graph(*computed.map);
  ASSERT_TRUE(graph);
  const std::string bytes = saved(*computed.map);
  const MapResult loaded = load_map(robot, options, file_);
  ASSERT_EQ(loaded.status, MapStatus::complete) << loaded.message;
  EXPECT_EQ(loaded.map->manipulator(), robot);
  expect_equal(*computed.map, *loaded.map);
  ASSERT_TRUE(loaded.map->contents().graph) << "gates would be looked for again";
  EXPECT_TRUE(test::numbers(*graph) == test::numbers(*compute_aspect_graph(*loaded.map)));
  EXPECT_GT(expect_equal_locations(*computed.map, *loaded.map, test::thinned(1000)), test::thinned(100));
  EXPECT_EQ(saved(*loaded.map), bytes);
}

INSTANTIATE_TEST_SUITE_P(TaskSpaces, RoundTrip,
                         testing::Values(Case{"T1", slider, 0.01}, Case{"T2", test::five_bar, 0.2},
                                         Case{"T2_struts", test::bipod, 0.1},
                                         Case{"SE2", test::three_rrr, 2.0},
                                         Case{"SE2_struts", test::three_rpr, 5.0},
                                         Case{"T3", test::delta, 0.2}, Case{"SO3", test::agile_eye, 0.4}),
                         [](const auto& each) { return each.param.name; });

// A map in which small aspects were searched for serves whoever does not ask for that, and no other the one
// who does.
TEST_F(MapFile, CompleteMapsAreReported) {
  const RobotPtr robot = test::shipped("linear_delta")->mapped_manipulator();
  MapOptions plain = coarse(0.05);
  plain.modes = {working_modes(*robot).front()};
  MapOptions complete = plain;
  complete.complete = true;
  for (const MapOptions& computed : {plain, complete}) {
    saved(*compute_aspect_map(robot, computed).map);
    for (const MapOptions& asked : {plain, complete}) {
      const MapResult loaded = load_map(robot, asked, file_);
      EXPECT_EQ(loaded.map != nullptr, computed.complete || !asked.complete) << loaded.message;
      EXPECT_EQ(loaded.message.find("how many aspects there are at most") == std::string::npos,
                loaded.map != nullptr)
          << loaded.message;
    }
  }
}

// A display knows a map by its bytes alone, and not the options that it was computed with.
TEST(MapBytes, AreReadWithTheOptionsThatTheMapHas) {
  for (const char* const robot :
       {"five_bar", "bipod", "three_rrr", "linear_delta", "delta", "spherical_3rrr"}) {
    const RobotPtr manipulator = test::shipped(robot)->mapped_manipulator();
    MapOptions options;
    options.modes = {working_modes(*manipulator).front()};
    options.extra_levels = 2;
    const double size = manipulator->task_space() == TaskSpace::SO3 ? 4.0 : manipulator->size();
    options.resolution = size / 9.7;
    const auto map = compute_aspect_map(manipulator, options).map;
    ASSERT_TRUE(map) << robot;
    const std::vector<std::uint8_t> bytes = map_bytes(*map);
    const MapResult read = map_from_bytes(manipulator, options_of(*map), bytes);
    ASSERT_TRUE(read.map) << robot << ": " << read.message;
    expect_equal(*read.map, *map);
    EXPECT_EQ(map_bytes(*read.map), bytes) << robot;
  }
}

TEST(MapBytes, ThatAreCutOffAreRefused) {
  const RobotPtr manipulator = test::shipped("five_bar")->mapped_manipulator();
  MapOptions options;
  options.resolution = 1.0;
  const std::vector<std::uint8_t> bytes = map_bytes(*compute_aspect_map(manipulator, options).map);
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{19}, bytes.size() - 1}) {
    const MapResult read = map_from_bytes(manipulator, options,
                                          {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)});
    EXPECT_FALSE(read.map) << size;
    EXPECT_NE(read.message.find("not used, since"), std::string::npos) << read.message;
  }
}

}  // namespace
}  // namespace parallel_aspects
