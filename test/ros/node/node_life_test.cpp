// SPDX-License-Identifier: BSD-3-Clause
//
// What happens to a node while it lives: reloads, parameters that turn to garbage, map files that vanish or
// break, simulated time that begins anew, a robot that starts in a singular pose, queries while a map is
// computed. Every node has a namespace of its own.
#include "ros/node/node_life.h"

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/ComputeMapAction.h>
#include <parallel_aspects/GetCurrentAspect.h>
#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/GetWorkingMode.h>
#include <parallel_aspects/ListAspects.h>
#include <parallel_aspects/MapProgress.h>
#include <parallel_aspects/Reload.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include <actionlib/client/simple_action_client.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <string>
#include <thread>
#include <utility>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {
namespace {

using test::at_pose;
using test::eventually;
using test::five_bar_mechanism_parameter;
using test::Recorder;

using test::NodeLife;

TEST_F(NodeLife, ReloadsARobot) {
  start();
  EXPECT_EQ(move_to(start_).status.code, Status::OK);
  set("start/pose", std::vector<double>{4.5, -8.0});
  set("map/resolution", 0.25);
  EXPECT_EQ(call<Reload>("reload").status.code, Status::OK);
  ASSERT_TRUE(eventually([&] { return states_->last()->status.code == Status::NO_JOINT_STATES; }));
  ASSERT_TRUE(eventually([&] { return joint_states_.getNumSubscribers() == 1; }));
  EXPECT_EQ(move_to(start_).status.code, Status::NOT_STARTED) << "it starts at the new pose";
  EXPECT_EQ(aspects_known(), 10U);
}

// Before the robot that is there is given up.
TEST_F(NodeLife, RefusesToReloadAStartThatCannotBeReached) {
  start();
  EXPECT_EQ(move_to(start_).status.code, Status::OK);
  set("start/pose", std::vector<double>{40.0, 8.0});
  const auto response = call<Reload>("reload");
  EXPECT_EQ(response.status.code, Status::FAILED);
  ASSERT_EQ(response.problems.size(), 1U);
  EXPECT_NE(response.problems.front().find("start/pose cannot be reached"), std::string::npos);
  EXPECT_EQ(move_to(test::pose_at(4.5, 8.01)).status.code, Status::OK);
}

TEST_F(NodeLife, RefusesToReloadGarbageAndGoesOn) {
  start();
  EXPECT_EQ(move_to(start_).status.code, Status::OK);
  ros::param::set(space_ + "/robot_description", "<robot name='broken'>");
  set("map/resolution", "fine");
  set("joint_states_timeout", std::vector<double>{1.0, 2.0});
  set("no_such_thing", 1);
  const auto response = call<Reload>("reload");
  EXPECT_EQ(response.status.code, Status::FAILED);
  EXPECT_GE(response.problems.size(), 4U);
  for (const auto& problem : response.problems) EXPECT_FALSE(problem.empty());
  EXPECT_EQ(move_to(test::pose_at(4.5, 8.01)).status.code, Status::OK) << "as if nothing had been asked";
  EXPECT_EQ(aspects_known(), 10U);
  ros::param::del(space_ + "/robot_description");
  EXPECT_EQ(call<Reload>("reload").status.code, Status::FAILED);
  EXPECT_EQ(move_to(test::pose_at(4.5, 8.02)).status.code, Status::OK);
  for (const char* key : {"map", "joint_states_timeout", "no_such_thing"}) ros::param::del(node_ + "/" + key);
  ros::param::set(space_ + "/robot_description", "");  // the only problem
  const auto of_empty = call<Reload>("reload");
  EXPECT_EQ(of_empty.status.code, Status::FAILED);
  ASSERT_EQ(of_empty.problems.size(), 1U);
  EXPECT_NE(of_empty.problems.front().find("robot_description is empty"), std::string::npos);
  EXPECT_EQ(move_to(test::pose_at(4.5, 8.03)).status.code, Status::OK);
}

TEST_F(NodeLife, SurvivesWhatBecomesOfItsMapFile) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("aspects_of_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string file = folder / "five_bar.map";
  set("map/file", file);
  start();
  EXPECT_EQ(aspects_known(), 10U);
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file); }));
  const auto whole = std::filesystem::file_size(file);

  // While it runs the map is in memory.
  std::filesystem::resize_file(file, whole / 2);
  EXPECT_EQ(aspects_known(), 10U);
  std::filesystem::remove(file);
  EXPECT_EQ(aspects_known(), 10U);

  // At a start a file that is not there, or is a map that was cut off, is replaced; what is no map stays.
  const auto reload = [&] {
    EXPECT_EQ(call<Reload>("reload").status.code, Status::OK);
    EXPECT_EQ(aspects_known(), 10U);
  };
  const auto is_whole = [&] {
    return std::filesystem::is_regular_file(file) && std::filesystem::file_size(file) == whole;
  };
  reload();
  ASSERT_TRUE(eventually(is_whole));
  std::filesystem::resize_file(file, whole / 2);
  reload();
  ASSERT_TRUE(eventually(is_whole));
  std::ofstream(file) << "not a map";
  reload();
  EXPECT_TRUE(
      eventually([&] { return diagnosed_value("file", "map").find("is no map") != std::string::npos; }));
  EXPECT_EQ(std::filesystem::file_size(file), 9U);
  std::filesystem::remove(file);
  reload();
  ASSERT_TRUE(eventually(is_whole));
  const auto written = std::filesystem::last_write_time(file);
  reload();
  EXPECT_EQ(std::filesystem::last_write_time(file), written) << "loaded, so not written again";
  std::filesystem::remove(file);
  std::filesystem::create_directories(file);
  reload();
  std::filesystem::remove_all(folder);
  reload();
  EXPECT_TRUE(eventually([&] { return diagnosed("map", diagnostic_msgs::DiagnosticStatus::OK); }));
}

