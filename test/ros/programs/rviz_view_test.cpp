// SPDX-License-Identifier: BSD-3-Clause
#include "ros/programs/rviz_view.h"

#include "parallel_aspects/kinematics/inverse.h"
#include "ros/pictures/scene.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/robots/shipped.h"
#include <algorithm>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

YAML::Node view_of(const std::string& robot) {
  const NodeSetup setup{SharedMechanism(test::shipped(robot)), NodeOptions()};
  return YAML::Load(with_view_of(test::source_file("rviz/surfaces.rviz"), setup));
}

// Where random poses about the assembled one are that some working mode reaches, half of them with its
// orientation.
AlignedBox2d sampled_reach(const Mechanism& mechanism) {
  const Manipulator& robot = *mechanism.manipulator();
  const Pose home = mechanism.assembled().pose;
  std::mt19937 random(1);
  const double size = 2.0 * robot.size();
  std::uniform_real_distribution<double> length(-size, size), angle(-EIGEN_PI, EIGEN_PI);
  AlignedBox2d reach;
  for (int i = 0; i < 20000; ++i) {
    Pose pose = home;
    pose.position.head<2>() += Vector2d(length(random), length(random));
    if (robot.task_space() == TaskSpace::SE2 && i % 2 == 0)
      pose.orientation = Pose::planar(0.0, 0.0, angle(random)).orientation;
    const auto solutions = inverse_in_all_modes(robot, pose);
    if (std::any_of(solutions.begin(), solutions.end(), [](const auto& each) { return bool(each); }))
      reach.extend(pose.position.head<2>());
  }
  return reach;
}

class PlanarView : public testing::TestWithParam<const char*> {};

// From above, beside the panel in a window of 1280 by 800.
TEST_P(PlanarView, IsFilledByWhatTheRobotReaches) {
  const auto mechanism = test::shipped(GetParam());
  const YAML::Node view = view_of(GetParam())["Visualization Manager"]["Views"]["Current"];
  ASSERT_EQ(view["Class"].as<std::string>(), "rviz/TopDownOrtho");
  const Vector2d half = Vector2d(1280.0 - 420.0, 800.0 - 95.0) / (2.0 * view["Scale"].as<double>()),
                 middle(view["X"].as<double>(), view["Y"].as<double>());
  const AlignedBox2d seen(Vector2d(middle - half), Vector2d(middle + half)),
      reach = sampled_reach(*mechanism);
  ASSERT_FALSE(reach.isEmpty());
  EXPECT_TRUE(seen.contains(reach)) << seen.min().transpose() << " to " << seen.max().transpose()
                                    << ", reach " << reach.min().transpose() << " to "
                                    << reach.max().transpose();
  EXPECT_GT(reach.sizes().cwiseQuotient(seen.sizes()).maxCoeff(), 0.35) << "the base takes room, too";
}

// Not the 3-PRR: its base and platform are many times larger than what it reaches.
INSTANTIATE_TEST_SUITE_P(ShippedRobots, PlanarView, testing::Values("five_bar", "three_rpr", "three_rrr"),
                         [](const auto& robot) { return std::string(robot.param); });

}  // namespace
}  // namespace parallel_aspects
