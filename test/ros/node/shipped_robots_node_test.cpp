// SPDX-License-Identifier: BSD-3-Clause
//
// Every shipped robot in the running node, moved by the demo's motion: it is followed without a wrong word,
// seen to move, drawn, and the node ends cleanly even while it computes a map.
#include "ros/messages/conversions.h"
#include "ros/node/process.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/GetCurrentAspect.h>
#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/ListAspects.h>
#include <parallel_aspects/MapProgress.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "support/robots/shipped.h"
#include <algorithm>
#include <map>
#include <mutex>
#include <sensor_msgs/JointState.h>
#include <set>
#include <string>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {
namespace {

constexpr double seconds_seen = 3.0;  // of the motion, by the stamps of its states

using test::eventually;
using test::Process;
using test::Recorder;

/// What one node says while it runs.
class Listener {
 public:
  explicit Listener(const std::string& node)
      : states_(on<AspectState>(node + "/state", [this](const auto& state) { add(state); })),
        transitions_(on<AspectTransition>(
            node + "/transitions", [this](const auto& transition) { reported_.push_back(transition); })),
        joints_(on<sensor_msgs::JointState>(node + "/joint_states",
                                            [this](const auto& joints) { joint_states_.push_back(joints); })),
        markers_(on<visualization_msgs::MarkerArray>(
            node + "/position_markers", [this](const auto& array) { drawn_ = array.markers.size(); })) {}

  double seconds_followed() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return known_.empty() ? 0.0 : (known_.back().header.stamp - known_.front().header.stamp).toSec();
  }
  std::vector<AspectState> known() const { return copy(known_); }
  std::vector<AspectState> unknown() const { return copy(unknown_); }
  std::vector<AspectTransition> told() const { return copy(reported_); }
  std::vector<sensor_msgs::JointState> joint_states() const { return copy(joint_states_); }
  std::size_t drawn() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return drawn_;
  }

 private:
  template <typename Message, typename Callback>
  ros::Subscriber on(const std::string& topic, Callback callback) {
    return ros::NodeHandle().subscribe<Message>(topic, 10000, [this, callback](const auto& message) {
      const std::lock_guard<std::mutex> lock(mutex_);
      callback(*message);
    });
  }

  template <typename Message>
  std::vector<Message> copy(const std::vector<Message>& messages) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages;
  }

  void add(const AspectState& state) {
    if (state.status.code == Status::OK)
      known_.push_back(state);
    else if (!known_.empty())
      unknown_.push_back(state);
  }

  mutable std::mutex mutex_;
  std::vector<AspectState> known_, unknown_;  // the latter only since the first known one
  std::vector<AspectTransition> reported_;
  std::vector<sensor_msgs::JointState> joint_states_;
  std::size_t drawn_ = 0;
  ros::Subscriber states_, transitions_, joints_, markers_;
};

class ShippedRobot : public testing::TestWithParam<const char*> {};

double farthest(const std::vector<AspectState>& states) {
  const auto position = [](const AspectState& state) {
    return Eigen::Vector3d(state.pose.position.x, state.pose.position.y, state.pose.position.z);
  };
  const auto orientation = [](const AspectState& state) {
    const auto& q = state.pose.orientation;
    return Eigen::Quaterniond(q.w, q.x, q.y, q.z);
  };
  double most = 0.0;
  for (const AspectState& state : states)
    most = std::max({most, (position(state) - position(states.front())).norm(),
                     orientation(state).angularDistance(orientation(states.front()))});
  return most;
}

