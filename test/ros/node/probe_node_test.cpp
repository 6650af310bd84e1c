// SPDX-License-Identifier: BSD-3-Clause
//
// The probe of a node of the five-bar: typed, dragged by the messages that rviz sends, and by its menu;
// against the services, and beside the tracked robot.
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"
#include "ros/probe/probe_handle.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/GetCurrentAspect.h>
#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/MapProgress.h>
#include <parallel_aspects/ProbeState.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <geometry_msgs/PoseStamped.h>
#include <limits>
#include <std_msgs/Int8MultiArray.h>
#include <string>
#include <thread>
#include <vector>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>
#include <visualization_msgs/InteractiveMarkerUpdate.h>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {
namespace {

using test::ask;
using test::at_pose;
using test::eventually;
using test::Recorder;
using visualization_msgs::InteractiveMarkerFeedback;

geometry_msgs::Pose message_at(double x, double y) {
  geometry_msgs::Pose pose;
  pose.position.x = x;
  pose.position.y = y;
  pose.orientation.w = 1.0;
  return pose;
}

class ProbeOfNode : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Recorder<MapProgress> progress("/aspect_node/map_progress");
    ASSERT_TRUE(
        eventually([&] { return progress.last() && progress.last()->state == MapProgress::COMPLETE; }));
  }

  ProbeOfNode() {
    EXPECT_TRUE(eventually([this] {
      return state_.connected() && poses_.getNumSubscribers() > 0 && modes_.getNumSubscribers() > 0;
    }));
  }

  void choose(const std::vector<std::int8_t>& signs) const {
    std_msgs::Int8MultiArray message;
    message.data = signs;
    modes_.publish(message);
  }

  // The state of the probe where it is wanted at (x, y).
  std::optional<ProbeState> state_at(double x, double y, const std::vector<std::int8_t>& mode) const {
    std::optional<ProbeState> found;
    const bool came = eventually([&] {
      found = state_.last();
      return found && std::hypot(found->wanted.position.x - x, found->wanted.position.y - y) < 1e-9 &&
             found->working_mode == mode;
    });
    return came ? found : std::nullopt;
  }

  std::string refusal(const std::string& word) const {
    std::string text;
    EXPECT_TRUE(eventually([&] {
      const auto found = log_.first([&](const rosgraph_msgs::Log& line) {
        return line.level == rosgraph_msgs::Log::WARN && line.msg.find(word) != std::string::npos;
      });
      if (found) text = found->msg;
      return found.has_value();
    })) << word;
    return text;
  }

  ros::NodeHandle nh_;
  const Recorder<ProbeState> state_{"/aspect_node/probe/state"};
  const Recorder<rosgraph_msgs::Log> log_{"/rosout"};
  const ros::Publisher poses_ = nh_.advertise<geometry_msgs::Pose>("/aspect_node/probe/set_pose", 10);
  const ros::Publisher modes_ =
      nh_.advertise<std_msgs::Int8MultiArray>("/aspect_node/probe/working_mode", 10);
};

TEST_F(ProbeOfNode, TypedPoseIsAnsweredAsByTheServices) {
  choose({1, -1});
  poses_.publish(message_at(4.5, 8.0));
  const auto state = state_at(4.5, 8.0, {1, -1});
  ASSERT_TRUE(state);
  EXPECT_EQ(state->status.code, Status::OK) << state->status.message;
  EXPECT_EQ(state->off, 0.0);
  const Configuration same = at_pose(4.5, 8.0, "base_link", {1, -1});
  const auto aspect = ask<GetCurrentAspect>("get_current_aspect", same);
  ASSERT_EQ(aspect.solutions.size(), 1U);
  EXPECT_EQ(state->report.configuration.aspect, aspect.solutions.front().aspect);
  EXPECT_GT(state->report.configuration.aspect, 0U);
  const auto distance = ask<GetSingularityDistance>("get_singularity_distance", same);
  ASSERT_EQ(distance.reports.size(), 1U);
  EXPECT_EQ(state->report.parallel_distance.lower, distance.reports.front().parallel_distance.lower);
  EXPECT_EQ(state->report.parallel_distance.witness.position.x,
            distance.reports.front().parallel_distance.witness.position.x);
  EXPECT_EQ(state->report.serial_distance.upper, distance.reports.front().serial_distance.upper);
  const Recorder<geometry_msgs::PoseStamped> pose("/aspect_node/probe/pose");
  const Recorder<visualization_msgs::MarkerArray> markers("/aspect_node/probe/markers");
  ASSERT_TRUE(eventually(
      [&] { return pose.last() && markers.last() && markers.last()->markers.size() > 1; }));  // latched
  EXPECT_EQ(pose.last()->header.frame_id, "base_link");
  EXPECT_NEAR(pose.last()->pose.position.y, 8.0, 1e-12);
  EXPECT_TRUE(std::any_of(markers.last()->markers.begin(), markers.last()->markers.end(),
                          [](const auto& marker) { return marker.ns == "probe/robot"; }));
}

