// SPDX-License-Identifier: BSD-3-Clause
//
// A planned path as a line, coloured by its index.
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/pictures/answer_pictures.h"
#include "ros/pictures/marker_batch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace parallel_aspects {
namespace {

std_msgs::ColorRGBA color_of_index(double index) { return color(index_color(index)); }

bool is_bluer(const std_msgs::ColorRGBA& a, const std_msgs::ColorRGBA& b) { return a.b - a.r > b.b - b.r; }

TEST(PathPicture, ColoursShowHowNearDetAIsToZero) {
  for (int i = 50; i < 100; ++i)
    EXPECT_TRUE(is_bluer(color_of_index(0.01 * (i + 1)), color_of_index(0.01 * i))) << i;
  EXPECT_TRUE(is_bluer(color_of_index(1.0), color_of_index(0.5)));
  EXPECT_GT(color_of_index(0.0).r, color_of_index(1.0).r);
  EXPECT_EQ(color_of_index(-1.0).r, color_of_index(0.0).r);
  EXPECT_EQ(color_of_index(2.0).b, color_of_index(1.0).b);
}

// In the plane the index is the sine of the angle between the rods.
TEST(PathPicture, HasTheColourOfEachPoint) {
  const auto mechanism = test::five_bar_mechanism();
  const Manipulator& robot = *mechanism->manipulator();
  const WorkingMode mode = *WorkingMode::from_signs({1, -1});
  PlannedPath path;
  path.answer = SameAspect::yes;
  for (const double y : {8.0, 4.0}) path.points.push_back({test::pose_at(4.5, y), mode, {}});
  const auto markers = path_markers(robot, path, between_poses(TaskSpace::SE3), 1.0).markers;
  ASSERT_EQ(markers.size(), 3U);  // delete, line, ends
  const auto& line = markers[1];
  ASSERT_EQ(line.colors.size(), line.points.size());
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Pose pose = test::pose_at(line.points[i].x, line.points[i].y);
    const JointVector q = inverse(robot, pose, mode).q;
    Eigen::Vector2d rods[2];
    for (std::size_t j = 0; j < 2; ++j) {
      const Eigen::Vector3d elbow = robot.leg(j).proximal_point(q[static_cast<Eigen::Index>(j)]);
      rods[j] = (pose.position - elbow).head<2>().normalized();
    }
    const double index = std::abs(rods[0].x() * rods[1].y() - rods[0].y() * rods[1].x());
    EXPECT_NEAR(line.colors[i].r, color_of_index(index).r, 1e-6) << i;
    EXPECT_NEAR(line.colors[i].b, color_of_index(index).b, 1e-6) << i;
  }
}

}  // namespace
}  // namespace parallel_aspects
