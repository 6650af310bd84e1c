// SPDX-License-Identifier: BSD-3-Clause
//
// A known random motion at 1 kHz; every state is compared with it. Parameters: ~robot, ~seconds, ~seed.
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/conversions.h"
#include "ros/node/node_client.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/MapProgress.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <gtest/gtest.h>
#include <ros/network.h>
#include <ros/ros.h>

#include "support/known_motion.h"
#include "support/robots/shipped.h"
#include <XmlRpc.h>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <mutex>
#include <sensor_msgs/JointState.h>
#include <string>
#include <unistd.h>

namespace parallel_aspects {
namespace {

using test::eventually;
using test::KnownMotion;

// Process id of a node, asked of the node itself; 0 where it does not answer.
int process_of(const std::string& node) {
  XmlRpc::XmlRpcValue request, response, uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", request, response, uri, false)) return 0;
  if (!ros::network::splitURI(static_cast<std::string>(uri), host, port)) return 0;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue ask, answer;
  ask[0] = ros::this_node::getName();
  return client.execute("getPid", ask, answer) && answer.size() == 3 ? static_cast<int>(answer[2]) : 0;
}

// Memory that a process holds [MB].
double resident_megabytes(int process) {
  std::ifstream statm("/proc/" + std::to_string(process) + "/statm");
  double all = 0.0, resident = 0.0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// Compares what the node says with the truth, by stamps.
class Judge {
 public:
  Judge(std::shared_ptr<const Mechanism> mechanism, std::shared_ptr<const AspectMap> map)
      : mechanism_(std::move(mechanism)), robot_(*mechanism_->manipulator()), map_(std::move(map)) {}

  void expect(const ros::Time& stamp, const KnownMotion::Sample& truth) {
    const std::lock_guard<std::mutex> lock(mutex_);
    truths_[stamp] = truth;
    while (truths_.size() > 20000) truths_.erase(truths_.begin());
  }

  void hear(const AspectState& state) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = truths_.find(state.header.stamp);
    if (found == truths_.end()) return;
    ++heard_;
    if (state.status.code != Status::OK) {
      ++unknown_[state.status.message];
      return;
    }
    const std::string fault = fault_of(state, found->second);
    if (fault.empty()) return;
    if (wrong_++ < 5) std::cerr << fault << "\n" << state << "\n";
  }

  std::size_t heard() const { return locked(heard_); }
  std::size_t wrong() const { return locked(wrong_); }
  std::map<std::string, std::size_t> unknown() const { return locked(unknown_); }

 private:
  template <typename Value>
  Value locked(const Value& value) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return value;
  }

  std::string fault_of(const AspectState& state, const KnownMotion::Sample& truth) const {
    const auto pose = pose_from_base(robot_, state.pose);
    if (!pose) return "no pose";
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      const Leg& leg = robot_.leg(j);
      const double q = truth.q[static_cast<Eigen::Index>(j)];
      const double rod = (pose->transform(leg.anchor) - leg.proximal_point(q)).norm();
      if (std::abs(rod - std::sqrt(leg.squared_distance(q))) > 1e-7 * robot_.size())
        return "the actuated joints do not assemble at this pose";
    }
    if (!truth.pose) return {};
    for (const Leg& leg : robot_.legs())
      if ((pose->transform(leg.anchor) - truth.pose->transform(leg.anchor)).norm() > 1e-5 * robot_.size())
        return "another pose";
    if (state.determinant_sign * direct_determinant(robot_, *truth.pose, truth.q) <= 0.0)
      return "another sign";
    if (std::vector<int>(state.working_mode.begin(), state.working_mode.end()) != truth.mode.signs())
      return "another working mode than " + to_string(truth.mode);
    if (!map_ || state.aspect == 0) return {};
    const Location location = map_->locate(*truth.pose, truth.mode);
    return location.status == LocationStatus::inside && location.aspect != static_cast<int>(state.aspect)
               ? "another aspect than " + std::to_string(location.aspect)
               : "";
  }

  const std::shared_ptr<const Mechanism> mechanism_;
  const Manipulator& robot_;
  const std::shared_ptr<const AspectMap> map_;
  mutable std::mutex mutex_;
  std::map<ros::Time, KnownMotion::Sample> truths_;
  std::size_t heard_ = 0, wrong_ = 0;
  std::map<std::string, std::size_t> unknown_;
};

/// Stamps a thousandth of a second apart that keep up with the clock, but never run ahead of it.
class Pace {
 public:
  ros::Time next() {
    stamp_ += ros::Duration(0.001);
    const ros::Time now = ros::Time::now();
    if ((now - stamp_).toSec() > 0.1) stamp_ = now;
    while (ros::Time::now() < stamp_) ros::WallDuration(1e-4).sleep();
    return stamp_;
  }