TEST_F(NodeLife, StartsInASingularPose) {
  // P, C and D in one line: det A = 0.
  set("start/pose", std::vector<double>{4.218, 6.490});
  start();
  const auto& legs = robot_->manipulator()->legs();
  sensor_msgs::JointState message;
  for (const Leg& leg : legs) message.name.push_back(leg.actuated_joint);
  message.position = {1.5, EIGEN_PI - 1.5};
  // The cranks such that the elbows are 13 apart: both rods in line, 5 + 8.
  const auto gap = [&](double q) {
    return (Eigen::Vector2d(8.0 * std::cos(1.5), 8.0 * std::sin(1.5)) -
            Eigen::Vector2d(9.0 + 5.0 * std::cos(q), 5.0 * std::sin(q)))
               .norm() -
           13.0;
  };
  double low = 0.0, high = EIGEN_PI / 2;
  ASSERT_LT(gap(high) * gap(low), 0.0);
  for (int i = 0; i < 80; ++i) (gap(low) * gap(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  message.position[1] = low;
  message.header.stamp = ros::Time::now();
  joint_states_.publish(message);
  const AspectState answer = states_->answer(message.header.stamp);
  EXPECT_NE(answer.status.code, Status::OK);
  EXPECT_FALSE(answer.status.message.empty());
  EXPECT_EQ(answer.aspect, 0U);

  // Elsewhere it can be determined.
  move_to(start_);
  SetAssemblyMode::Request request;
  request.configuration = at_pose(4.5, 8.0, "");
  EXPECT_EQ(call<SetAssemblyMode>("set_assembly_mode", request).status.code, Status::OK);
  EXPECT_EQ(move_to(test::pose_at(4.5, 8.01)).status.code, Status::OK);
}

TEST_F(NodeLife, SimulatedTimeBeginsAnew) {
  ros::param::set("/use_sim_time", true);
  start();
  ros::param::set("/use_sim_time", false);
  ros::Publisher clock = ros::NodeHandle().advertise<rosgraph_msgs::Clock>("/clock", 100, true);
  ASSERT_TRUE(eventually([&] { return clock.getNumSubscribers() >= 1; }));
  const auto at = [&](double seconds, double y) {
    rosgraph_msgs::Clock now;
    now.clock = ros::Time(seconds);
    clock.publish(now);
    return move_to(test::pose_at(4.5, y), ros::Time(seconds)).status.code;
  };
  // The clock and joint_states come on two connections, so one may be late for the other.
  ASSERT_TRUE(eventually([&] { return at(100.0 + 1e-3 * ++tries_, 8.0) == Status::OK; }));
  ASSERT_TRUE(eventually([&] { return at(5.0 + 1e-3 * ++tries_, 8.0) == Status::OK; }));
  EXPECT_EQ(states_->last()->working_mode, (std::vector<std::int8_t>{1, -1}));
  // It is paused, and goes on.
  const auto aspect = states_->last()->aspect;
  ASSERT_TRUE(eventually([&] { return states_->last()->status.code == Status::STALE; }));
  EXPECT_NE(states_->last()->status.message.find("paused"), std::string::npos);
  ASSERT_TRUE(eventually([&] { return at(5.1 + 1e-3 * ++tries_, 8.0) == Status::OK; }));
  EXPECT_EQ(states_->last()->aspect, aspect);
  clock.shutdown();
}

TEST_F(NodeLife, AnswersWhileAMapIsComputed) {
  set("map/resolution", 1e-4);  // far more than there is time for
  start();
  EXPECT_EQ(move_to(start_).status.code, Status::OK);
  GetCurrentAspect::Response aspect = call<GetCurrentAspect>("get_current_aspect");
  EXPECT_EQ(aspect.status.code, Status::MAP_NOT_READY);
  EXPECT_NE(aspect.status.message.find("map"), std::string::npos);
  EXPECT_EQ(call<ListAspects>("list_aspects").status.code, Status::MAP_NOT_READY);
  move_to(start_);
  EXPECT_EQ(call<GetWorkingMode>("get_working_mode").status.code, Status::OK);
  move_to(start_);
  EXPECT_EQ(call<GetSingularityDistance>("get_singularity_distance").status.code, Status::OK);
  EXPECT_TRUE(eventually([&] { return diagnosed("map", diagnostic_msgs::DiagnosticStatus::WARN); }));

  // Another map takes the place of the endless one.
  actionlib::SimpleActionClient<ComputeMapAction> client(node_ + "/compute_map", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(test::deadline)));
  ComputeMapGoal goal;
  goal.resolution = 0.2;
  goal.extra_levels = 10;
  client.sendGoalAndWait(goal, ros::Duration(test::deadline));
  EXPECT_EQ(client.getState(), actionlib::SimpleClientGoalState::SUCCEEDED);
  EXPECT_EQ(aspects_known(), 10U);
}

// Thresholds by dynamic_reconfigure: taken where they make sense, and refused where they do not.
TEST_F(NodeLife, ThresholdsChangeWhileItRuns) {
  set("map/resolution", 0.5);
  start();
  double y = 8.0;
  const auto level = [&] { return move_to(test::pose_at(4.5, y += 1e-6)).level; };
  ASSERT_TRUE(eventually([&] { return level() == AspectState::NO_THRESHOLD; }));
  EXPECT_TRUE(eventually([&] {
    level();
    return diagnosed("tracking", diagnostic_msgs::DiagnosticStatus::WARN) &&
           diagnosed_value("level") == "no threshold" &&
           diagnosed_value("thresholds").find("parallel_stop: ") != std::string::npos;
  }));
  const auto change = [&](double warn, double stop) {
    dynamic_reconfigure::Reconfigure service;
    for (const auto& [name, value] :
         {std::make_pair("parallel_warn", warn), std::make_pair("parallel_stop", stop)}) {
      dynamic_reconfigure::DoubleParameter parameter;
      parameter.name = name;
      parameter.value = value;
      service.request.config.doubles.push_back(parameter);
    }
    EXPECT_TRUE(
        ros::service::waitForService(node_ + "/thresholds/set_parameters", ros::Duration(test::deadline)));
    EXPECT_TRUE(ros::service::call(node_ + "/thresholds/set_parameters", service));
    for (const auto& parameter : service.response.config.doubles)
      if (parameter.name == "parallel_warn") return parameter.value;
    return std::nan("");
  };
  EXPECT_EQ(change(100.0, 0.0), 100.0);
  EXPECT_TRUE(eventually([&] { return level() == AspectState::WARN; }));
  EXPECT_NE(states_->last()->reason.find("parallel"), std::string::npos);
  EXPECT_TRUE(eventually([&] {
    level();
    return diagnosed("tracking", diagnostic_msgs::DiagnosticStatus::WARN) &&
           diagnosed_value("level") == "warn";
  }));
  EXPECT_EQ(change(std::nan(""), 0.0), 100.0) << "not a number";
  EXPECT_EQ(change(50.0, 60.0), 100.0) << "a stop before the warning";
  EXPECT_EQ(change(-0.6, 0.0), 100.0) << "less than none";
  EXPECT_EQ(level(), AspectState::WARN);
  EXPECT_EQ(change(100.0, 90.0), 100.0);
  EXPECT_TRUE(eventually([&] { return level() == AspectState::STOP; }));
}

// The server itself would move it to the end of its range, in silence.
TEST_F(NodeLife, ADisplayThatMakesNoSenseIsRefused) {
  start();
  const std::string name = node_ + "/display/set_parameters";
  ASSERT_TRUE(ros::service::waitForService(name, ros::Duration(test::deadline)));
  const auto change = [&](double rate) {
    dynamic_reconfigure::Reconfigure service;
    service.request.config.doubles.resize(1);
    service.request.config.doubles[0].name = "rate";
    service.request.config.doubles[0].value = rate;
    EXPECT_TRUE(ros::service::call(name, service));
    for (const auto& parameter : service.response.config.doubles)
      if (parameter.name == "rate") return parameter.value;
    return std::nan("");
  };
  EXPECT_EQ(change(1e6), 20.0);
  EXPECT_EQ(change(5.0), 5.0);
  for (const double wrong : {0.0, std::nan(""), 1e300}) EXPECT_EQ(change(wrong), 5.0) << wrong;
}

TEST_F(NodeLife, ReadOnlyRefusesWhateverChangesIt) {
  set("read_only", true);
  start();
  EXPECT_EQ(move_to(start_).status.code, Status::OK);
  set("read_only", false);  // too late
  set("start/pose", std::vector<double>{4.5, -8.0});
  EXPECT_EQ(call<Reload>("reload").status.code, Status::READ_ONLY);
  SetAssemblyMode::Request sign;
  sign.configuration.determinant_sign = 1;
  EXPECT_EQ(call<SetAssemblyMode>("set_assembly_mode", sign).status.code, Status::READ_ONLY);
  actionlib::SimpleActionClient<ComputeMapAction> client(node_ + "/compute_map", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(test::deadline)));
  client.sendGoalAndWait(ComputeMapGoal(), ros::Duration(test::deadline));
  EXPECT_EQ(client.getState(), actionlib::SimpleClientGoalState::ABORTED);
  EXPECT_EQ(client.getResult()->status.code, Status::READ_ONLY);
  for (const auto& [group, key] :
       {std::make_pair("thresholds", "parallel_warn"), std::make_pair("display", "rate")}) {
    dynamic_reconfigure::Reconfigure service;
    service.request.config.doubles.resize(1);
    service.request.config.doubles[0].name = key;
    service.request.config.doubles[0].value = 7.0;
    const std::string name = node_ + "/" + group + "/set_parameters";
    ASSERT_TRUE(ros::service::waitForService(name, ros::Duration(test::deadline)));
    ASSERT_TRUE(ros::service::call(name, service));
    for (const auto& parameter : service.response.config.doubles)
      EXPECT_NE(parameter.value, 7.0) << parameter.name;
  }
  EXPECT_EQ(move_to(test::pose_at(4.5, 8.01)).status.code, Status::OK) << "and answers as ever";
  EXPECT_EQ(call<GetWorkingMode>("get_working_mode").status.code, Status::OK);
}

