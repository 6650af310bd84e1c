// SPDX-License-Identifier: BSD-3-Clause
//
// The running node, through its topics, services, action and tf. Tests run in the order in which they are
// written; each waits for what it needs, up to a deadline.
#include "motion/demo_rounds.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/ComputeMapAction.h>
#include <parallel_aspects/GetCurrentAspect.h>
#include <parallel_aspects/GetJacobian.h>
#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/GetWorkingMode.h>
#include <parallel_aspects/ListAspects.h>
#include <parallel_aspects/MapProgress.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include <actionlib/client/simple_action_client.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <limits>
#include <string>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {
namespace {

using test::ask;
using test::at_pose;
using test::call;
using test::deadline;
using test::eventually;
using test::Recorder;

class AspectNode : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    publisher_ = ros::NodeHandle().advertise<sensor_msgs::JointState>("joint_states", 10000);
    const Recorder<MapProgress> progress("/aspect_node/map_progress");
    ASSERT_TRUE(
        eventually([&] { return progress.last() && progress.last()->state == MapProgress::COMPLETE; }));
    ASSERT_TRUE(eventually([] { return publisher_.getNumSubscribers() >= 2; }));
  }
  static void TearDownTestSuite() { publisher_.shutdown(); }

  // Publishes joint values, stamped now.
  static void publish(const JointVector& q) {
    sensor_msgs::JointState message;
    message.header.stamp = last_stamp_ = ros::Time::now();
    message.name = {"crank_2_joint", "crank_1_joint"};  // not in the order of the legs
    message.position = {q[1], q[0]};
    publisher_.publish(message);
    ros::WallDuration(0.001).sleep();  // so that stamps differ
  }

  static ros::Publisher publisher_;
  static ros::Time last_stamp_;
  const std::shared_ptr<const Mechanism> mechanism_ = test::five_bar_mechanism();
  const Manipulator& robot_ = *mechanism_->manipulator();
};

ros::Publisher AspectNode::publisher_;
ros::Time AspectNode::last_stamp_;

TEST_F(AspectNode, SaysThatItKnowsNothingWithoutJointStates) {
  const Recorder<AspectState> state("/aspect_node/state");
  ASSERT_TRUE(eventually([&] { return state.last().has_value(); }));
  EXPECT_EQ(state.last()->status.code, Status::NO_JOINT_STATES);
  EXPECT_EQ(ask<GetWorkingMode>("get_working_mode", Configuration()).status.code, Status::NO_JOINT_STATES);
  EXPECT_EQ(ask<GetCurrentAspect>("get_current_aspect", Configuration()).status.code,
            Status::NO_JOINT_STATES);
}

TEST_F(AspectNode, ListsTenAspects) {
  const auto response = call<ListAspects>("list_aspects", {});
  EXPECT_EQ(response.status.code, Status::OK) << response.status.message;
  ASSERT_EQ(response.aspects.size(), 10U);
  EXPECT_EQ(response.proved_count, 10U);
  EXPECT_EQ(response.count_at_most, 10);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(response.aspects[i].id, i + 1);
  EXPECT_EQ(response.aspects.front().unit, "m^2");
}

TEST_F(AspectNode, ALateSubscriberSeesTheMarkers) {
  const Recorder<visualization_msgs::MarkerArray> markers("/aspect_node/markers");
  ASSERT_TRUE(eventually([&] { return markers.last().has_value(); }));
  const auto array = *markers.last();
  EXPECT_EQ(std::count_if(array.markers.begin(), array.markers.end(),
                          [](const auto& marker) { return marker.ns == "workspace/aspects"; }),
            10);
  tf2_ros::Buffer tf;
  const tf2_ros::TransformListener listener(tf);
  for (const char* frame : {"five_bar/aspects", "five_bar/joint_space"})
    EXPECT_TRUE(eventually([&] { return tf.canTransform("base_link", frame, ros::Time(0)); })) << frame;
}