TEST_F(ProbeOfNode, OutOfReachStaysAtTheNearestPoseAndSaysSo) {
  choose({1, 1});
  poses_.publish(message_at(-10.0, 0.0));
  const auto state = state_at(-10.0, 0.0, {1, 1});
  ASSERT_TRUE(state);
  EXPECT_EQ(state->status.code, Status::NO_SOLUTION);
  EXPECT_NE(state->status.message.find("leg_2"), std::string::npos) << state->status.message;
  EXPECT_NEAR(state->report.configuration.pose.position.x, -4.0, 1e-5);
  EXPECT_NEAR(state->off, 6.0, 1e-5);
}

TEST_F(ProbeOfNode, BadPosesAndModesAreRefusedByName) {
  poses_.publish(message_at(4.5, 7.0));
  ASSERT_TRUE(state_at(4.5, 7.0, {1, 1}));
  poses_.publish(message_at(std::numeric_limits<double>::quiet_NaN(), 0.0));
  EXPECT_NE(refusal("position.x").find("finite"), std::string::npos);
  ros::WallDuration(1.1).sleep();  // warnings of a kind come once a second
  geometry_msgs::Pose zero = message_at(1.0, 1.0);
  zero.orientation.w = 0.0;
  poses_.publish(zero);
  EXPECT_NE(refusal("orientation has the length").find("set_pose"), std::string::npos);
  choose({1, 2});
  EXPECT_NE(refusal("working mode").find("(+,-)"), std::string::npos);
  EXPECT_EQ(state_.last()->wanted.position.y, 7.0);
}

TEST_F(ProbeOfNode, NewestOfManyPosesIsAnsweredAndFewOfThemAre) {
  const std::size_t before = state_.all().size();
  const ros::WallTime start = ros::WallTime::now();
  for (int i = 1; i <= 1000; ++i) {
    poses_.publish(message_at(4.5, 6.0 + 1e-3 * i));
    ros::WallDuration(0.001).sleep();
  }
  ASSERT_TRUE(state_at(4.5, 7.0, {1, 1}));
  const double seconds = (ros::WallTime::now() - start).toSec();
  EXPECT_LE(static_cast<double>(state_.all().size() - before), 20.0 * seconds + 2.0);
}

class HandleOfNode : public ProbeOfNode {
 protected:
  HandleOfNode() {
    EXPECT_TRUE(eventually([this] { return feedback_.getNumSubscribers() > 0 && init_.last(); }));
  }

  void send(std::uint8_t event, const geometry_msgs::Pose& pose, std::uint32_t entry = 0) const {
    InteractiveMarkerFeedback message;
    message.header.frame_id = "base_link";
    message.client_id = "test";
    message.marker_name = "probe";
    message.event_type = event;
    message.pose = pose;
    message.menu_entry_id = entry;
    feedback_.publish(message);
  }

  void select(const std::string& title) const {
    const visualization_msgs::InteractiveMarkerInit init = *init_.last();
    for (const auto& entry : init.markers.front().menu_entries)
      if (entry.title.find(title) != std::string::npos)
        return send(InteractiveMarkerFeedback::MENU_SELECT, message_at(0.0, 0.0), entry.id);
    ADD_FAILURE() << title;
  }

  const ros::Publisher feedback_ =
      nh_.advertise<InteractiveMarkerFeedback>("/aspect_node/probe/handle/feedback", 10);
  const Recorder<visualization_msgs::InteractiveMarkerInit> init_{"/aspect_node/probe/handle/update_full"};
  const Recorder<visualization_msgs::InteractiveMarkerUpdate> updates_{"/aspect_node/probe/handle/update"};
};

TEST_F(HandleOfNode, GoesToTheProbeWhenItIsReleased) {
  if (!has_probe_handle()) GTEST_SKIP();
  choose({1, 1});
  send(InteractiveMarkerFeedback::POSE_UPDATE, message_at(-12.0, 0.0));
  ASSERT_TRUE(state_at(-12.0, 0.0, {1, 1}));
  send(InteractiveMarkerFeedback::MOUSE_UP, message_at(-12.0, 0.0));
  EXPECT_TRUE(eventually([this] {
    return updates_
        .first([](const auto& update) {
          return !update.poses.empty() && std::abs(update.poses.front().pose.position.x + 4.0) < 1e-5;
        })
        .has_value();
  }));
}

