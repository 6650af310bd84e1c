// SPDX-License-Identifier: BSD-3-Clause
// Where the display says that the nearest singularity is, against what it draws of the map and against what
// makes a pose singular.
#include "rviz/display/nearest_singularity.h"

#include "draw/plane/palette.h"
#include "draw/scene/surface_picture.h"
#include "draw/scene/workspace_bodies.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <random>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

double distance_to_segment(const Vector3d& point, const Vector3d& a, const Vector3d& b) {
  const double length = std::max(1e-12, (b - a).squaredNorm());
  return (a + std::clamp((point - a).dot(b - a) / length, 0.0, 1.0) * (b - a) - point).norm();
}

// From a point to lines of a colour, all in the plane.
double distance_to_lines(const SurfacePicture& picture, Rgb color, Vector3d point) {
  double nearest = 1e9;
  point.z() = 0.0;
  for (const ColoredLines& lines : picture.moving.lines)
    for (std::size_t i = 0; lines.color == color && i + 1 < lines.ends.size(); i += 2) {
      Vector3d a = lines.ends[i].cast<double>(), b = lines.ends[i + 1].cast<double>();
      a.z() = b.z() = 0.0;
      nearest = std::min(nearest, distance_to_segment(point, a, b));
    }
  return nearest;
}

// A pose near the deepest of an aspect, which lies in it.
Pose near_deepest(const Aspect& aspect, std::mt19937& random) {
  std::uniform_real_distribution<double> share(-0.6, 0.6);
  Pose pose = aspect.deepest;
  pose.position.x() += share(random) * aspect.deepest_clearance;
  pose.position.y() += share(random) * aspect.deepest_clearance;
  return pose;
}

// By a map that is traced, and not by the search for the distance.
TEST(NearestSingularity, EndsOnTheNearestLineOfThePlane) {
  MapOptions options;
  const test::Robot robot = test::shipped("five_bar")->mapped_manipulator();
  options.resolution = 0.01 * robot->size();
  SurfaceStore store(test::map_of(robot, options));
  BoundaryDistanceMeter meter(robot);
  std::mt19937 random(16);
  for (const Aspect& aspect : store.map().aspects()) {
    PictureChoice choice;
    choice.modes = {aspect.mode};
    const SurfacePicture picture = draw_surfaces(store, choice, std::nullopt, std::atomic<bool>{false});
    for (int i = 0; i < 20; ++i) {
      const Pose pose = near_deepest(aspect, random);
      const auto nearest = nearest_singularity(*robot, pose, meter.measure(pose, aspect.mode), 1.0);
      ASSERT_TRUE(nearest) << aspect.id << " at " << pose.position.transpose();
      ASSERT_EQ(nearest->ends.size(), 1U);
      const double grid = 0.01 * robot->size();
      EXPECT_LT(distance_to_lines(picture, boundary_color(nearest->kind), nearest->ends.front()), grid);
      EXPECT_NEAR((nearest->ends.front() - pose.position).norm(), nearest->distance, 1e-9);
      for (const BoundaryKind kind : {BoundaryKind::parallel, BoundaryKind::serial})
        EXPECT_GT(distance_to_lines(picture, boundary_color(kind), pose.position), nearest->distance - grid)
            << aspect.id << " at " << pose.position.transpose();
    }
  }
}

// From each pose to any other, as a map of the ball or of turns has it.
TEST(NearestSingularity, TheWayIsInShortPiecesFromThePoseToItsEnd) {
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  for (const char* const name : {"three_rrr", "linear_delta", "spherical_3rrr", "stewart"}) {
    const test::Robot robot = test::shipped(name)->manipulator();
    const TaskSpace space = robot->task_space();
    const double radian = 0.3 * robot->size();
    for (int i = 0; i < 200; ++i) {
      BoundaryDistances distances;
      Pose pose;
      for (Pose* const each : {&pose, &distances.parallel.witness}) {
        Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
        if (space == TaskSpace::SE2) q = Eigen::Quaterniond(q.w(), 0.0, 0.0, q.z());
        if (space == TaskSpace::T3) q.setIdentity();
        each->orientation = q.normalized();
        if (space != TaskSpace::SO3)
          each->position << normal(random), normal(random), is_planar(space) ? 0.0 : normal(random);
      }
      distances.parallel.upper = 1.0;
      const auto nearest = nearest_singularity(*robot, pose, distances, radian);
      ASSERT_TRUE(nearest);
      const std::size_t ways = space == TaskSpace::SE3 ? 6 : 1;
      ASSERT_EQ(nearest->ends.size(), ways) << name;
      // At an angle of pi one piece at most goes across, and is left out.
      EXPECT_GE(nearest->way.size(), 2 * 23 * ways) << name;
      if (ways > 1) continue;
      const Vector3d from = drawn_point(*robot, pose, radian);
      if (nearest->way.size() == 2 * 24) {
        EXPECT_LT((nearest->way.front() - from).norm(), 1e-9);
      }
      EXPECT_LT((nearest->ends.front() - drawn_point(*robot, distances.parallel.witness, radian)).norm(),
                1e-9);
      for (std::size_t k = 0; k + 1 < nearest->way.size(); k += 2)
        EXPECT_LT((nearest->way[k + 1] - nearest->way[k]).norm(), EIGEN_PI * radian) << name;
    }
  }
}

TEST(NearestSingularity, NoneIsDrawnWhereNoneIsKnown) {
  const test::Robot robot = test::shipped("five_bar")->manipulator();
  EXPECT_FALSE(nearest_singularity(*robot, {}, {}, 1.0));
  BoundaryDistances distances;
  distances.serial.upper = 0.25;
  const auto nearest = nearest_singularity(*robot, {}, distances, 1.0);
  ASSERT_TRUE(nearest);
  EXPECT_EQ(words_of(*nearest, {}), "nearest singularity found: serial, 0.25 m");
  EXPECT_EQ(words_of(*nearest, DistanceUnit::of_angles()), "nearest singularity found: serial, 0.251 rad");
}

}  // namespace
}  // namespace parallel_aspects
