// SPDX-License-Identifier: BSD-3-Clause
//
// The running node, and everything that joint_states can do to it. After each fault every state that was
// published is compared with where the robot truly was: it may say that it does not know, but never anything
// wrong, and it finds back by itself.
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/mute_subscriber.h"
#include "ros/node/node_client.h"
#include "ros/node/process.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/GetWorkingMode.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

namespace parallel_aspects {
namespace {

using test::ask;
using test::at_pose;
using test::eventually;
using test::Recorder;

constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<std::int8_t> true_mode{1, -1};

// Where the robot is after so many steps: on a small circle that is clear of every singularity.
Pose true_pose(int step) {
  return test::pose_at(4.2 + 0.3 * std::cos(0.01 * step), 8.0 + 0.3 * std::sin(0.01 * step));
}

sensor_msgs::JointState true_joints(int step) {
  static const auto mechanism = test::five_bar_mechanism();
  return test::joints_at(*mechanism->manipulator(), true_pose(step), {1, -1}, ros::Time::now());
}

class JointStatesFault : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    publisher_ = ros::NodeHandle().advertise<sensor_msgs::JointState>("joint_states", 20000);
    states_ = std::make_unique<Recorder<AspectState>>("/aspect_node/state");
    ASSERT_TRUE(eventually([] { return publisher_.getNumSubscribers() >= 1 && states_->connected(); }));
  }
  static void TearDownTestSuite() {
    publisher_.shutdown();
    states_.reset();
  }
  void SetUp() override {
    recovers();
    first_ = states_->all().size();
  }
  void TearDown() override {
    recovers();
    expect_nothing_wrong();
  }

  // Publishes where the robot is, one step on. Stamps grow.
  static sensor_msgs::JointState move() {
    sensor_msgs::JointState message = true_joints(++step_);
    message.header.stamp = std::max(ros::Time::now(), last_stamp_ + ros::Duration(1e-6));
    send(message);
    return message;
  }
  static void send(const sensor_msgs::JointState& message) {
    last_stamp_ = std::max(last_stamp_, std::min(message.header.stamp, ros::Time::now()));
    steps_[message.header.stamp] = step_;
    publisher_.publish(message);
  }
  static bool says(std::uint8_t code) {
    const auto last = states_->last();
    return last && last->status.code == code;
  }
  static AspectState answer_to(const sensor_msgs::JointState& message) {
    return states_->answer(message.header.stamp);
  }
  static void recovers() {
    EXPECT_TRUE(eventually([] { return answer_to(move()).status.code == Status::OK; }));
  }
  static void expect_refused(const sensor_msgs::JointState& message) {
    const AspectState state = answer_to(message);
    EXPECT_EQ(state.status.code, Status::INVALID_JOINT_STATES) << message << state;
    EXPECT_FALSE(state.status.message.empty());
    EXPECT_EQ(state.aspect, 0U);
    EXPECT_TRUE(state.working_mode.empty());
    EXPECT_TRUE(std::isnan(state.pose.position.x));
  }
  void expect_nothing_wrong() const {
    const auto states = states_->all();
    for (std::size_t i = first_; i < states.size(); ++i) {
      if (states[i].status.code != Status::OK) continue;
      const Pose truth = true_pose(steps_.at(states[i].header.stamp));
      ASSERT_NEAR(states[i].pose.position.x, truth.position.x(), 1e-6) << states[i];
      ASSERT_NEAR(states[i].pose.position.y, truth.position.y(), 1e-6) << states[i];
      ASSERT_EQ(states[i].working_mode, true_mode) << states[i];
      ASSERT_TRUE(states[i].aspect == 0 || states[i].aspect == true_aspect()) << states[i];
    }
  }
  static std::uint32_t true_aspect() {
    static const std::uint32_t aspect = [] {
      const auto map = compute_aspect_map(test::five_bar_mechanism()->manipulator()).map;
      return static_cast<std::uint32_t>(map->locate(true_pose(0), *WorkingMode::from_signs({1, -1})).aspect);
    }();
    return aspect;
  }

  static ros::Publisher publisher_;
  static std::unique_ptr<Recorder<AspectState>> states_;
  static std::map<ros::Time, int> steps_;  // by the stamp of every message
  static ros::Time last_stamp_;
  static int step_;
  std::size_t first_ = 0;
};

ros::Publisher JointStatesFault::publisher_;
std::unique_ptr<Recorder<AspectState>> JointStatesFault::states_;
std::map<ros::Time, int> JointStatesFault::steps_;
ros::Time JointStatesFault::last_stamp_;
int JointStatesFault::step_ = 0;

TEST_F(JointStatesFault, ValuesThatAreNoPositions) {
  for (const double value : {std::nan(""), infinity, -infinity, 1e308, -1e308}) {
    sensor_msgs::JointState message = true_joints(step_);
    message.position[1] = value;
    send(message);
    expect_refused(message);
  }
}

TEST_F(JointStatesFault, ListsThatDoNotFit) {
  std::vector<sensor_msgs::JointState> bad(5, true_joints(step_));
  bad[0].name.clear();
  bad[0].position.clear();
  bad[1].position.pop_back();
  bad[2].name.pop_back();
  bad[3].name.push_back("crank_1_joint");
  bad[3].position.push_back(0.0);
  bad[4].velocity = {0.0, 0.0, 0.0};
  for (auto& message : bad) {
    message.header.stamp = ros::Time::now();
    send(message);
    expect_refused(message);
  }
}

