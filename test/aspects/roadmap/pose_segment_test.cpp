// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/pose_segment.h"

#include "interval/path_form.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

TEST(PoseSegment, PlacementsHoldThePosesOfTheSegment) {
  test::RandomRobots random(12);
  for (int i = 0; i < 20000; ++i) {
    const Pose from = random.pose(TaskSpace::SE3), to = random.pose(TaskSpace::SE3);
    const double begin = random.uniform(0.0, 1.0);
    const double end = std::min(1.0, begin + std::pow(10.0, random.uniform(-9.0, 0.0)));
    const double t = std::min(end, begin + random.uniform(0.0, 1.0) * (end - begin));
    const Pose pose = pose_between(from, to, t);
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    const RoundingUpward rounding;
    PoseSegment::Placement placement;
    const double middle = 0.5 * (begin + end);
    if (!PoseSegment(TaskSpace::SE3, from, to).place(PathForm::parameter(begin, middle, end), placement))
      continue;
    for (Eigen::Index row = 0; row < 3; ++row) {
      const auto at = static_cast<std::size_t>(row);
      // `pose_between` rounds: a few units in the last place.
      const auto holds_nearly = [](const Interval& interval, double value) {
        return interval.lower() - 1e-14 <= value && value <= interval.upper() + 1e-14;
      };
      ASSERT_TRUE(holds_nearly(placement.position[at].range, pose.position[row])) << i;
      for (Eigen::Index column = 0; column < 3; ++column)
        ASSERT_TRUE(holds_nearly(placement.rotation[at][static_cast<std::size_t>(column)].range,
                                 rotation(row, column)))
            << i;
    }
  }
}

// The exact ends are in the enclosure of every part that holds them.
TEST(PoseSegment, EndsAreThePosesThemselves) {
  test::RandomRobots random(13);
  for (int i = 0; i < 100; ++i) {
    const Pose from = random.pose(TaskSpace::SE3), to = random.pose(TaskSpace::SE3);
    EXPECT_LT((pose_between(from, to, 0.0).position - from.position).norm(), 1e-15);
    EXPECT_LT((pose_between(from, to, 1.0).position - to.position).norm(), 1e-15);
    EXPECT_LT(pose_between(from, to, 1.0).orientation.angularDistance(to.orientation), 1e-7);
    const RoundingUpward rounding;
    PoseSegment::Placement placement;
    ASSERT_TRUE(PoseSegment(TaskSpace::SE3, from, to).place(PathForm::parameter(1.0, 1.0, 1.0), placement));
    for (std::size_t k = 0; k < 3; ++k) {
      const double end = to.position[static_cast<Eigen::Index>(k)];
      EXPECT_LE(placement.position[k].range.lower(), end);
      EXPECT_GE(placement.position[k].range.upper(), end);
    }
  }
}

}  // namespace
}  // namespace parallel_aspects
