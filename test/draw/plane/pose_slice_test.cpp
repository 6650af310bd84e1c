// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/map_pictures.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/shipped.h"
#include <cmath>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

TEST(PoseSlice, ThroughAPoseHoldsThatPose) {
  test::RandomRobots random(11);
  for (const TaskSpace space : {TaskSpace::T2, TaskSpace::SE2, TaskSpace::T3, TaskSpace::SO3})
    for (int i = 0; i < 200; ++i) {
      const Pose pose = random.pose(space);
      const PoseSlice slice = PoseSlice::through(space, pose);
      const Vector2d point = PoseSlice::point(space, pose);
      EXPECT_TRUE(slice.holds(point));
      const Pose again = slice.pose(point);
      EXPECT_LT((again.position - pose.position).norm(), 1e-12) << to_string(space, pose);
      EXPECT_LT(again.orientation.angularDistance(pose.orientation), 1e-6) << to_string(space, pose);
    }
}

TEST(PoseSlice, TiltPointsThePlatformAxisThatWay) {
  const Vector2d point(0.3, -0.4);
  const Pose pose = PoseSlice(TaskSpace::SO3, 1.1).pose(point);
  const Eigen::Vector3d axis = pose.orientation * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(axis.z(), std::cos(0.5), 1e-12);
  EXPECT_NEAR(std::atan2(axis.y(), axis.x()), std::atan2(-0.4, 0.3), 1e-12);
}

// What is held is held, what is free is the point; seen through by a map that was made of that slice alone.
TEST(PoseSlice, OfAMapSliceHasItsPoses) {
  const auto robot = test::shipped("three_prr")->mapped_manipulator();
  Problems problems;
  const MapSlice turned = make_slice(*robot, {{"x", 0.3}}, problems);
  ASSERT_TRUE(problems.empty());
  const PoseSlice slice(*robot, turned);
  const Pose pose = slice.pose({-0.2, 1.1});
  EXPECT_NEAR((pose.position - Eigen::Vector3d(0.3, -0.2, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(2.0 * std::atan2(pose.orientation.z(), pose.orientation.w()), 1.1, 1e-12);
  EXPECT_TRUE(slice.holds({5.0, 3.14}));
  EXPECT_FALSE(slice.holds({0.0, 3.2})) << "beyond half a turn";
  EXPECT_EQ(slice.text(), to_string(turned));
}

TEST(PoseSlice, OfAMapSliceIsWhereItsMapIs) {
  const auto robot = test::shipped("three_rpr")->mapped_manipulator();
  for (const HeldCoordinate& held :
       {HeldCoordinate{"phi", 0.4}, HeldCoordinate{robot->leg(0).actuated_joint, 14.98}}) {
    Problems problems;
    MapOptions options;
    options.slice = make_slice(*robot, {held}, problems);
    ASSERT_TRUE(problems.empty()) << problems.front();
    const auto map = compute_aspect_map(robot, options).map;
    ASSERT_TRUE(map) << held.name;
    const PoseSlice slice(*robot, *options.slice);
    for (const Aspect& aspect : map->aspects())
      map->visit_inside_leaves(aspect.id, [&](const Box& box) {
        EXPECT_EQ(map->locate(slice.pose({box.center(0), box.center(1)}), aspect.mode).aspect, aspect.id);
      });
    const Eigen::AlignedBox2d bounds = slice_bounds(*map, *options.slice);
    for (const Aspect& aspect : map->aspects())
      EXPECT_TRUE(bounds.contains(Vector2d(aspect.bounds.lower[0], aspect.bounds.upper[1])));
  }
}

double area_of(const std::vector<Vector2d>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

// Whatever is filled lies, by its own inverse and determinant, in the mode and sign of the aspect that it is
// filled for; and all slices together have the volume of the aspects.
TEST(PoseSlice, SlicesOfAMapAddUpToItsAspects) {
  const auto mechanism = test::shipped("three_prr");
  const Manipulator& robot = *mechanism->manipulator();
  MapOptions options;
  options.resolution = 0.1;
  const auto map = compute_aspect_map(mechanism->manipulator(), options).map;
  ASSERT_TRUE(map);
  const Eigen::AlignedBox2d bounds = slice_bounds(*map);
  std::vector<double> volumes(map->aspects().size(), 0.0);
  constexpr int levels = 60;
  const double step = 2.0 * EIGEN_PI / levels;
  for (int i = 0; i < levels; ++i) {
    const PoseSlice slice(TaskSpace::SE2, -EIGEN_PI + (i + 0.5) * step);
    for (const WorkingMode& mode : map->working_modes())
      for (const BoundarySliver& sliver : trace_slice(*map, mode, slice, bounds, 40).slivers) {
        const Aspect& aspect = map->aspects()[static_cast<std::size_t>(sliver.aspect - 1)];
        ASSERT_EQ(aspect.mode, mode);
        volumes[static_cast<std::size_t>(sliver.aspect - 1)] += step * area_of(sliver.corners);
        Vector2d middle = Vector2d::Zero();
        for (const Vector2d& corner : sliver.corners)
          middle += corner / static_cast<double>(sliver.corners.size());
        const Pose pose = slice.pose(middle);
        const InverseSolution solution = inverse(robot, pose, mode);
        ASSERT_EQ(solution.status, InverseStatus::solved);
        ASSERT_GT(aspect.determinant_sign * direct_determinant(robot, pose, solution.q), 0.0);
      }
  }
  for (const Aspect& aspect : map->aspects()) {
    const double volume = volumes[static_cast<std::size_t>(aspect.id - 1)];
    EXPECT_GE(volume, 0.95 * aspect.measure_lower) << aspect.id;
    EXPECT_LE(volume, 1.05 * aspect.measure_upper) << aspect.id;
  }
}

}  // namespace
}  // namespace parallel_aspects
