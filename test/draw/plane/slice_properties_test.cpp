// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

using test::Held;
using test::map_of;
using test::options_of;
using test::random_position;
using test::Robot;
using test::slice_of;
using test::upright;

const int looks = test::thinned(100000), least_inside = test::thinned(50);

struct Case {
  const char* name;
  const char* robot;
  Held held;
  double resolution;
  std::size_t modes;  // how many are mapped; 0 for all
  std::optional<Box> region{};
};

class Slices : public testing::TestWithParam<Case> {
 protected:
  struct Computed {
    Robot robot;
    MapOptions options;
    std::shared_ptr<const AspectMap> map;
  };

  /// Computed by the first test that asks for it.
  static const Computed& computed() {
    static std::map<std::string, Computed> all;
    Computed& result = all[GetParam().name];
    if (result.map) return result;
    result.robot = test::shipped(GetParam().robot)->manipulator();
    std::vector<WorkingMode> modes = working_modes(*result.robot);
    if (GetParam().modes != 0) modes.resize(GetParam().modes);
    result.options = options_of(slice_of(result.robot, GetParam().held), GetParam().resolution, modes);
    result.options.region = GetParam().region;
    result.map = map_of(result.robot, result.options);
    return result;
  }

  const Robot& robot = computed().robot;
  const MapOptions& asked = computed().options;
  const std::shared_ptr<const AspectMap>& map = computed().map;

  const PoseSpace& space() const { return map->contents().tree.space(); }
};

// What the map calls inside or outside must hold at every pose of the slice.
TEST_P(Slices, NoPoseContradictsItsLeaf) {
  ASSERT_TRUE(map);
  std::mt19937_64 random(7);
  int inside = 0;
  const int trials = looks / static_cast<int>(asked.modes.size());
  for (int i = 0; i < trials; ++i) {
    const Pose pose = space().pose(random_position(space(), random));
    for (const WorkingMode& mode : asked.modes) {
      const Location location = map->locate(pose, mode);
      const std::optional<int> sign = test::sign_at(*robot, pose, mode);
      if (location.status == LocationStatus::undecided || !sign) continue;
      ASSERT_NE(location.status, LocationStatus::not_mapped);
      const bool is_inside = location.status == LocationStatus::inside;
      const auto index = static_cast<std::size_t>(location.aspect - 1);
      inside += is_inside;
      ASSERT_EQ(is_inside ? map->aspects()[index].determinant_sign : 0, *sign)
          << robot->name() << " in " << to_string(mode) << " at " << to_string(robot->task_space(), pose);
    }
  }
  EXPECT_GT(inside, least_inside);
}

TEST_P(Slices, PosesAndPositionsAreInverse) {
  ASSERT_TRUE(map);
  std::mt19937_64 random(8);
  for (int i = 0; i < 1000; ++i) {
    const Pose pose = space().pose(random_position(space(), random));
    const Pose again = space().pose(space().position(pose));
    EXPECT_TRUE(again.position.isApprox(pose.position, 1e-12) || pose.position.isZero());
    EXPECT_LT(again.orientation.angularDistance(pose.orientation), 1e-7);
    for (const HeldCoordinate& held : GetParam().held) {
      if (held.name == "x") {
        EXPECT_EQ(pose.position.x(), held.value);
      }
      if (held.name == "y") {
        EXPECT_EQ(pose.position.y(), held.value);
      }
      if (held.name == "z") {
        EXPECT_EQ(pose.position.z(), held.value);
      }
    }
  }
}

TEST_P(Slices, PosesOutsideTheSliceAreNotMapped) {
  ASSERT_TRUE(map);
  std::mt19937_64 random(9);
  const MapSlice& slice = *map->slice();
  for (int i = 0; i < 100; ++i) {
    const Pose pose = space().pose(random_position(space(), random));
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (slice.moves[static_cast<std::size_t>(k)]) continue;
      Pose away = pose;
      away.position[k] += 1e-3;
      EXPECT_EQ(map->locate(away, map->contents().modes.front()).status, LocationStatus::not_mapped);
    }
    if (slice.rotation != MapSlice::Rotation::none) continue;
    Pose turned = pose;
    turned.orientation = Eigen::AngleAxisd(1e-3, Eigen::Vector3d::UnitZ()) * pose.orientation;
    EXPECT_EQ(map->locate(turned, map->contents().modes.front()).status, LocationStatus::not_mapped);
  }
}