TEST_F(AspectNode, AnswersAboutAPoseInEveryWorkingMode) {
  const auto modes = ask<GetWorkingMode>("get_working_mode", at_pose(4.5, 8.0, ""));
  EXPECT_EQ(modes.status.code, Status::OK);
  EXPECT_EQ(modes.solutions.size(), 4U);
  const auto aspects = ask<GetCurrentAspect>("get_current_aspect", at_pose(4.5, 8.0, "base_link", {1, -1}));
  ASSERT_EQ(aspects.solutions.size(), 1U);
  EXPECT_EQ(aspects.solutions[0].aspect_status, SolvedConfiguration::INSIDE);
  EXPECT_EQ(aspects.solutions[0].working_mode, (std::vector<std::int8_t>{1, -1}));
  const auto distance =
      ask<GetSingularityDistance>("get_singularity_distance", at_pose(4.5, 8.0, "", {1, 1}));
  ASSERT_EQ(distance.reports.size(), 1U);
  EXPECT_EQ(distance.reports[0].determinant_unit, "m^2");
  EXPECT_EQ(distance.reports[0].inverse_diagonal.size(), 2U);
  EXPECT_GT(distance.reports[0].inverse_diagonal[0], 0.0);
  EXPECT_GT(distance.reports[0].smallest_singular_value, 0.0);
  ASSERT_EQ(distance.reports[0].leg_angles.size(), 2U);
  EXPECT_GT(distance.reports[0].leg_angles[0], 0.0);
  EXPECT_LE(distance.reports[0].leg_angles[0], EIGEN_PI / 2);
  const auto jacobian = ask<GetJacobian>("get_jacobian", at_pose(4.5, 8.0, "", {1, 1}));
  ASSERT_EQ(jacobian.jacobians.size(), 1U);
  EXPECT_EQ(jacobian.jacobians[0].status, Jacobian::REGULAR);
  EXPECT_EQ(jacobian.jacobians[0].jacobian.size(), 4U);

  // Distances of the paper's five-bar by brute force.
  Configuration joint_values;
  joint_values.kind = Configuration::JOINTS;
  joint_values.joint_names = {"crank_1_joint", "crank_2_joint"};
  joint_values.joint_positions = {1.633334, 1.027907};
  auto near = ask<GetSingularityDistance>("get_singularity_distance", joint_values);
  ASSERT_EQ(near.reports.size(), 2U);
  if (near.reports[0].configuration.pose.position.y < 7.9) near.reports.erase(near.reports.begin());
  ASSERT_NEAR(near.reports[0].configuration.pose.position.y, 8.0, 1e-4);
  const MetricDistance& parallel = near.reports[0].parallel_distance;
  EXPECT_EQ(parallel.status, MetricDistance::TIGHT);
  EXPECT_LE(parallel.lower, 1.5360);
  EXPECT_GE(parallel.upper, 1.5358);
  EXPECT_NEAR(parallel.witness.position.x, 4.218, 0.05);
  EXPECT_NEAR(parallel.witness.position.y, 6.490, 0.05);
  EXPECT_EQ(parallel.joint_positions.size(), 2U);
  EXPECT_TRUE(parallel.leg.empty());
  EXPECT_NEAR(near.reports[0].serial_distance.upper, 3.82122, 0.04);
  EXPECT_FALSE(near.reports[0].serial_distance.leg.empty());
  EXPECT_EQ(near.reports[0].limit_distance.status, MetricDistance::ABSENT);
}

TEST_F(AspectNode, TakesPosesInAnyFrameOfTf) {
  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped table;
  table.header.frame_id = "base_link";
  table.child_frame_id = "table";
  table.transform.translation.x = 4.5;
  table.transform.rotation.z = std::sqrt(0.5);  // a quarter of a turn
  table.transform.rotation.w = std::sqrt(0.5);
  broadcaster.sendTransform(table);
  GetWorkingMode::Response response;
  ASSERT_TRUE(eventually([&] {
    response = ask<GetWorkingMode>("get_working_mode", at_pose(8.0, 0.0, "table"));
    return response.status.code == Status::OK;
  })) << response.status.message;
  EXPECT_NEAR(response.solutions[0].pose.position.x, 4.5, 1e-9);
  EXPECT_NEAR(response.solutions[0].pose.position.y, 8.0, 1e-9);
}

