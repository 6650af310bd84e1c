// SPDX-License-Identifier: BSD-3-Clause
//
// Uniqueness domains in the running node: the shipped 3-RPR on the way around two cusps, and around none.
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"
#include "ros/monitor/cusp_motion.h"
#include "ros/node/node_client.h"
#include "ros/node/process.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/PlanPathAction.h>
#include <parallel_aspects/Reload.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <ros/serialization.h>

#include "support/robots/shipped.h"
#include <actionlib/client/simple_action_client.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <functional>
#include <memory>
#include <sensor_msgs/JointState.h>
#include <set>
#include <string>
#include <trajectory_msgs/JointTrajectory.h>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {
namespace {

using test::eventually;
using test::Recorder;

using Client = actionlib::SimpleActionClient<PlanPathAction>;

JointVector vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Configuration at(const Pose& pose) {
  Configuration configuration = test::at_pose(pose.position.x(), pose.position.y(), "");
  configuration.pose.pose.orientation.z = pose.orientation.z();
  configuration.pose.pose.orientation.w = pose.orientation.w();
  return configuration;
}

/// Actuated values along a trajectory whose joints run as cubics, at even times.
std::vector<JointVector> values_of(const trajectory_msgs::JointTrajectory& trajectory, int steps) {
  const auto& points = trajectory.points;
  const double end = points.back().time_from_start.toSec();
  std::vector<JointVector> values;
  std::size_t i = 0;
  for (int k = 0; k <= steps; ++k) {
    const double time = end * k / steps;
    while (i + 2 < points.size() && points[i + 1].time_from_start.toSec() < time) ++i;
    const double begin = points[i].time_from_start.toSec();
    const double span = points[i + 1].time_from_start.toSec() - begin, t = (time - begin) / span;
    const JointVector p = vector_of(points[i].positions), q = vector_of(points[i + 1].positions);
    const JointVector v = vector_of(points[i].velocities) * span,
                      w = vector_of(points[i + 1].velocities) * span;
    values.push_back(p + t * (v + t * (3.0 * (q - p) - 2.0 * v - w + t * (2.0 * (p - q) + v + w))));
  }
  return values;
}

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
    request.configuration = at(pose);
    const auto response = test::call<SetAssemblyMode>("set_assembly_mode", request);
    EXPECT_EQ(response.status.code, Status::OK) << response.status.message;
    std::uint32_t region = 0;
    EXPECT_TRUE(rests_until(test::values_with_six_solutions(), [&](const UniquenessState& state) {
      region = state.basic_region;
      return region != 0 && state.reference_region == region && !state.warns;
    }));
    return region;
  }

  /// What the node plans from where the robot is, around a cusp.
  PlanPathResult plan_around(std::size_t cusp) {
    PlanPathGoal goal;
    goal.start.kind = Configuration::NOW;
    goal.around_cusp = static_cast<std::uint32_t>(cusp + 1);
    goal.held_joint = "strut_1_joint";
    return planned(goal);
  }

  static PlanPathResult planned(const PlanPathGoal& goal) {
    Client client("/aspect_node/plan_path", true);
    EXPECT_TRUE(client.waitForServer(ros::Duration(test::deadline)));
    client.sendGoal(goal);
    EXPECT_TRUE(client.waitForResult(ros::Duration(test::deadline)));
    const auto result = client.getResult();
    return result ? *result : PlanPathResult();
  }

  std::vector<JointVector> around(std::size_t cusp) {
    const PlanPathResult result = plan_around(cusp);
    EXPECT_EQ(result.status.code, Status::OK) << result.status.message;
    EXPECT_EQ(result.answer, PlanPathResult::YES) << result.reason;
    EXPECT_EQ(result.turns_around_cusps.size(), 4U);
    EXPECT_NE(result.turns_around_cusps.at(cusp), 0);
    EXPECT_EQ(result.in_one_domain, PlanPathResult::NO);
    EXPECT_GT(result.trajectory.points.size(), 2U) << result.timing;
    return values_of(result.trajectory, 1000);
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
  std::vector<JointVector> way = around(cusp);
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
                 array.status[0].message.find("do not determine the pose") != std::string::npos;
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

TEST_F(UniquenessOfNode, ShowsThePathAroundACusp) {
  ASSERT_TRUE(is_ready());
  start_at(4);
  const PlanPathResult result = plan_around(1);
  ASSERT_EQ(result.answer, PlanPathResult::YES) << result.reason;
  const Recorder<visualization_msgs::MarkerArray> markers("/aspect_node/planned_path_markers");
  EXPECT_TRUE(eventually([&] { return markers.last() && markers.last()->markers.size() >= 3; }));
  const auto refused = [&](const std::string& words, const std::function<void(PlanPathGoal&)>& change) {
    PlanPathGoal goal;
    goal.around_cusp = 2;
    goal.held_joint = "strut_1_joint";
    change(goal);
    const PlanPathResult answer = planned(goal);
    EXPECT_EQ(answer.status.code, Status::INVALID_REQUEST);
    EXPECT_NE(answer.status.message.find(words), std::string::npos) << answer.status.message;
    EXPECT_TRUE(answer.path.poses.empty());
  };
  refused("there are 4: 1 at", [](PlanPathGoal& goal) { goal.around_cusp = 5; });
  refused("name of an actuated joint", [](PlanPathGoal& goal) { goal.held_joint = "elbow"; });
  refused("leave out policy and prefer", [](PlanPathGoal& goal) { goal.policy = PlanPathGoal::SERIAL; });
  refused("leave out stay_in_domain", [](PlanPathGoal& goal) { goal.stay_in_domain = true; });
}

TEST_F(UniquenessOfNode, SaysWhetherAPathStaysInADomain) {
  ASSERT_TRUE(is_ready());
  const std::uint32_t region = start_at(4);
  PlanPathGoal goal;
  goal.start.kind = Configuration::NOW;
  goal.goal = at(Pose::planar(-8.6, 12.1, -0.98));
  goal.stay_in_domain = true;
  const PlanPathResult near = planned(goal);
  EXPECT_EQ(near.answer, PlanPathResult::YES) << near.reason;
  EXPECT_EQ(near.in_one_domain, PlanPathResult::YES);
  EXPECT_EQ(near.domains.size(), play(test::values_with_six_solutions()).uniqueness.domains.size()) << region;

  goal.goal = at(test::pose_with_six_solutions(*robot_, *map_, 3));  // of the same actuated values
  const PlanPathResult kept = planned(goal);
  EXPECT_EQ(kept.answer, PlanPathResult::UNKNOWN);
  EXPECT_EQ(kept.in_one_domain, PlanPathResult::NO);
  EXPECT_TRUE(kept.path.poses.empty());
  EXPECT_NE(kept.reason.find("no uniqueness domain holds both"), std::string::npos) << kept.reason;
  goal.stay_in_domain = false;
  const PlanPathResult free = planned(goal);
  EXPECT_EQ(free.answer, PlanPathResult::YES) << free.reason;
  EXPECT_EQ(free.in_one_domain, PlanPathResult::NO);
}

/// The poses that a marker of the basic regions is drawn at: phi is drawn upward, a turn as high as the robot
/// is wide.
std::vector<Pose> poses_of(const visualization_msgs::Marker& marker, const Manipulator& robot) {
  std::vector<Pose> poses;
  for (const auto& at : marker.points)
    poses.push_back(Pose::planar(at.x, at.y, at.z * 2.0 * EIGEN_PI / robot.size()));
  return poses;
}

/// Whether these poses have the sign of det A, and are in no other aspect of the map.
void expect_in_aspect(const AspectMap& map, int id, const std::vector<Pose>& poses) {
  const Manipulator& robot = *map.manipulator();
  const Aspect& aspect = map.aspects().at(static_cast<std::size_t>(id - 1));
  for (const Pose& pose : poses) {
    ASSERT_TRUE(pose.position.allFinite() && pose.orientation.coeffs().allFinite());
    const InverseSolution solution = inverse(robot, pose, aspect.mode);
    ASSERT_EQ(solution.status, InverseStatus::solved);
    EXPECT_GT(aspect.determinant_sign * direct_determinant(robot, pose, solution.q), 0.0);
    const int located = map.locate(pose, aspect.mode).aspect;
    EXPECT_TRUE(located == id || located == 0) << located;
  }
}

TEST_F(UniquenessOfNode, DrawsBasicRegionsAndCusps) {
  ASSERT_TRUE(is_ready());
  const Recorder<visualization_msgs::MarkerArray> drawn("/aspect_node/uniqueness_markers");
  ASSERT_TRUE(eventually([&] { return drawn.last() && drawn.last()->markers.size() > 1; }));
  const visualization_msgs::MarkerArray array = *drawn.last();
  EXPECT_EQ(array.markers.front().action, visualization_msgs::Marker::DELETEALL);
  EXPECT_LT(ros::serialization::serializationLength(array), 5000000U);
  const auto map = compute_aspect_map(robot_).map;
  const WorkingMode mode = map->working_modes().front();
  std::set<std::string> regions;
  std::size_t cubes = 0, cusps = 0;
  for (const visualization_msgs::Marker& marker : array.markers) {
    const std::vector<Pose> poses = poses_of(marker, *robot_);
    for (std::size_t i = 0; i < poses.size() && marker.ns.find("/cusps") != std::string::npos; ++i, ++cusps)
      EXPECT_LT(parallel_index(*robot_, poses[i], inverse(*robot_, poses[i], mode).q), 1e-6);
    if (marker.type != visualization_msgs::Marker::CUBE_LIST) continue;
    EXPECT_TRUE(regions.insert(marker.ns).second) << marker.ns;
    int aspect = 0, region = 0;
    ASSERT_EQ(std::sscanf(marker.ns.c_str(), "aspect %d/basic region %d", &aspect, &region), 2) << marker.ns;
    expect_in_aspect(*map, aspect, poses);
    cubes += poses.size();
  }
  EXPECT_GE(regions.size(), 20U);
  EXPECT_GT(cubes, 5000U);
  EXPECT_GT(cusps, 500U);
}

// What was known begins anew with the robot, and what was drawn is deleted.
TEST_F(UniquenessOfNode, BeginsAnewWithAReload) {
  ASSERT_TRUE(is_ready());
  start_at(1);
  play(around(0));
  const Recorder<visualization_msgs::MarkerArray> drawn("/aspect_node/uniqueness_markers");
  const auto is_empty = [](const visualization_msgs::MarkerArray& array) {
    return array.markers.size() == 1;
  };
  ASSERT_TRUE(eventually([&] { return drawn.last() && !is_empty(*drawn.last()); }));
  EXPECT_EQ(test::call<Reload>("reload", {}).status.code, Status::OK);
  EXPECT_TRUE(eventually([&] { return drawn.first(is_empty).has_value(); }));
  ASSERT_TRUE(eventually([this] { return joints_.getNumSubscribers() > 0 && states_.connected(); }));
  EXPECT_TRUE(is_ready());
  const UniquenessState state = play(test::values_with_six_solutions()).uniqueness;
  EXPECT_FALSE(state.warns);
  EXPECT_EQ(state.reference_region, state.basic_region);
  EXPECT_TRUE(eventually([&] { return !is_empty(*drawn.last()); }));
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
