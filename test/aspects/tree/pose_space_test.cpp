// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/pose_space.h"

#include <gtest/gtest.h>

#include <random>

namespace parallel_aspects {
namespace {

// Glued faces are the same poses: a point of the first face and its image on the second.
TEST(PoseSpace, GluedFacesHoldTheSamePoses) {
  const Box square{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const TaskSpace task_space : {TaskSpace::SE2, TaskSpace::SO3}) {
    const auto space = make_pose_space(task_space, square, 1.0);
    EXPECT_EQ(space->gluings().size(), task_space == TaskSpace::SE2 ? 1U : 12U);
    for (const Gluing& gluing : space->gluings()) {
      for (int i = 0; i < 20; ++i) {
        MapPosition first{gluing.first.root, {}}, second{gluing.second.root, {}};
        for (std::size_t k = 0; k < 3; ++k) first.point[k] = coordinate(random);
        first.point[gluing.first.axis] = gluing.first.upper ? 1.0 : -1.0;
        second.point[gluing.second.axis] = gluing.second.upper ? 1.0 : -1.0;
        for (std::size_t k = 0; k < 3; ++k)
          if (k != gluing.first.axis)
            second.point[gluing.axis_of[k]] = gluing.flipped[k] ? -first.point[k] : first.point[k];
        const Pose a = space->pose(first), b = space->pose(second);
        EXPECT_LT((a.position - b.position).norm(), 1e-12);
        EXPECT_LT(a.orientation.angularDistance(b.orientation), 1e-7);
      }
    }
  }
}

// Inside the root box of the other side, and as close to the pose on the face as the depth says.
TEST(PoseSpace, PositionsBeyondAGluedFaceAreCloseToIt) {
  const Box square{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const TaskSpace task_space : {TaskSpace::SE2, TaskSpace::SO3}) {
    const auto space = make_pose_space(task_space, square, 1.0);
    for (int i = 0; i < 200; ++i) {
      MapPosition face{static_cast<RootIndex>(random() % space->root_count()), {}};
      for (double& each : face.point) each = coordinate(random);
      const std::size_t axis = task_space == TaskSpace::SE2 ? 2 : random() % 3;
      face.point[axis] = random() % 2 == 0 ? 1.0 : -1.0;
      const auto beyond = space->beyond(face, axis, 0.01);
      ASSERT_TRUE(beyond);
      EXPECT_TRUE(space->region().contains(beyond->point));
      const double angle = space->pose(face).orientation.angularDistance(space->pose(*beyond).orientation);
      EXPECT_GT(angle, 1e-3);
      EXPECT_LT(angle, 0.05);
      MapPosition inside = face;
      inside.point[axis] *= 0.99;
      EXPECT_GT(space->pose(inside).orientation.angularDistance(space->pose(*beyond).orientation),
                1.2 * angle);
    }
    EXPECT_FALSE(make_pose_space(TaskSpace::T2, square, 1.0)->beyond({0, {1.0, 0.0, 0.0}}, 0, 0.01));
  }
}

}  // namespace
}  // namespace parallel_aspects