TEST_F(AspectNode, RefusesQuestionsThatMakeNoSense) {
  EXPECT_EQ(ask<GetWorkingMode>("get_working_mode", at_pose(4.5, 8.0, "nowhere")).status.code,
            Status::NO_TRANSFORM);
  const auto misspelt_frame = ask<GetWorkingMode>("get_working_mode", at_pose(4.5, 8.0, "base_lnk"));
  EXPECT_NE(misspelt_frame.status.message.find("did you mean 'base_link'?"), std::string::npos)
      << misspelt_frame.status.message;
  EXPECT_EQ(ask<GetWorkingMode>("get_working_mode", at_pose(40.0, 8.0, "")).status.code, Status::NO_SOLUTION);
  EXPECT_EQ(ask<GetWorkingMode>("get_working_mode", at_pose(4.5, 8.0, "", {1, 0})).status.code,
            Status::INVALID_REQUEST);
  EXPECT_EQ(ask<GetWorkingMode>("get_working_mode", at_pose(4.5, std::nan(""), "")).status.code,
            Status::INVALID_REQUEST);
  const auto far = ask<GetWorkingMode>("get_working_mode", at_pose(4.5, 8.0, std::string(100000, 'x')));
  EXPECT_EQ(far.status.code, Status::NO_TRANSFORM);
  EXPECT_LT(far.status.message.size(), 1000U);
  Configuration misspelt;
  misspelt.kind = Configuration::JOINTS;
  misspelt.joint_names = {"crank_1_joint", "crank2_joint"};
  misspelt.joint_positions = {1.0, 1.0};
  const std::string guess = ask<GetWorkingMode>("get_working_mode", misspelt).status.message;
  EXPECT_NE(guess.find("Did you mean crank_2_joint by crank2_joint?"), std::string::npos) << guess;
  Configuration unknown_kind;
  unknown_kind.kind = 9;
  EXPECT_EQ(ask<GetWorkingMode>("get_working_mode", unknown_kind).status.code, Status::INVALID_REQUEST);
}

TEST_F(AspectNode, AnswersAboutJointValuesInEveryAssemblyMode) {
  Configuration configuration;
  configuration.kind = Configuration::JOINTS;
  configuration.joint_names = {"crank_2_joint", "crank_1_joint"};
  configuration.joint_positions = {3.138465, 1.633334};
  EXPECT_EQ(ask<GetCurrentAspect>("get_current_aspect", configuration).solutions.size(), 2U);
  configuration.determinant_sign = 1;
  const auto one = ask<GetCurrentAspect>("get_current_aspect", configuration);
  ASSERT_EQ(one.solutions.size(), 1U);
  EXPECT_EQ(one.solutions[0].determinant_sign, 1);
  configuration.joint_names = {"crank_1_joint", "crank_1_joint"};
  EXPECT_EQ(ask<GetCurrentAspect>("get_current_aspect", configuration).status.code, Status::INVALID_REQUEST);
}