// Actionlib throws where it looks whether such a time is over, also on the thread of the goal that runs.
TEST_F(NodeLife, SurvivesGoalsAndCancellationsFromTheFuture) {
  start();
  EXPECT_EQ(aspects_known(), 10U);
  const std::string action = node_ + "/compute_map";
  ros::Publisher goals = ros::NodeHandle().advertise<ComputeMapActionGoal>(action + "/goal", 10);
  ros::Publisher cancel = ros::NodeHandle().advertise<actionlib_msgs::GoalID>(action + "/cancel", 10);
  const Recorder<ComputeMapActionFeedback> feedback(action + "/feedback");
  ASSERT_TRUE(eventually([&] { return goals.getNumSubscribers() > 0 && cancel.getNumSubscribers() > 0; }));
  ComputeMapActionGoal running;
  running.goal_id.id = "running";
  running.goal_id.stamp = ros::Time::now();
  running.goal.resolution = 0.05;
  ASSERT_TRUE(eventually([&] {
    goals.publish(running);
    const auto last = feedback.last();
    return last && last->feedback.progress.state == MapProgress::COMPUTING;
  }));
  actionlib_msgs::GoalID nobody;
  nobody.id = "nobody";
  nobody.stamp = ros::Time(4294967295U, 2U);
  cancel.publish(nobody);
  running.goal_id = nobody;
  goals.publish(running);
  ComputeMapGoal goal;
  goal.resolution = 0.5;
  EXPECT_TRUE(eventually([&] {
    actionlib::SimpleActionClient<ComputeMapAction> client(action, true);
    return process_->has_ended() ||
           (client.waitForServer(ros::Duration(1.0)) &&
            client.sendGoalAndWait(goal, ros::Duration(5.0)) == actionlib::SimpleClientGoalState::SUCCEEDED);
  }));
}

