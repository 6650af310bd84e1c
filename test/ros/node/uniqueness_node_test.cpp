// SPDX-License-Identifier: BSD-3-Clause
//
// Uniqueness domains in the running node: the shipped 3-RPR on the way around two cusps, and around none.
#include "ros/monitor/cusp_motion.h"
#include "ros/node/node_client.h"
#include "ros/node/process.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/Reload.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "support/shipped.h"
#include <algorithm>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <functional>
#include <memory>
#include <sensor_msgs/JointState.h>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::eventually;
using test::Recorder;

class UniquenessOfNode : public testing::Test {
 protected:
  UniquenessOfNode() {
    EXPECT_TRUE(eventually([this] {
      return joints_.getNumSubscribers() > 0 && states_.connected() && transitions_.connected();
    }));
    MapOptions options;
    options.slice = slice_;
    map_ = compute_aspect_map(robot_, options).map;
  }

  /// The state at the next sample.
  AspectState play(const JointVector& q) {
    ros::Time stamp = ros::Time::now();
    if (stamp <= last_) stamp = last_ + ros::Duration(1e-6);
    last_ = stamp;
    joints_.publish(test::joint_states_of(*robot_, q, stamp));
    return states_.answer(stamp);
  }

  void play(const std::vector<JointVector>& values) {
    for (const JointVector& q : values) ASSERT_EQ(play(q).status.code, Status::OK);
  }

  /// Waits there until the state says it.
  bool rests_until(const JointVector& q, const std::function<bool(const UniquenessState&)>& says) {
    return eventually([&] { return says(play(q).uniqueness); });
  }

  bool is_ready() {
    return rests_until(test::values_with_six_solutions(), [](const UniquenessState& state) {
      return state.known == UniquenessState::REGIONS && state.basic_region != 0;
    });
  }

  /// That the robot is at this one of the six solutions, where it has been since the last motion or not.
  std::uint32_t start_at(std::size_t solution) {
    const Pose pose = test::pose_with_six_solutions(*robot_, *map_, solution);
    play(test::values_with_six_solutions());
    SetAssemblyMode::Request request;
    request.configuration = test::at_pose(pose.position.x(), pose.position.y(), "");
    request.configuration.pose.pose.orientation.z = pose.orientation.z();
    request.configuration.pose.pose.orientation.w = pose.orientation.w();
    const auto response = test::call<SetAssemblyMode>("set_assembly_mode", request);
    EXPECT_EQ(response.status.code, Status::OK) << response.status.message;
    std::uint32_t region = 0;
    EXPECT_TRUE(rests_until(test::values_with_six_solutions(), [&](const UniquenessState& state) {
      region = state.basic_region;
      return region != 0 && state.reference_region == region && !state.warns;
    }));
    return region;
  }

  std::vector<JointVector> around(std::size_t cusp, std::size_t solution) {
    CuspPlanner planner(map_, find_cusps(*robot_, slice_).cusps);
    const PlannedPath path =
        planner.plan({test::pose_with_six_solutions(*robot_, *map_, solution), {}}, cusp);
    EXPECT_TRUE(path) << path.message;
    return test::values_along(*robot_, planner, path, 200);
  }

  std::vector<AspectTransition> told(std::size_t from) const {
    const auto all = transitions_.all();
    return {all.begin() + static_cast<std::ptrdiff_t>(from), all.end()};
  }

  bool is_told(std::size_t from, const std::function<bool(const AspectTransition&)>& fits) const {
    return eventually([&] { return transitions_.first(fits, from).has_value(); });
  }

  void warns_around(std::size_t cusp, std::size_t solution);

  const std::shared_ptr<const Manipulator> robot_ = test::shipped("three_rpr")->mapped_manipulator();
  const MapSlice slice_ = test::slice_of(robot_, {{robot_->leg(0).actuated_joint, 14.98}});
  std::shared_ptr<const AspectMap> map_;
  ros::Publisher joints_ = ros::NodeHandle().advertise<sensor_msgs::JointState>("joint_states", 1000);
  Recorder<AspectState> states_{"/aspect_node/state"};
  Recorder<AspectTransition> transitions_{"/aspect_node/transitions"};
  ros::Time last_;
};

bool begins(const AspectTransition& told) {
  return told.kind == AspectTransition::UNIQUENESS && !told.domain_shared;
}

bool ends(const AspectTransition& told) {
  return told.kind == AspectTransition::UNIQUENESS && told.domain_shared;
}

bool is_of_assembly_mode(const AspectTransition& told) {
  return told.kind == AspectTransition::ASSEMBLY_MODE;
}