TEST_F(JointStatesFault, NamesInAnotherOrderAndOfOtherJoints) {
  sensor_msgs::JointState message = true_joints(++step_);
  std::swap(message.name[0], message.name[1]);
  std::swap(message.position[0], message.position[1]);
  message.name.push_back("gripper_joint");
  message.position.push_back(std::nan(""));
  send(message);
  const AspectState state = answer_to(message);
  EXPECT_EQ(state.status.code, Status::OK);
  EXPECT_NE(state.status.message.find("gripper_joint"), std::string::npos);
}

TEST_F(JointStatesFault, StampsThatNoClockGives) {
  const auto is_refusal = [](const AspectState& state) {
    return state.status.code == Status::INVALID_JOINT_STATES;
  };
  const ros::Time now = ros::Time::now();
  for (const ros::Time& stamp : {ros::Time(), now - ros::Duration(10.0), last_stamp_,
                                 now + ros::Duration(1000.0), ros::Time(4294967295U, 999999999U)}) {
    sensor_msgs::JointState message = true_joints(step_);
    message.header.stamp = stamp;
    message.position[0] += 1e-3;  // not the same message again
    const std::size_t before = states_->all().size();
    publisher_.publish(message);
    std::optional<AspectState> refusal;
    EXPECT_TRUE(eventually([&] {
      refusal = states_->first(is_refusal, before);
      return refusal.has_value();
    })) << stamp;
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->header.stamp, stamp);
    EXPECT_NE(refusal->status.message.find("stamp"), std::string::npos);
  }
}

TEST_F(JointStatesFault, ABurstAtTenKilohertz) {
  sensor_msgs::JointState last;
  for (int i = 0; i < 3000; ++i) {
    last = move();
    ros::WallDuration(1e-4).sleep();
  }
  EXPECT_EQ(answer_to(last).status.code, Status::OK);
}

TEST_F(JointStatesFault, AGapOfMoreThanTheTimeout) {
  ASSERT_TRUE(eventually([] { return says(Status::STALE); }));
  EXPECT_EQ(ask<GetWorkingMode>("get_working_mode", Configuration()).status.code, Status::STALE);
  ASSERT_TRUE(eventually([] { return (ros::Time::now() - last_stamp_).toSec() > 1.0; }));
}

TEST_F(JointStatesFault, TwoPublishers) {
  {
    test::Process other("/proc/self/exe", "/", {"--publish-drives", "__name:=second_publisher"});
    std::optional<AspectState> refusal;
    EXPECT_TRUE(eventually([&] {
      move();
      refusal = states_->first(
          [](const AspectState& state) { return state.status.code == Status::SEVERAL_PUBLISHERS; }, first_);
      return refusal.has_value();
    }));
    ASSERT_TRUE(refusal);
    EXPECT_NE(refusal->status.message.find("/second_publisher"), std::string::npos);
    EXPECT_TRUE(eventually([] {
      move();
      return ask<GetWorkingMode>("get_working_mode", Configuration()).status.code ==
             Status::SEVERAL_PUBLISHERS;
    }));
  }
  // Until the other one has been silent for the timeout, nothing is said of some messages.
  EXPECT_TRUE(eventually([] {
    move();
    return says(Status::OK);
  }));
  first_ = states_->all().size();  // the other one was somewhere else at those stamps
}

TEST_F(JointStatesFault, ASubscriberThatNeverReads) {
  const test::MuteSubscriber mute("/aspect_node", "/aspect_node/state");
  ASSERT_TRUE(mute.connected());
  for (int batch = 0; batch < 40; ++batch) {  // more than sockets and queues hold
    sensor_msgs::JointState last;
    for (int i = 0; i < 500; ++i) last = move();
    ASSERT_EQ(answer_to(last).status.code, Status::OK);
  }
  EXPECT_EQ(ask<GetWorkingMode>("get_working_mode", at_pose(4.5, 8.0, "")).status.code, Status::OK);
}

TEST_F(JointStatesFault, EncodersThatWrap) {
  for (int i = 0; i < 8; ++i) {
    sensor_msgs::JointState message = true_joints(++step_);
    message.position[0] += (i % 2 == 0 ? 2.0 : -2.0) * EIGEN_PI;
    message.position[1] -= i % 3 == 0 ? 2.0 * EIGEN_PI : 0.0;
    send(message);
    EXPECT_EQ(answer_to(message).status.code, Status::OK);
  }
}

// Other actuated joints at the next stamp than any motion could have brought: the robot may be in any
// assembly mode.
TEST_F(JointStatesFault, EverySecondMessageIsOfAnotherPlace) {
  for (int i = 0; i < 20; ++i) {
    sensor_msgs::JointState message = true_joints(++step_);
    if (i % 2 == 0)
      for (double& position : message.position) position += 1.0;
    send(message);
    answer_to(message);
  }
  ASSERT_TRUE(eventually([] {
    move();
    return ask<SetAssemblyMode>("set_assembly_mode",
                                at_pose(true_pose(step_).position.x(), true_pose(step_).position.y(), ""))
               .status.code == Status::OK;
  }));
  first_ = states_->all().size();
}

void publish_joints() {
  ros::Publisher publisher = ros::NodeHandle().advertise<sensor_msgs::JointState>("joint_states", 10);
  while (ros::ok()) {
    publisher.publish(true_joints(100));
    ros::WallDuration(0.005).sleep();
  }
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  const bool second = std::find(argv, argv + argc, std::string("--publish-drives")) != argv + argc;
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "joint_states_fault_test");
  const ros::NodeHandle nh;
  if (second) {
    parallel_aspects::publish_joints();
    return 0;
  }
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