// With six degrees of freedom the services tell what is proved without a map.
void expect_answers_of_a_roadmap(const std::string& node) {
  ListAspects list;
  ASSERT_TRUE(eventually(
      [&] { return ros::service::call(node + "/list_aspects", list) && !list.response.roadmap.empty(); }));
  EXPECT_EQ(list.response.status.code, Status::NO_MAP);
  EXPECT_TRUE(list.response.aspects.empty());
  EXPECT_EQ(list.response.proved_count, list.response.roadmap.size()) << "one for each side";
  const Recorder<MapProgress> progress(node + "/map_progress");
  ASSERT_TRUE(eventually([&] { return progress.last() && progress.last()->state == MapProgress::COMPLETE; }));
  EXPECT_EQ(progress.last()->proved_count, list.response.proved_count);

  GetCurrentAspect current;
  ASSERT_TRUE(ros::service::call(node + "/get_current_aspect", current));
  EXPECT_EQ(current.response.status.code, Status::NO_MAP) << current.response.status.message;
  EXPECT_EQ(current.response.proved_count, list.response.proved_count);
  ASSERT_EQ(current.response.solutions.size(), 1U);
  const SolvedConfiguration& solution = current.response.solutions.front();
  EXPECT_EQ(solution.aspect_status, SolvedConfiguration::NO_MAP);
  EXPECT_GT(solution.roadmap_component, 0U);
  EXPECT_NE(solution.determinant_sign, 0);
  list.request.at_configuration = true;
  ASSERT_TRUE(ros::service::call(node + "/list_aspects", list));
  ASSERT_EQ(list.response.roadmap.size(), 1U);
  EXPECT_EQ(list.response.roadmap.front().determinant_sign, solution.determinant_sign);
}

TEST_P(ShippedRobot, IsFollowedAndDrawnAndEndsCleanly) {
  const std::string name_space = std::string("/") + GetParam(), node = name_space + "/aspect_node";
  const auto mechanism = test::shipped(GetParam());
  Process server(PARALLEL_ASPECTS_NODE, name_space, {"_joint_states_timeout:=2.0"});  // a busy computer
  Process motion(PARALLEL_ASPECTS_DEMO_MOTION, name_space, {"_patience:=0.0", "_local_duration:=10.0"});
  const Listener listener(node);
  ASSERT_TRUE(eventually([&] { return listener.seconds_followed() > seconds_seen || server.has_ended(); }));
  ASSERT_FALSE(server.has_ended());
  EXPECT_TRUE(eventually([&] { return listener.drawn() > 1; }));

  // One working mode and sign of det A, at most one aspect, nothing lost.
  const auto states = listener.known();
  EXPECT_TRUE(listener.unknown().empty()) << listener.unknown().front().status.message;
  std::set<std::uint32_t> aspects;
  for (const AspectState& state : states) {
    ASSERT_EQ(state.working_mode, states.front().working_mode);
    ASSERT_EQ(state.determinant_sign, states.front().determinant_sign);
    ASSERT_EQ(state.working_mode.size(), mechanism->manipulator()->leg_count());
    if (state.aspect != 0) aspects.insert(state.aspect);
  }
  EXPECT_LE(aspects.size(), 1U);
  for (const AspectTransition& transition : listener.told())
    EXPECT_EQ(transition.kind, AspectTransition::ASPECT) << transition.message;
  EXPECT_GT(farthest(states), 0.003 * std::min(1.0, mechanism->manipulator()->size()));

  ASSERT_FALSE(listener.joint_states().empty());
  const auto completed = listener.joint_states().back();
  EXPECT_EQ(completed.name, mechanism->joint_names());
  EXPECT_TRUE(std::all_of(completed.position.begin(), completed.position.end(),
                          [](double value) { return std::isfinite(value); }));

  GetSingularityDistance distance;
  ASSERT_TRUE(ros::service::call(node + "/get_singularity_distance", distance));
  ASSERT_EQ(distance.response.reports.size(), 1U) << distance.response.status.message;
  EXPECT_GT(distance.response.reports[0].smallest_singular_value, 0.0);
  if (std::string(GetParam()) == "stewart") expect_answers_of_a_roadmap(node);

  EXPECT_EQ(motion.end(), 0);
  EXPECT_EQ(server.end(), 0);
}

INSTANTIATE_TEST_SUITE_P(Node, ShippedRobot,
                         testing::Values("five_bar", "bipod", "three_rrr", "three_rpr", "three_prr", "delta",
                                         "linear_delta", "hexa", "stewart", "six_pus", "agile_eye",
                                         "spherical_3rrr"),
                         [](const auto& robot) { return std::string(robot.param); });

}  // namespace
}  // namespace parallel_aspects