 private:
  ros::Time stamp_ = ros::Time::now();
};

TEST(Soak, EveryStateIsRightAndMemoryIsFlat) {
  ros::NodeHandle nh, own("~");
  const auto robot_name = own.param<std::string>("robot", "five_bar");
  const double seconds = own.param("seconds", 10.0);
  const auto mechanism = test::shipped(robot_name);
  const Manipulator& robot = *mechanism->manipulator();
  const test::Recorder<MapProgress> progress("aspect_node/map_progress");
  ASSERT_TRUE(eventually([&] { return progress.last() && progress.last()->state == MapProgress::COMPLETE; }));
  const auto map = compute_aspect_map(mechanism->manipulator()).map;  // null with six degrees of freedom

  Pose start = mechanism->assembled().pose;
  const auto coordinates = nh.param("aspect_node/start/pose", std::vector<double>());
  const PoseCoordinates values =
      Eigen::Map<const Eigen::VectorXd>(coordinates.data(), static_cast<Eigen::Index>(coordinates.size()));
  start = pose_from_coordinates(robot.motions(), values).value_or(start);
  std::optional<WorkingMode> mode;
  for (const InverseSolution& solution : inverse_in_all_modes(robot, start))
    if (solution.status == InverseStatus::solved) mode = solution.mode;
  ASSERT_TRUE(mode);
  KnownMotion motion(mechanism->manipulator(), start, *mode,
                     static_cast<std::uint64_t>(own.param("seed", 1)));
  Judge judge(mechanism, map);

  const ros::Subscriber states = nh.subscribe<AspectState>(
      "aspect_node/state", 10000, [&](const AspectState::ConstPtr& state) { judge.hear(*state); });
  std::atomic<int> crossings{0};
  const ros::Subscriber transitions = nh.subscribe<AspectTransition>(
      "aspect_node/transitions", 10000, [&](const AspectTransition::ConstPtr& transition) {
        if (transition->kind == AspectTransition::WORKING_MODE) ++crossings;
      });
  ros::Publisher publisher = nh.advertise<sensor_msgs::JointState>("joint_states", 10000);
  ASSERT_TRUE(eventually([&] {
    return publisher.getNumSubscribers() > 0 && states.getNumPublishers() > 0 &&
           transitions.getNumPublishers() > 0;
  }));
  const int process = process_of(ros::names::resolve("aspect_node"));
  ASSERT_GT(process, 0);

  sensor_msgs::JointState message;
  for (const Leg& leg : robot.legs()) message.name.push_back(leg.actuated_joint);
  Pace pace;
  const int samples = static_cast<int>(1000.0 * seconds), warm = samples / 5;
  double memory = 0.0;
  for (int i = 0; i < samples && ros::ok(); ++i) {
    // Faster and slower by turns.
    const double fastest = 1e-3 * std::min(1.0, robot.size()) * (1.1 + std::sin(1e-3 * i));
    const KnownMotion::Sample sample = motion.next(fastest);
    message.header.stamp = pace.next();
    message.position.assign(sample.q.data(), sample.q.data() + sample.q.size());
    judge.expect(message.header.stamp, sample);
    publisher.publish(message);
    if (i == warm) memory = resident_megabytes(process);
  }
  EXPECT_TRUE(eventually([&] { return judge.heard() >= static_cast<std::size_t>(samples); }))
      << judge.heard();

  // The motion may end within a pass, whose crossing is told already.
  EXPECT_TRUE(eventually([&] { return crossings.load() >= motion.passes(); }));
  EXPECT_LE(crossings.load(), motion.passes() + 1);

  const double grown = resident_megabytes(process) - memory;
  std::size_t unknown = 0;
  for (const auto& [why, count] : judge.unknown()) {
    unknown += count;
    std::printf("%zu states: %s\n", count, why.c_str());
  }
  std::printf(
      "%s: %zu states in %.0f s, %zu wrong, %zu unknown; %d of %d crossings detected; %.1f MB, grown by %.2f "
      "MB\n",
      robot_name.c_str(), judge.heard(), seconds, judge.wrong(), unknown, crossings.load(), motion.passes(),
      memory, grown);
  EXPECT_EQ(judge.wrong(), 0U);
  EXPECT_EQ(unknown, 0U);
  EXPECT_LT(grown, 4.0) << "MB";
}

}  // namespace
}  // namespace parallel_aspects
