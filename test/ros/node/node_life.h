// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_NODE_NODE_LIFE_H
#define PARALLEL_ASPECTS_TEST_ROS_NODE_NODE_LIFE_H

#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"
#include "ros/node/process.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/ListAspects.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// A node of the five-bar in the namespace of its test, with these private parameters.
class NodeLife : public testing::Test {
 protected:
  void SetUp() override {
    space_ = std::string("/") + testing::UnitTest::GetInstance()->current_test_info()->name();
    node_ = space_ + "/aspect_node";
    ros::param::set(space_ + "/robot_description", test::source_file("urdf/five_bar.urdf"));
    set("mechanism", five_bar_mechanism_parameter());
    set("tracking/path_bend", 0.0);    // the motions are straight between samples
    set("joint_states_timeout", 2.0);  // a busy computer holds messages up
    set("tracking/longest_interval", std::numeric_limits<double>::infinity());
    set("start/pose", std::vector<double>{4.5, 8.0});
    set("map/resolution", 0.2);
    joint_states_ = ros::NodeHandle().advertise<sensor_msgs::JointState>(space_ + "/joint_states", 1000);
  }
  void TearDown() override {
    ASSERT_TRUE(process_);
    EXPECT_FALSE(process_->has_ended());
    EXPECT_EQ(process_->end(), 0);
  }

  template <typename Value>
  void set(const std::string& key, const Value& value) {
    ros::param::set(node_ + "/" + key, value);
  }
  void start() {
    process_ = std::make_unique<test::Process>(PARALLEL_ASPECTS_NODE, space_);
    states_ = std::make_unique<Recorder<AspectState>>(node_ + "/state");
    ASSERT_TRUE(eventually([&] { return states_->last().has_value(); }));
    ASSERT_TRUE(eventually([&] { return joint_states_.getNumSubscribers() == 1; }));
  }
  template <typename Service>
  typename Service::Response call(const std::string& name, const typename Service::Request& request = {}) {
    return test::call<Service>(node_ + "/" + name, request);
  }
  std::size_t aspects_known() {
    ListAspects::Response response;
    EXPECT_TRUE(eventually([&] {
      response = call<ListAspects>("list_aspects");
      return response.status.code == Status::OK;
    })) << response.status.message;
    return response.aspects.size();
  }
  // The answer to the actuated joints at this pose.
  AspectState move_to(const Pose& pose, const ros::Time& stamp = ros::Time::now()) {
    const auto message = test::joints_at(*robot_->manipulator(), pose, {1, -1}, stamp);
    joint_states_.publish(message);
    return states_->answer(stamp);
  }
  // What /diagnostics says of this part of this node, once it says that.
  bool diagnosed(const std::string& part, int level) const {
    const auto status = diagnosis(part);
    return status && status->level == level;
  }
  // A value of the part "tracking"; empty where there is none.
  std::string diagnosed_value(const std::string& key, const std::string& part = "tracking") const {
    if (const auto status = diagnosis(part))
      for (const auto& value : status->values)
        if (value.key == key) return value.value;
    return {};
  }
  std::optional<diagnostic_msgs::DiagnosticStatus> diagnosis(const std::string& part) const {
    const auto messages = diagnostics_.all();
    for (auto array = messages.rbegin(); array != messages.rend(); ++array)
      for (const auto& status : array->status)
        if (status.name.find(space_.substr(1)) != std::string::npos &&
            status.name.find(": " + part) != std::string::npos)
          return status;
    return std::nullopt;
  }

  const std::shared_ptr<const Mechanism> robot_ = test::five_bar_mechanism();
  const Pose start_ = test::pose_at(4.5, 8.0);
  int tries_ = 0;
  std::string space_, node_;
  ros::Publisher joint_states_;
  std::unique_ptr<test::Process> process_;
  std::unique_ptr<Recorder<AspectState>> states_;
  const Recorder<diagnostic_msgs::DiagnosticArray> diagnostics_{"/diagnostics"};
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_NODE_NODE_LIFE_H
