// SPDX-License-Identifier: BSD-3-Clause
//
// ~check_trajectory of the running node.
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/CheckTrajectory.h>
#include <parallel_aspects/SetAssemblyMode.h>
#include <parallel_aspects/Status.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <sensor_msgs/JointState.h>
#include <string>

namespace parallel_aspects {
namespace {

using test::eventually;
using Request = CheckTrajectory::Request;
using Response = CheckTrajectory::Response;

class CheckService : public testing::Test {
 protected:
  static Response ask(const Request& request) {
    CheckTrajectory service;
    service.request = request;
    EXPECT_TRUE(ros::service::waitForService("/aspect_node/check_trajectory", ros::Duration(60.0)));
    EXPECT_TRUE(ros::service::call("/aspect_node/check_trajectory", service));
    return service.response;
  }

  JointVector joints(double x, double y) const { return inverse(robot_, Pose::planar(x, y), mode_).q; }

  // Straight from (4.5, 8), in a second each.
  Request through(const std::vector<JointVector>& values) const {
    Request request;
    request.trajectory.joint_names = {robot_.leg(1).actuated_joint, robot_.leg(0).actuated_joint};
    for (std::size_t i = 0; i < values.size(); ++i) {
      trajectory_msgs::JointTrajectoryPoint point;
      point.positions = {values[i][1], values[i][0]};
      point.time_from_start = ros::Duration(static_cast<double>(i));
      request.trajectory.points.push_back(point);
    }
    request.start.kind = Configuration::POSE;
    request.start.pose.pose.position.x = 4.5;
    request.start.pose.pose.position.y = 8.0;
    request.start.pose.pose.orientation.w = 1.0;
    return request;
  }

  Request along(const std::vector<std::pair<double, double>>& poses) const {
    Request request;
    for (const auto& [x, y] : poses) {
      geometry_msgs::PoseStamped pose;
      pose.pose.position.x = x;
      pose.pose.position.y = y;
      pose.pose.orientation.w = 1.0;
      request.poses.push_back(pose);
      request.times.push_back(static_cast<double>(request.times.size()));
    }
    request.start.kind = Configuration::JOINTS;
    request.start.working_mode = {-1, 1};
    return request;
  }

