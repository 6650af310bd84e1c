// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "draw/plane/map_pictures.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"

#include <gtest/gtest.h>

#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include "support/robots/scaled_robot.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// What is found of a robot does not depend on the unit that its lengths are given in.

namespace parallel_aspects {
namespace {

using test::Robot;

// With powers of two every number is the same but for its exponent; with others the grids differ by a ten
// millionth.
constexpr double exact_factors[] = {1024.0, 1.0 / 1024.0}, factors[] = {1000.0, 1e-3};

std::shared_ptr<const AspectMap> map_of(const Robot& robot, double factor, std::optional<double> resolution) {
  MapOptions options;
  if (resolution) options.resolution = *resolution * factor;
  const MapResult result = compute_aspect_map(test::scaled(*robot, factor), options);
  EXPECT_TRUE(result.map) << result.message;
  return result.map;
}

/// A five-bar among obstacles, with aspects so small that a grid may miss them.
Robot among_obstacles() {
  Constraints constraints;
  constraints.thickness = {0.254, 0.036, {}};
  constraints.self_collision.emplace();
  constraints.obstacles.push_back({"post", BallObstacle{{0.325, -0.464, 0.0}, 0.325}});
  constraints.obstacles.push_back({"pole", BallObstacle{{9.049, 0.543, 0.0}, 0.343}});
  constraints.obstacles.push_back({"pin", BallObstacle{{8.235, 0.246, 0.0}, 0.376}});
  return test::with(test::five_bar(), constraints);
}

struct RobotInUnits {
  const char* name;
  Robot robot;
  std::optional<double> resolution;  // [m]; by default that of the robot
};

std::vector<RobotInUnits> cases() {
  std::vector<RobotInUnits> result{{"five_bar", test::five_bar(), 0.2},
                                   {"bipod", test::bipod(), 0.1},
                                   {"three_prr", test::shipped("three_prr")->manipulator(), std::nullopt},
                                   {"delta", test::shipped("delta")->manipulator(), 0.4}};
  if (!test::is_sanitized) result.push_back({"obstacles", among_obstacles(), std::nullopt});
  return result;
}

void expect_the_same_but_for_exponents(const AspectMap& scaled, const AspectMap& map, double factor) {
  EXPECT_EQ(scaled.contents().tree.node_count(), map.contents().tree.node_count());
  EXPECT_EQ(scaled.unresolved(), map.unresolved());
  EXPECT_EQ(scaled.indeterminate_leaves(), map.indeterminate_leaves());
  ASSERT_EQ(scaled.aspects().size(), map.aspects().size());
  const double unit = std::pow(factor, static_cast<double>(directions(map.manipulator()->task_space())));
  for (std::size_t i = 0; i < map.aspects().size(); ++i) {
    EXPECT_EQ(scaled.aspects()[i].inside_leaves, map.aspects()[i].inside_leaves);
    EXPECT_EQ(scaled.aspects()[i].measure_lower, unit * map.aspects()[i].measure_lower);
  }
}

TEST(UnitOfLength, DoesNotChangeMaps) {
  for (const RobotInUnits& each : cases()) {
    const auto map = map_of(each.robot, 1.0, each.resolution);
    const auto expect_alike = [&](double factor, bool exactly) {
      SCOPED_TRACE(each.name + (" times " + std::to_string(factor)));
      const auto scaled = map_of(each.robot, factor, each.resolution);
      EXPECT_EQ(scaled->proved_count(), map->proved_count());
      EXPECT_EQ(scaled->working_modes().size(), map->working_modes().size());
      EXPECT_EQ(scaled->contents().depth, map->contents().depth);
      if (exactly) expect_the_same_but_for_exponents(*scaled, *map, factor);
    };
    for (const double factor : factors) expect_alike(factor, false);
    for (const double factor : exact_factors)
      if (!test::is_sanitized) expect_alike(factor, true);
  }
}

TEST(UnitOfLength, DoesNotChangeRoadmaps) {
  RoadmapOptions options;
  options.samples = 100;
  const Robot robot = test::shipped("stewart")->manipulator();
  const RoadmapResult result = compute_pose_roadmap(robot, options);
  for (const double factor : exact_factors) {
    const RoadmapResult scaled = compute_pose_roadmap(test::scaled(*robot, factor), options);
    ASSERT_TRUE(scaled.roadmap) << scaled.message;
    EXPECT_EQ(scaled.roadmap->component_count(), result.roadmap->component_count());
  }
}

double area(const TriangleCorners& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Eigen::Vector2d one = corners[i + 1] - corners[i], other = corners[i + 2] - corners[i];
    sum += 0.5 * (one.x() * other.y() - one.y() * other.x());
  }
  return sum;
}

// The actuated joints of a bipod are lengths.
TEST(UnitOfLength, DoesNotChangePicturesOfJointSpace) {
  std::vector<std::pair<double, double>> areas;
  for (const double factor : {1.0, 1000.0, 1e-3}) {
    const auto map = map_of(test::bipod(), factor, 0.2);
    const Box region = map->region();
    const Eigen::AlignedBox2d bounds(Eigen::Vector2d(region.lower[0], region.lower[1]),
                                     Eigen::Vector2d(region.upper[0], region.upper[1]));
    const WorkingMode mode = map->working_modes().front();
    const BoundaryPicture picture = trace_slice(*map, mode, PoseSlice(TaskSpace::T2, 0.0), bounds, 60);
    const JointProjection projection(map);
    double length = 0.0;
    for (const BoundarySegment& segment : projection.images(picture.segments, mode))
      length += (segment.to - segment.from).norm() / factor;
    areas.emplace_back(area(projection.triangles(1, picture.slivers)) / (factor * factor), length);
  }
  EXPECT_GT(areas[0].first, 1.0);
  EXPECT_GT(areas[0].second, 1.0);
  for (const auto& [surface, length] : areas) {
    EXPECT_NEAR(surface, areas[0].first, 1e-3 * areas[0].first);
    EXPECT_NEAR(length, areas[0].second, 1e-2 * areas[0].second);
  }
}

}  // namespace
}  // namespace parallel_aspects