// The actuated joints run along a tour of the aspects; the node must tell the same tour, with no det A
// crossed.
TEST_F(AspectNode, ReportsEveryTransitionOfATour) {
  const Recorder<AspectState> state("/aspect_node/state");
  const Recorder<AspectTransition> transitions("/aspect_node/transitions");
  const Recorder<sensor_msgs::JointState> completed("/aspect_node/joint_states");
  ASSERT_TRUE(
      eventually([&] { return transitions.connected() && state.connected() && completed.connected(); }));
  const auto map = compute_aspect_map(mechanism_->manipulator()).map;
  const Tour tour = plan_tour(*map, test::pose_at(4.5, 8.0), *WorkingMode::from_signs({1, -1}));
  ASSERT_GE(tour.aspects.size(), 5U);

  publish(tour.joint_values.front());
  for (std::size_t i = 1; i < tour.joint_values.size(); ++i) {
    const JointVector change = tour.joint_values[i] - tour.joint_values[i - 1];
    const int steps = 1 + static_cast<int>(change.norm() / 0.02);
    for (int step = 1; step <= steps; ++step) publish(tour.joint_values[i - 1] + change * step / steps);
  }

  const auto told = [&] {
    std::vector<int> aspects;
    for (const AspectTransition& transition : transitions.all())
      if (transition.aspect_after != 0) aspects.push_back(static_cast<int>(transition.aspect_after));
    return aspects;
  };
  EXPECT_TRUE(eventually([&] { return told() == tour.aspects; }))
      << testing::PrintToString(told()) << " instead of " << testing::PrintToString(tour.aspects);
  for (const AspectTransition& transition : transitions.all()) {
    EXPECT_FALSE(transition.message.empty());
    EXPECT_NE(transition.kind, AspectTransition::LOST);
    EXPECT_FALSE(transition.kind == AspectTransition::WORKING_MODE && transition.determinant_crossed);
  }
  // Who comes later hears the last one, and none of those that are counted.
  const Recorder<AspectTransition> last("/aspect_node/last_transition");
  const Recorder<AspectTransition> late("/aspect_node/transitions");
  EXPECT_TRUE(eventually([&] { return last.last().has_value() && late.connected(); }));
  EXPECT_EQ(last.last()->message, transitions.last()->message);
  EXPECT_TRUE(late.all().empty());
  const AspectState end = state.answer(last_stamp_);
  EXPECT_EQ(end.status.code, Status::OK) << end.status.message;
  EXPECT_NEAR(end.pose.position.y, 8.0, 1e-6);
  EXPECT_EQ(completed.answer(last_stamp_).name, mechanism_->joint_names());
}

TEST_F(AspectNode, SendsThePlatformToTf) {
  tf2_ros::Buffer tf;
  const tf2_ros::TransformListener listener(tf);
  JointVector q = inverse(robot_, test::pose_at(4.5, 8.0), *WorkingMode::from_signs({1, -1})).q;
  ASSERT_TRUE(eventually([&] {
    publish(q);
    return tf.canTransform("base_link", "five_bar/platform", ros::Time(0));
  }));
  EXPECT_NEAR(tf.lookupTransform("base_link", "five_bar/platform", ros::Time(0)).transform.translation.y, 8.0,
              1e-6);
}

// The nodelet beside it has the same robot, and so the same names of frames.
TEST_F(AspectNode, SaysThatTwoNodesPublishTheSameFrame) {
  const Recorder<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  const auto says_so = [](const diagnostic_msgs::DiagnosticArray& array) {
    return std::any_of(array.status.begin(), array.status.end(), [](const auto& status) {
      return status.name == "aspect_node: tf" && status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
             status.message.find("such as five_bar/") != std::string::npos;
    });
  };
  EXPECT_TRUE(eventually([&] { return diagnostics.first(says_so).has_value(); }));
}

TEST_F(AspectNode, BecomesStale) {
  const Recorder<AspectState> state("/aspect_node/state");
  EXPECT_TRUE(eventually([&] { return state.last() && state.last()->status.code == Status::STALE; }));
  EXPECT_EQ(ask<GetCurrentAspect>("get_current_aspect", Configuration()).status.code, Status::STALE);
}

TEST_F(AspectNode, AcceptsTheAssemblyModeThatIsStated) {
  const JointVector q = inverse(robot_, test::pose_at(4.5, 8.0), *WorkingMode::from_signs({1, -1})).q;
  Configuration sign;
  SetAssemblyMode::Response response;
  for (const int wanted : {1, -1}) {
    sign.determinant_sign = static_cast<std::int8_t>(wanted);
    ASSERT_TRUE(eventually([&] {
      publish(q);
      response = ask<SetAssemblyMode>("set_assembly_mode", sign);
      return response.status.code == Status::OK;
    })) << response.status.message;
    ASSERT_EQ(response.solutions.size(), 1U);
    EXPECT_EQ(response.solutions[0].determinant_sign, wanted);
  }
  sign.determinant_sign = 0;
  EXPECT_EQ(ask<SetAssemblyMode>("set_assembly_mode", sign).status.code, Status::INVALID_REQUEST);
  ASSERT_TRUE(eventually([&] {
    publish(q);
    response = ask<SetAssemblyMode>("set_assembly_mode", at_pose(4.5, 8.0, ""));
    return response.status.code == Status::OK;
  })) << response.status.message;
  EXPECT_NEAR(response.solutions[0].pose.position.y, 8.0, 1e-6);
  publish(q);
  EXPECT_EQ(ask<SetAssemblyMode>("set_assembly_mode", at_pose(4.5, -8.0, "")).status.code,
            Status::NO_SOLUTION);
}

