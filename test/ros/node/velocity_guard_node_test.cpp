// SPDX-License-Identifier: BSD-3-Clause
//
// The guard of the running node: commands in, what is left of them out. Tests run in the order in which they
// are written.
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <atomic>
#include <cmath>
#include <geometry_msgs/TwistStamped.h>
#include <memory>
#include <std_msgs/Float64MultiArray.h>
#include <string>
#include <thread>
#include <vector>

namespace parallel_aspects {
namespace {

using test::eventually;
using test::Recorder;

const double x = 4.5, y = 8.0;        // where the robot stands [m]
const std::vector<int> signs{-1, 1};  // its working mode

/// joint_states of a robot that stands, until the end.
class StandingRobot {
 public:
  explicit StandingRobot(const Manipulator& robot)
      : publisher_(ros::NodeHandle().advertise<sensor_msgs::JointState>("joint_states", 100)),
        thread_([this, &robot] {
          while (!ended_) {
            publisher_.publish(test::joints_at(robot, test::pose_at(x, y), signs, ros::Time::now()));
            ros::WallDuration(0.01).sleep();
          }
        }) {}
  ~StandingRobot() {
    ended_ = true;
    thread_.join();
  }

 private:
  ros::Publisher publisher_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

class VelocityGuardNode : public testing::Test {
 protected:
  VelocityGuardNode()
      : commands_(
            ros::NodeHandle().advertise<geometry_msgs::TwistStamped>("/aspect_node/velocity_command", 10)),
        guarded_("/aspect_node/guarded_velocity"),
        joints_("/aspect_node/guarded_joint_velocities"),
        state_("/aspect_node/state") {
    EXPECT_TRUE(eventually([&] {
      return commands_.getNumSubscribers() > 0 && guarded_.connected() && joints_.connected() &&
             state_.connected();
    }));
  }

  // What comes out for a command that is stamped now.
  geometry_msgs::TwistStamped guarded(geometry_msgs::TwistStamped command) {
    command.header.stamp = ros::Time::now();
    commands_.publish(command);
    return guarded_.answer(command.header.stamp);
  }

  static geometry_msgs::TwistStamped command(double vx, double vy, const std::string& frame = "") {
    geometry_msgs::TwistStamped message;
    message.header.frame_id = frame;
    message.twist.linear.x = vx;
    message.twist.linear.y = vy;
    return message;
  }

  // What the state says of the command that was answered last.
  GuardState said(const geometry_msgs::TwistStamped& answer) {
    std::optional<AspectState> state;
    EXPECT_TRUE(eventually([&] {
      state = state_.first([&](const AspectState& each) { return each.guard.stamp == answer.header.stamp; });
      return state.has_value();
    }));
    return state.value_or(AspectState()).guard;
  }

  // Between two robots a busy computer may pause for so long that a joint may have turned by half a turn.
  void say_where_it_stands() {
    SetAssemblyMode mode;
    mode.request.configuration.kind = Configuration::POSE;
    mode.request.configuration.pose.pose.position.x = x;
    mode.request.configuration.pose.pose.position.y = y;
    mode.request.configuration.pose.pose.orientation.w = 1.0;
    mode.request.configuration.working_mode = {-1, 1};
    ASSERT_TRUE(eventually([&] {
      return ros::service::call("/aspect_node/set_assembly_mode", mode) &&
             mode.response.status.code == Status::OK;
    })) << mode.response.status.message;
  }

  void wait_until_tracked() {
    say_where_it_stands();
    ASSERT_TRUE(eventually([&] {
      return state_.last() && state_.last()->status.code == Status::OK &&
             std::isfinite(state_.last()->parallel_distance.lower);
    }));
  }

  // Of the actuated joints, by differences of the inverse solution.
  JointVector rates(double vx, double vy) const {
    const double h = 1e-6;
    const WorkingMode mode = *WorkingMode::from_signs(signs);
    return (inverse(robot_, test::pose_at(x + h * vx, y + h * vy), mode).q -
            inverse(robot_, test::pose_at(x - h * vx, y - h * vy), mode).q) /
           (2.0 * h);
  }

  void expect_joints(const JointVector& expected) {
    const auto is_there = [&](const std_msgs::Float64MultiArray& array) {
      return array.data.size() == 2 && std::abs(array.data[0] - expected[0]) < 1e-6 &&
             std::abs(array.data[1] - expected[1]) < 1e-6 && array.layout.dim.size() == 1 &&
             array.layout.dim[0].size == 2 && array.layout.dim[0].label == "crank_1_joint,crank_2_joint";
    };
    EXPECT_TRUE(eventually([&] { return joints_.first(is_there).has_value(); })) << expected;
  }

