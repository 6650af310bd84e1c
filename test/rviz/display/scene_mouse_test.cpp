// SPDX-License-Identifier: BSD-3-Clause
//
// The display in the scene of rviz, beside two running nodes, used by a mouse that X moves. What is checked
// are the messages that go out and what the display says.
#include "rviz/display/scene.h"
#include "rviz/panel/screen.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/ListAspects.h>

#include <ros/this_node.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "rviz/standing_robot.h"
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <std_msgs/UInt32.h>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;
using test::Recorder;
using test::Scene;

const Vector3d beside(20.0, 0.0, 0.0);  // the Delta, from the five-bar

Pose start_of_delta() {
  Pose pose;
  pose.position << 0.0, 0.0, 0.15;
  return pose;
}

/// One robot that stands still, and its display in the scene.
class Shown {
 public:
  Shown(Scene& scene, const std::string& space, const std::string& robot, const Pose& pose,
        const std::vector<int>& signs)
      : node_(space + "/aspect_node"),
        mechanism_(test::shipped(robot)),
        robot_(space, *mechanism_->manipulator(), pose, signs),
        states_(node_ + "/state"),
        selected_(node_ + "/selected_aspect"),
        display_(*scene.manager().createDisplay("parallel_aspects/Aspects", "Aspects", true)) {
    display_.subProp("Node")->setValue(QString::fromStdString(node_));
    EXPECT_TRUE(Scene::until([this] {
      return states_.last() && states_.last()->aspect > 0 &&
             says("Robot", "aspect " + std::to_string(states_.last()->aspect)) && says("Map", "triangles");
    })) << Scene::status(display_, "Robot")
        << Scene::status(display_, "Map");
  }

  bool says(const char* line, const std::string& words) const {
    return Scene::status(display_, line).find(words) != std::string::npos;
  }
  double number(const char* section_property) const {
    return display_.subProp("Section")->subProp(section_property)->getValue().toDouble();
  }
  unsigned present() const { return states_.last()->aspect; }
  rviz::Display& display() const { return display_; }
  const Recorder<std_msgs::UInt32>& selected() const { return selected_; }
  std::vector<AspectSummary> aspects() const {
    return test::call<ListAspects>(node_ + "/list_aspects", {}).aspects;
  }

 private:
  const std::string node_;
  const std::shared_ptr<const Mechanism> mechanism_;
  const test::StandingRobot robot_;
  const Recorder<AspectState> states_;
  const Recorder<std_msgs::UInt32> selected_;
  rviz::Display& display_;
};

class SceneMouse : public testing::Test {
 protected:
  // There is one scene a process.
  static void SetUpTestSuite() {
    scene_ = std::make_unique<Scene>(900, 700);
    scene_->manager().setFixedFrame("map");
    broadcaster_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>();
    broadcaster_->sendTransform(
        {frame_at("base_link", Vector3d::Zero()), frame_at("deep/base_link", beside)});
    flat_ = std::make_unique<Shown>(*scene_, "/flat", "five_bar", test::pose_at(4.5, 8.0),
                                    std::vector<int>{1, -1});
    deep_ = std::make_unique<Shown>(*scene_, "/deep", "linear_delta", start_of_delta(),
                                    std::vector<int>{1, 1, 1});
  }
  static void TearDownTestSuite() {
    flat_.reset();
    deep_.reset();
    scene_.reset();
    broadcaster_.reset();
  }
  void TearDown() override { deep_->display().subProp("Section")->setValue("At the robot"); }

  static geometry_msgs::TransformStamped frame_at(const std::string& name, const Vector3d& place) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.header.stamp = ros::Time::now();
    transform.child_frame_id = name;
    transform.transform.translation.x = place.x();
    transform.transform.rotation.w = 1.0;
    return transform;
  }

  // From above, so many pixels a metre.
  static void look_down(const Vector3d& at, double scale) {
    rviz::ViewController& view = scene_->view("rviz/TopDownOrtho");
    view.subProp("X")->setValue(at.x());
    view.subProp("Y")->setValue(at.y());
    view.subProp("Scale")->setValue(scale);
    scene_->draw(3);
  }
  static rviz::ViewController& look_at_delta() {
    rviz::ViewController& view = scene_->view("rviz/Orbit");
    view.subProp("Focal Point")->subProp("X")->setValue(beside.x());
    view.subProp("Distance")->setValue(2.0);
    view.subProp("Pitch")->setValue(0.5);
    view.subProp("Yaw")->setValue(0.7);
    scene_->draw(3);
    return view;
  }

  static inline std::unique_ptr<Scene> scene_;
  static inline std::unique_ptr<tf2_ros::StaticTransformBroadcaster> broadcaster_;
  static inline std::unique_ptr<Shown> flat_, deep_;
};

TEST_F(SceneMouse, AClickOnAnAspectSelectsIt) {
  look_down({4.5, 2.0, 0.0}, 20.0);
  const std::size_t others = deep_->selected().all().size();
  std::size_t clicks = 0;
  for (const AspectSummary& aspect : flat_->aspects()) {
    if (aspect.working_mode != std::vector<std::int8_t>{1, -1}) continue;
    const auto& place = aspect.deepest_pose.position;
    scene_->click(scene_->pixel({place.x + 0.2, place.y - 0.1, 0.0}));
    ++clicks;
    EXPECT_TRUE(Scene::until([&] { return flat_->selected().all().size() == clicks; })) << aspect.id;
    ASSERT_TRUE(flat_->selected().last());
    EXPECT_EQ(flat_->selected().last()->data, aspect.id);
    EXPECT_TRUE(flat_->says("Selected", "Aspect " + std::to_string(aspect.id) + ", (+,-), det A"))
        << aspect.id;
  }
  EXPECT_EQ(clicks, 3U);
  scene_->click(scene_->pixel({-30.0, 2.0, 0.0}));  // beside them all
  EXPECT_EQ(flat_->selected().all().size(), clicks);
  EXPECT_EQ(deep_->selected().all().size(), others);
}

