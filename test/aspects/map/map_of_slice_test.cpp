// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace parallel_aspects {
namespace {

using test::map_of;
using test::options_of;
using test::Robot;
using test::slice_of;
using test::uniform;
using test::upright;

// Without tilt and with both hexagons planar, det A is a constant times z^3, whatever x and y.
TEST(MapOfSlice, StewartPlatformWithoutTiltIsSingularInOnePlaneOnly) {
  const Robot robot = test::shipped("stewart")->manipulator();
  const auto map = map_of(robot, options_of(slice_of(robot, upright()), 0.1));
  ASSERT_EQ(map->aspects().size(), 2U);
  EXPECT_EQ(map->proved_count(), 2U);
  const double lower = map->aspects()[0].measure_lower;
  EXPECT_NEAR(map->aspects()[1].measure_lower, lower, 1e-3 * lower) << "but for leaves divided further";
  EXPECT_GT(map->aspects()[0].bounds.lower[2], 0.0);
  EXPECT_LT(map->aspects()[1].bounds.upper[2], 0.0);
  EXPECT_EQ(map->unit(), "m^3");
}

/// Cells of one working mode and sign on a fine grid, joined by flood fill.
class SliceFlood {
 public:
  static constexpr int cells = 600;

  SliceFlood(const Manipulator& robot, const WorkingMode& mode, int sign) : free_(cells * cells) {
    for (int k = 0; k < cells * cells; ++k) {
      Pose pose;
      pose.position << center(k % cells), center(k / cells), 0.0;
      const InverseSolution solution = inverse(robot, pose, mode);
      free_[static_cast<std::size_t>(k)] = solution.status == InverseStatus::solved &&
                                           sign * direct_determinant(robot, pose, solution.q) > 0.0;
    }
  }

  /// Cells of each set that is connected.
  std::vector<std::vector<Eigen::Vector2d>> pieces() {
    std::vector<std::vector<Eigen::Vector2d>> result;
    for (int k = 0; k < cells * cells; ++k)
      if (free_[static_cast<std::size_t>(k)]) result.push_back(take(k));
    return result;
  }

  static constexpr double area_of_cell() { return width * width; }

 private:
  static constexpr double lowest = -20.0, width = 30.0 / cells;
  static double center(int i) { return lowest + (i + 0.5) * width; }

  std::vector<Eigen::Vector2d> take(int start) {
    std::vector<Eigen::Vector2d> piece;
    std::vector<int> open{start};
    while (!open.empty()) {
      const int k = open.back();
      open.pop_back();
      if (!free_[static_cast<std::size_t>(k)]) continue;
      free_[static_cast<std::size_t>(k)] = false;
      piece.emplace_back(center(k % cells), center(k / cells));
      if (k % cells > 0) open.push_back(k - 1);
      if (k % cells < cells - 1) open.push_back(k + 1);
      if (k >= cells) open.push_back(k - cells);
      if (k < cells * (cells - 1)) open.push_back(k + cells);
    }
    return piece;
  }