TEST_P(Slices, AreSavedAndLoaded) {
  ASSERT_TRUE(map);
  const std::string file = testing::TempDir() + "slice_" + GetParam().name + ".map";
  ASSERT_TRUE(save_map(*map, file).saved);
  MapOptions options = asked;
  const MapResult loaded = load_map(robot, options, file);
  ASSERT_TRUE(loaded.map) << loaded.message;
  EXPECT_EQ(loaded.map->aspects().size(), map->aspects().size());
  EXPECT_EQ(loaded.map->coordinates(), map->coordinates());
  options.slice->held.position[2] += 1e-9;
  if (robot->task_space() == TaskSpace::SE3) {
    EXPECT_FALSE(load_map(robot, options, file).map);
  }
  options.slice.reset();
  EXPECT_FALSE(load_map(robot, options, file).map);
  std::filesystem::remove(file);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, Slices,
    testing::Values(
        Case{"stewart_plane", "stewart", upright({{"z", 1.3}}), 0.05, 0},
        Case{"stewart_volume", "stewart", {{"roll", 0.3}, {"pitch", -0.2}, {"yaw", 0.1}}, 0.15, 0},
        Case{"stewart_line", "stewart", upright({{"x", 0.0}, {"y", 0.1}}), 0.05, 0},
        Case{"stewart_yaw", "stewart", {{"z", 1.3}, {"roll", 0.1}, {"pitch", 0.2}}, 0.2, 0},
        Case{"stewart_pitch", "stewart", {{"x", 0.1}, {"y", 0.0}, {"roll", 0.3}, {"yaw", 0.7}}, 0.05, 0},
        Case{"stewart_roll",
             "stewart",
             {{"x", 0.1}, {"y", 0.0}, {"z", 1.3}, {"pitch", 0.2}, {"yaw", 0.3}},
             0.05,
             0},
        Case{"stewart_orientations", "stewart", {{"x", 0.1}, {"y", 0.0}, {"z", 1.3}}, 0.3, 0},
        Case{"hexa_plane", "hexa", upright({{"z", -0.6}}), 0.05, 4},
        Case{"hexa_volume",
             "hexa",
             {{"roll", 0.2}, {"pitch", 0.1}, {"yaw", -0.1}},
             0.06,
             2,
             Box{3, {-0.15, -0.2, -0.7}, {0.2, 0.15, -0.4}}},
        Case{"hexa_yaw", "hexa", {{"z", -0.6}, {"roll", 0.1}, {"pitch", 0.0}}, 0.2, 2},
        Case{"six_pus_plane", "six_pus", {{"x", 0.0}, {"roll", 0.1}, {"pitch", 0.0}, {"yaw", 0.2}}, 0.05, 8},
        Case{"six_pus_pitch", "six_pus", {{"x", 0.0}, {"y", 0.1}, {"roll", 0.1}, {"yaw", 0.2}}, 0.1, 4},
        Case{"three_rrr_phi", "three_rrr", {{"phi", 0.4}}, 0.5, 0},
        Case{"three_rrr_x", "three_rrr", {{"x", -3.0}}, 0.5, 0},
        Case{"three_prr_line", "three_prr", {{"x", 0.1}, {"y", 0.0}}, 0.01, 0},
        Case{"delta_z", "delta", {{"z", -0.6}}, 0.05, 0},
        Case{"five_bar_y", "five_bar", {{"y", 5.0}}, 0.05, 0},
        Case{"agile_eye_yaw", "agile_eye", {{"roll", 0.1}, {"pitch", 0.2}}, 0.01, 0}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace parallel_aspects