TEST_F(SceneMouse, AFaceOfTheSectionIsDraggedAsFarAsTheMouse) {
  look_at_delta();
  const std::size_t before = deep_->selected().all().size();
  const Vector3d held = beside + Vector3d(0.05, 0.05, 0.15);
  scene_->drag(scene_->pixel(held), scene_->pixel(held - Vector3d(0.0, 0.0, 0.2)), 15);
  EXPECT_EQ(deep_->display().subProp("Section")->getValue().toString(), "At offset");
  EXPECT_NEAR(deep_->number("Offset"), -0.05, 0.03);
  EXPECT_EQ(deep_->selected().all().size(), before) << "a drag is no click";
  // Where it was left it is held, and a click there selects.
  EXPECT_TRUE(Scene::until([&] {
    scene_->click(scene_->pixel(beside + Vector3d(0.05, 0.05, deep_->number("Offset"))));
    return deep_->selected().all().size() > before;
  }));
  EXPECT_EQ(deep_->selected().last()->data, deep_->present());
}

TEST_F(SceneMouse, BesideAFaceTheViewIsTurned) {
  rviz::ViewController& view = look_at_delta();
  deep_->display().subProp("Section")->setValue("None");
  const std::size_t before = deep_->selected().all().size();
  const double yaw = view.subProp("Yaw")->getValue().toDouble();
  const QPoint middle = scene_->pixel(beside + Vector3d(0.05, 0.05, 0.15));
  EXPECT_TRUE(Scene::until([&] {
    scene_->drag(middle, middle + QPoint(60, 0), 6);
    return std::abs(view.subProp("Yaw")->getValue().toDouble() - yaw) > 0.1;
  }));
  EXPECT_EQ(deep_->display().subProp("Section")->getValue().toString(), "None");
  EXPECT_EQ(deep_->selected().all().size(), before);
}

TEST_F(SceneMouse, WhatIsSwitchedOffListensToNothing) {
  const auto listened = [] {
    ros::V_string topics;
    ros::this_node::getSubscribedTopics(topics);
    return std::count(topics.begin(), topics.end(), "/deep/aspect_node/map_progress");
  };
  EXPECT_EQ(listened(), 1);
  deep_->display().setEnabled(false);
  EXPECT_EQ(listened(), 0);
  EXPECT_EQ(Scene::status(deep_->display(), "Selected"), "");
  deep_->display().setEnabled(true);
  EXPECT_TRUE(Scene::until([this] { return deep_->says("Map", "triangles"); }));
}

// Which tells nobody that it ends.
TEST_F(SceneMouse, ANodeThatIsKilledIsMissedAndFollowedAgain) {
  const std::string node = "/killed/aspect_node";
  ros::param::set("/killed/robot_description", test::source_file("urdf/five_bar.urdf"));
  ros::param::set(node + "/mechanism", test::five_bar_mechanism_parameter());
  ros::param::set(node + "/start/pose", std::vector<double>{4.5, 8.0});
  ros::param::set(node + "/joint_states_timeout", 5.0);
  ros::param::set(node + "/tracking/longest_interval", 5.0);
  auto process = std::make_unique<test::Process>(PARALLEL_ASPECTS_NODE, "/killed");
  Shown shown(*scene_, "/killed", "five_bar", test::pose_at(4.5, 8.0), {1, -1});
  process->signal(SIGKILL);
  EXPECT_TRUE(Scene::until([&] { return shown.says("Node", "Waits for " + node); }));
  EXPECT_TRUE(Scene::until([&] { return shown.says("Robot", "No state of it"); }));
  process = std::make_unique<test::Process>(PARALLEL_ASPECTS_NODE, "/killed");
  EXPECT_TRUE(Scene::until([&] {
    return shown.says("Robot", "In aspect " + std::to_string(shown.present()));
  })) << Scene::status(shown.display(), "Robot");
  EXPECT_TRUE(flat_->says("Robot", "In aspect")) << "another node is none of it";
  delete &shown.display();
}

// Whatever the thread of a picture does just then.
TEST_F(SceneMouse, ClosesAtAnyTime) {
  for (int i = 0; i < 20; ++i) {
    rviz::Display* const display = scene_->manager().createDisplay("parallel_aspects/Aspects", "More", true);
    display->subProp("Node")->setValue("/deep/aspect_node");
    display->subProp("Gallery")->setValue(i % 2 == 0);
    for (int j = 0; j < i; ++j) scene_->draw(1);
    delete display;
    scene_->draw(1);
  }
  EXPECT_TRUE(deep_->says("Map", "triangles"));
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const parallel_aspects::test::Screen screen;
  if (!screen.is_there()) {
    std::fputs("Xvfb cannot be started.\n", stderr);
    return EXIT_FAILURE;
  }
  QApplication application(argc, argv);
  ros::init(argc, argv, "scene_mouse_test");
  const ros::NodeHandle nh;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