  std::vector<bool> free_;
};

/// The aspect that holds every cell that the map decides; 0 where there are two.
int the_one_aspect_of(const AspectMap& map, const WorkingMode& mode,
                      const std::vector<Eigen::Vector2d>& piece) {
  std::set<int> found;
  for (std::size_t i = 0; i < piece.size(); i += 7) {
    Pose pose;
    pose.position << piece[i], 0.0;
    const Location location = map.locate(pose, mode);
    if (location.status != LocationStatus::undecided) found.insert(location.aspect);
  }
  return found.size() == 1 ? *found.begin() : 0;
}

// Of eight working modes.
const std::size_t flooded_modes = test::is_sanitized ? 2 : 8, aspects_in_them = test::is_sanitized ? 8 : 27;

// The robot and the slice of Caro, Chablat, Goldsztejn, Ishii and Jermann, Artificial Intelligence 211, 2014.
TEST(MapOfSlice, ThreeRrrWithFrozenOrientationAgreesWithFloodFill) {
  const Robot robot = test::three_rrr();
  const double smallest = 0.5;  // [m^2], which a grid of 0.05 m shows well
  MapOptions options = options_of(slice_of(robot, {{"phi", 0.0}}), 0.2);
  options.extra_levels = 12;
  options.modes = working_modes(*robot);
  options.modes.resize(flooded_modes);
  const auto map = map_of(robot, options);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->proved_count(), aspects_in_them);
  EXPECT_EQ(map->aspects().size(), aspects_in_them);
  std::map<int, double> areas;
  std::size_t large_pieces = 0;
  for (const WorkingMode& mode : options.modes)
    for (const int sign : {1, -1})
      for (const auto& piece : SliceFlood(*robot, mode, sign).pieces()) {
        const double area = static_cast<double>(piece.size()) * SliceFlood::area_of_cell();
        if (area < smallest) continue;
        ++large_pieces;
        const int aspect = the_one_aspect_of(*map, mode, piece);
        ASSERT_NE(aspect, 0) << to_string(mode) << ", sign " << sign << ", area " << area;
        areas[aspect] += area;
      }
  std::size_t large_aspects = 0;
  for (const Aspect& aspect : map->aspects()) {
    if (aspect.measure_lower < smallest) continue;
    ++large_aspects;
    EXPECT_GT(areas[aspect.id], aspect.measure_lower * 0.995 - 0.2) << aspect.id;
    EXPECT_LT(areas[aspect.id], aspect.measure_upper * 1.005 + 0.2) << aspect.id;
  }
  // One aspect has a neck that is thinner than a cell.
  EXPECT_EQ(areas.size(), large_aspects);
  EXPECT_LE(large_pieces, large_aspects + 1);
}

TEST(MapOfSlice, ModesCanBeLeftOut) {
  const Robot robot = test::three_rrr();
  const WorkingMode mode = WorkingMode::from_index(3, 5);
  const MapSlice slice = slice_of(robot, {{"phi", 0.0}});
  const auto all = map_of(robot, options_of(slice, 0.5)), one = map_of(robot, options_of(slice, 0.5, {mode}));
  ASSERT_EQ(one->working_modes(), std::vector<WorkingMode>{mode});
  const auto of_mode = std::count_if(all->aspects().begin(), all->aspects().end(),
                                     [&mode](const Aspect& aspect) { return aspect.mode == mode; });
  EXPECT_EQ(static_cast<std::ptrdiff_t>(one->aspects().size()), of_mode);
  EXPECT_EQ(one->locate(Pose{}, WorkingMode(3)).status, LocationStatus::not_mapped);
}

TEST(MapOfSlice, TurnsAboutEveryAxis) {
  const Robot robot = test::shipped("stewart")->manipulator();
  MapSlice slice;
  slice.held.position << 0.0, 0.0, 1.3;
  slice.held.orientation = Eigen::AngleAxisd(0.2, Eigen::Vector3d(0.6, 0.8, 0.0));
  slice.axis << 1.0, 2.0, 2.0;
  slice.rotation = MapSlice::Rotation::about_axis;
  const auto map = map_of(robot, options_of(slice, 0.01));
  ASSERT_TRUE(map);
  const Eigen::Quaterniond third(Eigen::AngleAxisd(0.3, slice.axis.normalized()));
  const Pose pose = map->contents().tree.space().pose({0, {0.3 / static_cast<double>(EIGEN_PI), 0.0, 0.0}});
  EXPECT_LT(pose.orientation.angularDistance(third * slice.held.orientation), 1e-12);
  std::mt19937_64 random(11);
  for (int i = 0; i < 2000; ++i) {
    const Pose at = map->contents().tree.space().pose({0, {uniform(random, -1.0, 1.0), 0.0, 0.0}});
    const Location location = map->locate(at, WorkingMode(6));
    const auto sign = test::sign_at(*robot, at, WorkingMode(6));
    if (!sign || location.status == LocationStatus::undecided) continue;
    ASSERT_EQ(location.status == LocationStatus::inside, *sign != 0) << to_string(TaskSpace::SE3, at);
  }
}

}  // namespace
}  // namespace parallel_aspects
