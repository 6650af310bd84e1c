// SPDX-License-Identifier: BSD-3-Clause
#include "ros/programs/rviz_view.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/pictures/robot_visuals.h"
#include "ros/pictures/scene.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/robots/shipped.h"
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

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

// The view of a configuration as a test of what it shows, beside panel, menus and edges.
class Window {
 public:
  Window(const YAML::Node& document, bool has_panel)
      : view_(document["Visualization Manager"]["Views"]["Current"]),
        width_(has_panel ? 860.0 : 1240.0),
        height_(705.0) {}

  bool shows(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d at = pixel(point);
    return std::abs(at.x()) <= 0.5 * width_ && std::abs(at.y()) <= 0.5 * height_;
  }

  // From the middle of the window.
  Eigen::Vector2d pixel(const Eigen::Vector3d& point) const {
    if (view_["Class"].as<std::string>() == "rviz/TopDownOrtho")
      return view_["Scale"].as<double>() *
             Eigen::Vector2d(point.x() - view_["X"].as<double>(), point.y() - view_["Y"].as<double>());
    const double pitch = view_["Pitch"].as<double>(), yaw = view_["Yaw"].as<double>();
    const Eigen::Vector3d back(std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw),
                               std::sin(pitch));
    const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(back).normalized();
    const YAML::Node focus = view_["Focal Point"];
    const Eigen::Vector3d from =
        point - Eigen::Vector3d(focus["X"].as<double>(), focus["Y"].as<double>(), focus["Z"].as<double>());
    const double depth = view_["Distance"].as<double>() - from.dot(back);
    const double scale = 0.5 * height_ / std::tan(0.5 * view_["Field of View"].as<double>()) / depth;
    return scale * Eigen::Vector2d(from.dot(right), from.dot(back.cross(right)));
  }

 private:
  YAML::Node view_;
  double width_, height_;
};

std::vector<Eigen::Vector3d> corners(const Eigen::AlignedBox3d& box) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8 && !box.isEmpty(); ++i)
    points.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  return points;
}

class ViewOf : public testing::TestWithParam<const char*> {
 protected:
  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped(GetParam());
  const Manipulator& robot_ = *mechanism_->manipulator();
  const NodeSetup setup_{SharedMechanism(mechanism_), NodeOptions(),
                         test::source_file(std::string("urdf/") + GetParam() + ".urdf")};

  Window window(const std::string& view) const {
    return {YAML::Load(with_view_of(test::source_file("rviz/" + view + ".rviz"), setup_)),
            view == "surfaces"};
  }
};

// Whatever is offered when the robot was lost. All that SO3 has are in one sphere.
TEST_P(ViewOf, ShowsBaseAndAssemblyModes) {
  std::vector<Eigen::Vector3d> points = corners(RobotVisuals(setup_.mechanism, setup_.urdf, 1.0).still());
  if (robot_.task_space() != TaskSpace::SO3) {
    for (const AssemblyMode& mode : direct(robot_, mechanism_->home().q).solutions)
      for (const Leg& leg : robot_.legs()) points.push_back(mode.pose.transform(leg.anchor));
  }
  for (const std::string view : {"aspects", "surfaces"}) {
    const Window seen = window(view);
    for (const Eigen::Vector3d& point : points)
      EXPECT_TRUE(seen.shows(robot_.task_frame() * point)) << view << ": " << point.transpose();
  }
}

// The longest sentence that says why it was lost; below the base of a planar robot, not over it.
TEST_P(ViewOf, ShowsTheLongestCaption) {
  const Scene scene = scene_of(setup_);
  const double base = RobotVisuals(setup_.mechanism, setup_.urdf, 1.0).still().min().y();
  const Window seen = window("aspects");
  for (const Eigen::Vector3d& corner : caption_corners(scene)) {
    EXPECT_TRUE(seen.shows(robot_.task_frame() * corner)) << corner.transpose();
    EXPECT_TRUE(!scene.planar || corner.y() < base);
  }
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, ViewOf,
                         testing::Values("five_bar", "bipod", "three_rpr", "three_prr", "three_rrr",
                                         "linear_delta", "delta", "stewart", "hexa", "six_pus", "agile_eye",
                                         "spherical_3rrr"),
                         [](const auto& robot) { return std::string(robot.param); });

}  // namespace
}  // namespace parallel_aspects