// There and back.
void UniquenessOfNode::warns_around(std::size_t cusp, std::size_t solution) {
  const std::uint32_t reference = start_at(solution);
  const std::size_t before = transitions_.all().size();
  std::vector<JointVector> way = around(cusp, solution);
  play(way);
  UniquenessState there;
  EXPECT_TRUE(rests_until(way.back(), [&](const UniquenessState& state) {
    there = state;
    return state.warns && state.sharing == UniquenessState::APART;
  }));
  EXPECT_EQ(there.reference_region, reference);
  EXPECT_NE(there.basic_region, reference);
  EXPECT_FALSE(there.domains.empty());
  EXPECT_TRUE(is_told(before, begins));
  EXPECT_TRUE(is_told(before, is_of_assembly_mode)) << "detected by the tracker";
  const AspectState state = play(way.back());
  EXPECT_EQ(state.level, AspectState::WARN);
  EXPECT_NE(state.reason.find("uniqueness domain"), std::string::npos) << state.reason;
  const Recorder<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  EXPECT_TRUE(eventually([&] {
    play(way.back());
    return diagnostics
        .first([](const auto& array) {
          return array.status[0].level == diagnostic_msgs::DiagnosticStatus::WARN &&
                 array.status[0].message.find("do not tell the pose") != std::string::npos;
        })
        .has_value();
  }));
  const std::size_t half_way = transitions_.all().size();
  std::reverse(way.begin(), way.end());
  play(way);
  EXPECT_TRUE(rests_until(
      way.back(), [&](const UniquenessState& at) { return !at.warns && at.basic_region == reference; }));
  EXPECT_TRUE(is_told(half_way, ends));
}

TEST_F(UniquenessOfNode, WarnsAroundTwoCuspsAndNotBackAtTheStart) {
  ASSERT_TRUE(is_ready());
  warns_around(1, 4);
  warns_around(0, 1);
}

TEST_F(UniquenessOfNode, SaysNothingAroundNoCusp) {
  ASSERT_TRUE(is_ready());
  for (std::size_t solution = 0; solution < 6; ++solution) {
    const std::uint32_t region = start_at(solution);
    const std::size_t before = transitions_.all().size();
    const geometry_msgs::Pose pose = play(test::values_with_six_solutions()).pose;
    play(test::values_on_circle(200));
    const AspectState state = play(test::values_with_six_solutions());
    EXPECT_NEAR(state.pose.position.x, pose.position.x, 1e-6);
    EXPECT_NEAR(state.pose.position.y, pose.position.y, 1e-6);
    EXPECT_TRUE(rests_until(test::values_with_six_solutions(), [&](const UniquenessState& at) {
      return at.stamp >= state.header.stamp && at.basic_region == region && !at.warns;
    }));
    for (const AspectTransition& each : told(before)) EXPECT_EQ(each.kind, AspectTransition::ASPECT);
  }
}

// What was known begins anew with the robot.
TEST_F(UniquenessOfNode, BeginsAnewWithAReload) {
  ASSERT_TRUE(is_ready());
  start_at(1);
  play(around(0, 1));
  EXPECT_EQ(test::call<Reload>("reload", {}).status.code, Status::OK);
  ASSERT_TRUE(eventually([this] { return joints_.getNumSubscribers() > 0 && states_.connected(); }));
  EXPECT_TRUE(is_ready());
  const UniquenessState state = play(test::values_with_six_solutions()).uniqueness;
  EXPECT_FALSE(state.warns);
  EXPECT_EQ(state.reference_region, state.basic_region);
}

// Neither a reload nor the end waits for what takes minutes.
TEST(UniquenessOfNodes, CanEndAndReloadWhileTheyAreComputed) {
  const std::string node = "/long/aspect_node";
  for (const char* parameter : {"mechanism", "start", "motion"}) {
    XmlRpc::XmlRpcValue value;
    ASSERT_TRUE(ros::param::get(std::string("/aspect_node/") + parameter, value));
    ros::param::set(node + "/" + parameter, value);
  }
  ros::param::set(node + "/uniqueness/enabled", true);
  ros::param::set(node + "/uniqueness/most_cells", 100000000);
  ros::param::set(node + "/frame_prefix", "long");
  test::Process process(PARALLEL_ASPECTS_NODE, "/long");
  const Recorder<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  const auto is_computing = [&](std::size_t from) {
    return eventually([&] {
      return diagnostics
          .first(
              [](const diagnostic_msgs::DiagnosticArray& array) {
                return std::any_of(array.status.begin(), array.status.end(), [](const auto& status) {
                  return std::any_of(status.values.begin(), status.values.end(), [](const auto& value) {
                    return value.value.rfind("They are being computed", 0) == 0;
                  });
                });
              },
              from)
          .has_value();
    });
  };
  ASSERT_TRUE(is_computing(0));
  EXPECT_EQ(test::call<Reload>(node + "/reload", {}).status.code, Status::OK);
  EXPECT_TRUE(is_computing(diagnostics.all().size()));
  EXPECT_EQ(process.end(), 0);
}

}  // namespace
}  // namespace parallel_aspects