TEST_F(HandleOfNode, MenuChoosesAndStores) {
  if (!has_probe_handle()) GTEST_SKIP();
  const Recorder<Configuration> start("/aspect_node/probe/start"), goal("/aspect_node/probe/goal");
  poses_.publish(message_at(4.5, 8.0));
  select("(-,+)");
  ASSERT_TRUE(state_at(4.5, 8.0, {-1, 1}));
  select("Store as start");
  ASSERT_TRUE(eventually([&] { return start.last().has_value(); }));
  EXPECT_EQ(start.last()->kind, Configuration::POSE);
  EXPECT_EQ(start.last()->working_mode, (std::vector<std::int8_t>{-1, 1}));
  EXPECT_NEAR(start.last()->pose.pose.position.y, 8.0, 1e-12);
  EXPECT_FALSE(goal.last());
  select("Store as goal");
  EXPECT_TRUE(eventually([&] { return goal.last().has_value(); }));
  // A question may be asked about what was stored.
  EXPECT_EQ(ask<GetCurrentAspect>("get_current_aspect", *start.last()).solutions.size(), 1U);
}

TEST_F(HandleOfNode, ShowsOtherWorkingModesAndHides) {
  if (!has_probe_handle()) GTEST_SKIP();
  const Recorder<visualization_msgs::MarkerArray> markers("/aspect_node/probe/markers");
  const auto shows = [&](const std::string& name) {
    const auto last = markers.last();
    return last && std::any_of(last->markers.begin(), last->markers.end(), [&](const auto& marker) {
             return marker.ns == name && marker.action == visualization_msgs::Marker::ADD;
           });
  };
  poses_.publish(message_at(4.5, 8.0));
  ASSERT_TRUE(eventually([&] { return shows("probe/robot"); }));
  select("other working modes");
  EXPECT_TRUE(eventually([&] { return shows("probe/other_3"); }));
  select("Hide");
  EXPECT_TRUE(eventually([&] { return !shows("probe/robot"); }));
  poses_.publish(message_at(4.5, 7.5));
  EXPECT_TRUE(eventually([&] { return shows("probe/robot"); }));
}

// While the probe is dragged about, the robot is followed, and its state knows nothing of the probe.
TEST_F(HandleOfNode, LeavesTheTrackedRobotAloneAndIsResetToIt) {
  if (!has_probe_handle()) GTEST_SKIP();
  const auto mechanism = test::five_bar_mechanism();
  const ros::Publisher joints = nh_.advertise<sensor_msgs::JointState>("/joint_states", 1000);
  const Recorder<AspectState> robot("/aspect_node/state");
  ASSERT_TRUE(eventually([&] { return joints.getNumSubscribers() > 0; }));
  std::atomic<bool> done{false};
  std::thread driver([&] {
    while (!done) {
      joints.publish(
          test::joints_at(*mechanism->manipulator(), test::pose_at(4.5, 8.0), {-1, 1}, ros::Time::now()));
      ros::WallDuration(0.01).sleep();
    }
  });
  const bool tracked = eventually([&] { return robot.last() && robot.last()->status.code == Status::OK; });
  const std::size_t before = robot.all().size();
  for (int i = 0; i < 50; ++i) {
    send(InteractiveMarkerFeedback::POSE_UPDATE, message_at(4.5 - 0.2 * i, 5.0));
    ros::WallDuration(0.01).sleep();
  }
  send(InteractiveMarkerFeedback::MOUSE_UP, message_at(-5.3, 5.0));
  EXPECT_TRUE(eventually([&] { return robot.all().size() > before + 100; }));
  const std::vector<AspectState> states = robot.all();
  select("Reset");
  EXPECT_TRUE(state_at(4.5, 8.0, {-1, 1}));
  done = true;
  driver.join();
  ASSERT_TRUE(tracked);
  for (std::size_t i = before; i < states.size(); ++i) {
    ASSERT_EQ(states[i].status.code, Status::OK) << states[i].status.message;
    EXPECT_NEAR(states[i].pose.position.y, 8.0, 1e-9);
    EXPECT_EQ(states[i].working_mode, (std::vector<std::int8_t>{-1, 1}));
  }
}

}  // namespace
}  // namespace parallel_aspects