  const std::shared_ptr<const Mechanism> mechanism_ = test::five_bar_mechanism();
  const Manipulator& robot_ = *mechanism_->manipulator();
  ros::Publisher commands_;
  Recorder<geometry_msgs::TwistStamped> guarded_;
  Recorder<std_msgs::Float64MultiArray> joints_;
  Recorder<AspectState> state_;
};

TEST_F(VelocityGuardNode, NothingKnownGivesZero) {
  const auto answer = guarded(command(0.1, 0.0));
  EXPECT_EQ(answer.twist.linear.x, 0.0);
  const StandingRobot robot(robot_);
  EXPECT_EQ(said(answer).reason, GuardState::UNKNOWN_STATE);
}

TEST_F(VelocityGuardNode, PassesWhatIsSafe) {
  const StandingRobot robot(robot_);
  wait_until_tracked();
  const auto answer = guarded(command(0.1, 0.05));
  EXPECT_EQ(answer.twist.linear.x, 0.1);
  EXPECT_EQ(answer.twist.linear.y, 0.05);
  const GuardState state = said(answer);
  EXPECT_EQ(state.reason, GuardState::NONE) << state.message;
  EXPECT_EQ(state.scale, 1.0);
  expect_joints(rates(0.1, 0.05));
}

TEST_F(VelocityGuardNode, TurnsCommandsOfOtherFrames) {
  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = robot_.base_frame();
  transform.header.stamp = ros::Time::now();
  transform.child_frame_id = "turned";
  transform.transform.translation.x = 3.0;
  transform.transform.rotation.z = transform.transform.rotation.w = std::sqrt(0.5);
  broadcaster.sendTransform(transform);
  const StandingRobot robot(robot_);
  wait_until_tracked();
  ASSERT_TRUE(eventually([&] { return guarded(command(0.07, 0.0, "turned")).twist.linear.x == 0.07; }));
  EXPECT_EQ(guarded_.last()->header.frame_id, "turned");
  expect_joints(rates(0.0, 0.07));
}

TEST_F(VelocityGuardNode, ScalesWhatWouldComeTooNear) {
  const StandingRobot robot(robot_);
  wait_until_tracked();
  const AspectState state = *state_.last();
  ASSERT_EQ(state.escape_twist.size(), 2U);
  ASSERT_EQ(state.escape_joint_velocities.size(), 2U);
  EXPECT_NEAR(std::hypot(state.escape_twist[0], state.escape_twist[1]), 1.0, 1e-6);
  const double speed = -20.0;
  const auto answer = guarded(command(speed * state.escape_twist[0], speed * state.escape_twist[1]));
  const GuardState said_of_it = said(answer);
  EXPECT_EQ(said_of_it.reason, GuardState::HAZARD) << said_of_it.message;
  EXPECT_GT(said_of_it.scale, 0.0);
  EXPECT_LT(said_of_it.scale, 0.5);
  EXPECT_NEAR(answer.twist.linear.x, said_of_it.scale * speed * state.escape_twist[0], 1e-9);
  const auto reports =
      test::ask<GetSingularityDistance>("get_singularity_distance", test::at_pose(x, y, "", {-1, 1})).reports;
  ASSERT_EQ(reports.size(), 1U);
  const MetricDistance& parallel = reports[0].parallel_distance;
  ASSERT_EQ(parallel.escape_twist.size(), 2U);
  EXPECT_EQ(parallel.escape_twist[0], -parallel.direction[0]);
  EXPECT_EQ(parallel.escape_joint_velocities.size(), 2U);
}

TEST_F(VelocityGuardNode, RefusesWhatTheRobotDoesNotHave) {
  const StandingRobot robot(robot_);
  wait_until_tracked();
  geometry_msgs::TwistStamped turning = command(0.1, 0.0);
  turning.twist.angular.z = 0.2;
  const GuardState turn = said(guarded(turning));
  EXPECT_EQ(turn.reason, GuardState::INVALID_COMMAND);
  EXPECT_NE(turn.message.find("0.2 rad/s about z"), std::string::npos) << turn.message;
  EXPECT_EQ(guarded_.last()->twist.linear.x, 0.0);
  EXPECT_EQ(guarded_.last()->twist.angular.z, 0.0);
  const GuardState nowhere = said(guarded(command(0.1, 0.0, "nowhere")));
  EXPECT_EQ(nowhere.reason, GuardState::INVALID_COMMAND);
  EXPECT_NE(nowhere.message.find("tf does not connect nowhere"), std::string::npos) << nowhere.message;
  const GuardState not_finite = said(guarded(command(std::nan(""), 0.0)));
  EXPECT_NE(not_finite.message.find("not finite"), std::string::npos) << not_finite.message;
}

TEST_F(VelocityGuardNode, AnOldCommandGivesZero) {
  const StandingRobot robot(robot_);
  wait_until_tracked();
  geometry_msgs::TwistStamped old = command(0.1, 0.0);
  old.header.stamp = ros::Time::now() - ros::Duration(5.0);
  commands_.publish(old);
  EXPECT_EQ(guarded_.answer(old.header.stamp).twist.linear.x, 0.0);
  // The last one becomes old.
  EXPECT_EQ(guarded(command(0.1, 0.0)).twist.linear.x, 0.1);
  EXPECT_TRUE(eventually([&] {
    return guarded_.last()->twist.linear.x == 0.0 && state_.last()->guard.reason == GuardState::NO_COMMAND;
  }));
}

TEST_F(VelocityGuardNode, AStaleStateGivesZero) {
  {
    const StandingRobot robot(robot_);
    wait_until_tracked();
    EXPECT_EQ(guarded(command(0.1, 0.0)).twist.linear.x, 0.1);
  }
  EXPECT_TRUE(eventually([&] { return guarded(command(0.1, 0.0)).twist.linear.x == 0.0; }));
}

}  // namespace
}  // namespace parallel_aspects