  const std::shared_ptr<const Mechanism> mechanism_ = test::five_bar_mechanism();
  const Manipulator& robot_ = *mechanism_->manipulator();
  const WorkingMode mode_ = *WorkingMode::from_signs({-1, 1});
};

TEST_F(CheckService, AnswersOfJointsAndOfPoses) {
  const Response joints_are = ask(through({joints(4.5, 8.0), joints(4.6, 8.0)}));
  EXPECT_EQ(joints_are.status.code, Status::OK) << joints_are.status.message;
  EXPECT_EQ(joints_are.answer, Response::YES) << joints_are.reason;
  EXPECT_EQ(joints_are.free_until, 1.0);
  EXPECT_EQ(joints_are.fastest.size(), 2U);
  EXPECT_GT(joints_are.least_parallel_index, 0.0);
  const Response poses_are = ask(along({{4.5, 8.0}, {4.6, 8.0}}));
  EXPECT_EQ(poses_are.answer, Response::YES) << poses_are.reason << poses_are.status.message;
  const Response far = ask(along({{4.5, 8.0}, {4.5, 30.0}}));
  EXPECT_EQ(far.answer, Response::NO) << far.reason;
  ASSERT_EQ(far.first_violation.size(), 1U);
  EXPECT_EQ(far.first_violation[0].kind, TrajectoryEvent::SERIAL_SINGULARITY);
  EXPECT_NE(far.first_violation[0].leg, "");
  EXPECT_EQ(far.crossings.size(), 1U);
  EXPECT_NE(far.not_followed, "");
}

TEST_F(CheckService, BadQuestionsAreRefusedWithASentence) {
  const auto code = [](const Request& request) {
    const Response response = ask(request);
    EXPECT_NE(response.status.message, "");
    return response.status.code;
  };
  const Request good = through({joints(4.5, 8.0), joints(4.6, 8.0)}), poses = along({{4.5, 8.0}, {4.6, 8.0}});
  EXPECT_EQ(code(Request()), Status::INVALID_REQUEST);
  Request bad = good;
  bad.poses = poses.poses;
  EXPECT_EQ(code(bad), Status::INVALID_REQUEST);
  bad = good;
  bad.trajectory.joint_names[0] = "shoulder";
  EXPECT_EQ(code(bad), Status::INVALID_REQUEST);
  bad = good;
  bad.trajectory.points[1].positions[0] = std::nan("");
  EXPECT_EQ(code(bad), Status::INVALID_REQUEST);
  bad = good;
  bad.trajectory.points[1].time_from_start = ros::Duration(0.0);
  EXPECT_EQ(code(bad), Status::INVALID_REQUEST);
  bad = good;
  bad.trajectory.points[0].positions.clear();
  EXPECT_EQ(code(bad), Status::INVALID_REQUEST);
  bad = good;
  bad.start.pose.pose.position.x = 4.9;
  EXPECT_EQ(code(bad), Status::INVALID_REQUEST);
  bad = poses;
  bad.times.pop_back();
  EXPECT_EQ(code(bad), Status::INVALID_REQUEST);
  bad = poses;
  bad.start.working_mode = {1};
  EXPECT_EQ(code(bad), Status::INVALID_REQUEST);
  bad = poses;
  bad.poses[0].header.frame_id = "nowhere";
  EXPECT_EQ(code(bad), Status::NO_TRANSFORM);
  bad = good;
  bad.start.kind = Configuration::NOW;  // nothing has been heard of the robot yet
  EXPECT_EQ(code(bad), Status::NO_JOINT_STATES);
}

TEST_F(CheckService, AnAmbiguousStartNamesFieldsThatWork) {
  Request request = through({joints(4.5, 8.0), joints(4.6, 8.0)});
  request.start = Configuration();
  request.start.kind = Configuration::JOINTS;
  const Response ambiguous = ask(request);
  EXPECT_EQ(ambiguous.status.code, Status::INVALID_REQUEST);
  EXPECT_NE(ambiguous.status.message.find("2 assembly modes; state which. Give start.kind 1"),
            std::string::npos)
      << ambiguous.status.message;
  EXPECT_NE(ambiguous.status.message.find("start.kind 2 with determinant_sign 1"), std::string::npos)
      << ambiguous.status.message;
  request.start.determinant_sign = 1;
  EXPECT_EQ(ask(request).answer, Response::YES);
}

TEST_F(CheckService, UnknownJointsAreNamed) {
  Request request = through({joints(4.5, 8.0), joints(4.6, 8.0)});
  request.trajectory.joint_names.emplace_back("gripper");
  for (auto& point : request.trajectory.points) point.positions.push_back(0.0);
  const Response response = ask(request);
  EXPECT_EQ(response.status.code, Status::INVALID_REQUEST);
  EXPECT_NE(
      response.status.message.find("unknown joint 'gripper'; there are 'crank_1_joint', 'crank_2_joint'"),
      std::string::npos)
      << response.status.message;
}

TEST_F(CheckService, MeasuresDistancesAtStatedPoints) {
  Request request = through({joints(4.5, 8.0), joints(4.6, 8.0)});
  EXPECT_TRUE(ask(request).distance_times.empty());
  request.distances = 5;
  const Response response = ask(request);
  ASSERT_EQ(response.distance_times.size(), 5U) << response.status.message;
  EXPECT_EQ(response.distance_times.front(), 0.0);
  EXPECT_EQ(response.distance_times.back(), 1.0);
  ASSERT_EQ(response.least_distances.size(), 3U);
  for (const double distance : response.parallel_distances) {
    EXPECT_GT(distance, 0.0);
    EXPECT_GE(distance, response.least_distances[0]);
  }
  request.distances = 1001;
  EXPECT_EQ(ask(request).status.code, Status::INVALID_REQUEST);
}

TEST_F(CheckService, StartsWhereTheRobotIs) {
  ros::NodeHandle nh;
  const ros::Publisher publisher = nh.advertise<sensor_msgs::JointState>("joint_states", 100);
  ASSERT_TRUE(eventually([&] { return publisher.getNumSubscribers() > 0; }));
  const JointVector here = joints(4.5, 8.0);
  Request request = through({here, joints(4.6, 8.0)});
  request.start = Configuration();
  Response response;
  const auto publish = [&] {
    sensor_msgs::JointState message;
    message.header.stamp = ros::Time::now();
    message.name = {robot_.leg(0).actuated_joint, robot_.leg(1).actuated_joint};
    message.position = {here[0], here[1]};
    publisher.publish(message);
  };
  SetAssemblyMode mode;
  mode.request.configuration.kind = Configuration::POSE;
  mode.request.configuration.pose.pose.position.x = 4.5;
  mode.request.configuration.pose.pose.position.y = 8.0;
  mode.request.configuration.pose.pose.orientation.w = 1.0;
  mode.request.configuration.working_mode = {-1, 1};
  ASSERT_TRUE(eventually([&] {
    publish();
    return ros::service::call("/aspect_node/set_assembly_mode", mode) &&
           mode.response.status.code == Status::OK;
  })) << mode.response.status.message;
  ASSERT_TRUE(eventually([&] {
    publish();
    response = ask(request);
    return response.status.code == Status::OK;
  })) << response.status.message;
  EXPECT_EQ(response.answer, Response::YES) << response.reason;
  publish();
  const Request other = through({joints(4.7, 8.0), joints(4.6, 8.0)});
  request.trajectory = other.trajectory;
  ASSERT_TRUE(eventually([&] {
    publish();
    response = ask(request);
    return response.status.code == Status::INVALID_REQUEST;
  })) << response.status.message;
  EXPECT_NE(response.status.message.find("does not start where the robot is"), std::string::npos)
      << response.status.message;
}

}  // namespace
}  // namespace parallel_aspects