// Tf2 throws for them, on the thread that hears /tf.
TEST_F(NodeLife, SurvivesTransformsFromTheFuture) {
  start();
  ros::Publisher tf = ros::NodeHandle().advertise<tf2_msgs::TFMessage>("/tf", 100);
  GetWorkingMode::Request request;
  request.configuration.kind = Configuration::POSE;
  request.configuration.pose.header.frame_id = "beside_the_base";
  request.configuration.pose.pose.position.x = 4.5;
  request.configuration.pose.pose.position.y = 8.0;
  request.configuration.pose.pose.orientation.w = 1.0;
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  geometry_msgs::TransformStamped& transform = message.transforms.front();
  transform.header.frame_id = "base_link";
  transform.transform.rotation.w = 1.0;
  EXPECT_TRUE(eventually([&] {
    transform.child_frame_id = "of_no_time";
    transform.header.stamp = ros::Time(4294967295U, 1U);
    tf.publish(message);
    transform.child_frame_id = "beside_the_base";
    transform.header.stamp = ros::Time::now();
    tf.publish(message);
    return process_->has_ended() ||
           call<GetWorkingMode>("get_working_mode", request).status.code == Status::OK;
  }));
}

// What waited for a node that was stopped is old, which is no fault of the clocks of others.
TEST_F(NodeLife, ANodeThatStoodStillBlamesNoClock) {
  set("joint_states_timeout", 0.5);
  start();
  std::atomic<bool> over{false};
  std::thread robot([&] {
    for (ros::WallRate rate(100.0); !over; rate.sleep())
      joint_states_.publish(test::joints_at(*robot_->manipulator(), start_, {1, -1}, ros::Time::now()));
  });
  const auto tracked = [&] { return states_->last()->status.code == Status::OK; };
  EXPECT_TRUE(eventually(tracked));
  process_->signal(SIGSTOP);
  const ros::Time stopped = ros::Time::now();
  EXPECT_TRUE(eventually([&] { return (ros::Time::now() - stopped).toSec() > 2.0; }));
  process_->signal(SIGCONT);
  EXPECT_TRUE(
      eventually([&] { return tracked() && states_->last()->header.stamp > stopped + ros::Duration(2.0); }));
  over = true;
  robot.join();
  bool said = false;
  for (const AspectState& state : states_->all()) {
    EXPECT_EQ(state.status.message.find("clock"), std::string::npos) << state.status.message;
    said = said || state.status.message.find("stood still") != std::string::npos;
  }
  EXPECT_TRUE(said);
}

