// SPDX-License-Identifier: BSD-3-Clause
//
// A reload whose robot cannot be served: the one before is served again, as it was.
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/aspect_server.h"
#include "ros/node/node_client.h"

#include <parallel_aspects/Reload.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <std_msgs/String.h>

namespace parallel_aspects {
namespace {

using test::eventually;
using test::five_bar_mechanism_parameter;
using test::Recorder;

/// A node of the five-bar in this process, where a topic of another type keeps the guard from being served.
class ReloadThatFails : public testing::Test {
 protected:
  void SetUp() override {
    ros::param::set("/reload_fails/robot_description", test::source_file("urdf/five_bar.urdf"));
    nh_.deleteParam("guard");
    nh_.setParam("mechanism", five_bar_mechanism_parameter());
    nh_.setParam("map/resolution", 0.5);
    nh_.setParam("thresholds/parallel_stop", 0.25);
    commands_ = nh_.subscribe("velocity_command", 1, &ReloadThatFails::hear);
  }

  static void hear(const std_msgs::StringConstPtr& /*text*/) {}

  Reload::Response reload_with(bool guard, double stop) {
    nh_.setParam("guard/enabled", guard);
    nh_.setParam("guard/linear_deceleration", 50.0);
    nh_.setParam("thresholds/parallel_stop", stop);
    return test::call<Reload>("/reload_fails/aspect_node/reload", {});
  }

  // What the node says is in force.
  double stop_in_force() const {
    double stop = std::nan("");
    EXPECT_TRUE(eventually([&] { return updates_.last().has_value(); }));
    const dynamic_reconfigure::Config last = updates_.last().value_or(dynamic_reconfigure::Config());
    for (const auto& parameter : last.doubles)
      if (parameter.name == "parallel_stop") stop = parameter.value;
    return stop;
  }

  void change(double stop) {
    dynamic_reconfigure::Reconfigure service;
    service.request.config.doubles.resize(1);
    service.request.config.doubles[0].name = "parallel_stop";
    service.request.config.doubles[0].value = stop;
    EXPECT_TRUE(ros::service::call("/reload_fails/aspect_node/thresholds/set_parameters", service));
  }

  ros::NodeHandle nh_{"/reload_fails/aspect_node"};
  ros::Subscriber commands_;
  const Recorder<dynamic_reconfigure::Config> updates_{
      "/reload_fails/aspect_node/thresholds/parameter_updates"};
};

TEST_F(ReloadThatFails, KeepsTheThresholdsOfTheRobotThatIsServed) {
  AspectServer server(ros::NodeHandle("/reload_fails"), nh_);
  ASSERT_TRUE(eventually([&] { return stop_in_force() == 0.25; }));
  change(0.5);
  ASSERT_TRUE(eventually([&] { return stop_in_force() == 0.5; }));
  EXPECT_EQ(reload_with(true, 0.75).status.code, Status::FAILED);
  // The last update is that of the robot that is served again: its own, not those that were refused with the
  // other.
  const std::size_t before = updates_.all().size();
  change(-1.0);  // refused, and answered with what is in force
  ASSERT_TRUE(eventually([&] { return updates_.all().size() > before; }));
  EXPECT_EQ(stop_in_force(), 0.5);
}

TEST_F(ReloadThatFails, TheNextReloadReadsWhatWasAskedFor) {
  AspectServer server(ros::NodeHandle("/reload_fails"), nh_);
  EXPECT_EQ(reload_with(true, 0.75).status.code, Status::FAILED);
  double asked = 0.0;
  EXPECT_TRUE(nh_.getParam("thresholds/parallel_stop", asked));
  EXPECT_EQ(asked, 0.75);
}

}  // namespace
}  // namespace parallel_aspects