TEST_F(AspectNode, SurvivesBadJointStatesAndSaysSo) {
  const Recorder<AspectState> state("/aspect_node/state");
  ASSERT_TRUE(eventually([&] { return state.last().has_value(); }));
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<sensor_msgs::JointState> bad(5);
  for (auto& message : bad) message.name = {"crank_1_joint", "crank_2_joint"};
  bad[0].position = {std::nan(""), 1.0};
  bad[1].position = {infinity, 1.0};
  bad[2].position = {1.0};
  bad[3].name = {"crank_1_joint", "crank_2_joint", "crank_2_joint"};
  bad[3].position = {1.0, 1.0, 1.0};
  bad[4].name.clear();
  for (auto& message : bad) {
    message.header.stamp = ros::Time::now();
    publisher_.publish(message);
    const AspectState answer = state.answer(message.header.stamp);
    EXPECT_EQ(answer.status.code, Status::INVALID_JOINT_STATES) << message;
    EXPECT_FALSE(answer.status.message.empty());
    EXPECT_EQ(answer.aspect, 0U);
    EXPECT_TRUE(answer.working_mode.empty());
  }
}

TEST_F(AspectNode, ComputesAMapAsAnActionThatCanBeCancelled) {
  actionlib::SimpleActionClient<ComputeMapAction> client("/aspect_node/compute_map", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(deadline)));
  ComputeMapGoal goal;
  goal.resolution = 1e-4;  // far more than there is time for
  std::atomic<int> reports{0};
  client.sendGoal(goal, {}, {}, [&](const ComputeMapFeedbackConstPtr&) { ++reports; });
  ASSERT_TRUE(eventually([&] { return reports > 0; }));
  EXPECT_EQ(call<ListAspects>("list_aspects", {}).aspects.size(), 10U) << "answered from the map before";
  client.cancelGoal();
  ASSERT_TRUE(client.waitForResult(ros::Duration(deadline)));
  EXPECT_EQ(client.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
  EXPECT_EQ(client.getResult()->status.code, Status::CANCELLED);

  goal.resolution = 0.2;
  client.sendGoalAndWait(goal, ros::Duration(deadline));
  EXPECT_EQ(client.getState(), actionlib::SimpleClientGoalState::SUCCEEDED);
  EXPECT_EQ(client.getResult()->aspects.size(), 10U);
  EXPECT_EQ(client.getResult()->status.code, Status::OK);

  goal.resolution = std::nan("");
  client.sendGoalAndWait(goal, ros::Duration(deadline));
  EXPECT_EQ(client.getState(), actionlib::SimpleClientGoalState::ABORTED);
  EXPECT_EQ(client.getResult()->status.code, Status::INVALID_REQUEST);
}

TEST_F(AspectNode, TheNodeletServesTheSame) {
  const std::string service = "/aspect_nodelet/list_aspects";
  const std::string manager_service = "/parallel_aspects_AspectNodelet/list_aspects";
  const std::string found =
      ros::service::waitForService(service, ros::Duration(10.0)) ? service : manager_service;
  ListAspects::Response response;
  EXPECT_TRUE(eventually([&] {
    response = call<ListAspects>(found, {});
    return response.status.code == Status::OK;
  })) << response.status.message;
  EXPECT_EQ(response.aspects.size(), 10U);
}

}  // namespace
}  // namespace parallel_aspects