// Without visuals rviz has no model of it; nor has it one of what it may be.
TEST_F(NodeLife, ARobotWithoutVisualsIsDrawnAsLines) {
  const std::regex visual(R"(<visual[\s>][\s\S]*?</visual>)");
  ros::param::set(space_ + "/robot_description",
                  std::regex_replace(test::source_file("urdf/five_bar.urdf"), visual, ""));
  ros::param::del(node_ + "/start");
  start();
  const Recorder<visualization_msgs::MarkerArray> markers(node_ + "/position_markers");
  const auto drawn = [&](const std::string& group) {
    const auto last = markers.last();
    return last && std::any_of(last->markers.begin(), last->markers.end(), [&](const auto& marker) {
             return marker.ns == group && marker.type == visualization_msgs::Marker::LINE_LIST;
           });
  };
  EXPECT_TRUE(eventually([&] {
    move_to(start_);
    return drawn("candidate_1") && drawn("candidate_2") && !drawn("robot");
  }));
  SetAssemblyMode::Request sign;
  sign.configuration.determinant_sign = 1;
  EXPECT_EQ(call<SetAssemblyMode>("set_assembly_mode", sign).status.code, Status::OK);
  EXPECT_TRUE(eventually([&] {
    move_to(start_);
    return drawn("robot") && !drawn("candidate_1");
  }));
}

TEST_F(NodeLife, ReportsRatesAndLossesInDiagnostics) {
  using Level = diagnostic_msgs::DiagnosticStatus;
  set("thresholds/parallel_stop", 0.1);
  start();
  EXPECT_TRUE(eventually(
      [&] { return diagnosed("tracking", Level::WARN) && diagnosed("joint_states", Level::WARN); }));
  int step = 0;
  const auto move = [&] { return move_to(test::pose_at(4.5, 8.0 + 1e-5 * ++step)).status.code; };
  EXPECT_TRUE(eventually([&] {
    move();
    return diagnosed("tracking", Level::OK) && diagnosed("joint_states", Level::OK);
  }));
  EXPECT_TRUE(eventually([&] {
    return diagnosed("tracking", Level::ERROR) && diagnosed("joint_states", Level::ERROR);
  })) << "stale";
}

}  // namespace
}  // namespace parallel_aspects
