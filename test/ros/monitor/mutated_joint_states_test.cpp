// SPDX-License-Identifier: BSD-3-Clause
//
// joint_states with seeded random faults in every field, bit by bit in the numbers: whatever comes, the
// monitor answers, and where it says OK the pose belongs to the actuated joints of that message.
#include "ros/monitor/five_bar_setup.h"
#include "ros/monitor/robot_monitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

class Mutator {
 public:
  explicit Mutator(unsigned seed) : engine_(seed) {}

  void mutate(sensor_msgs::JointState& message) {
    for (std::size_t faults = pick(4); faults > 0; --faults) mutate_once(message);
  }

 private:
  std::size_t pick(std::size_t count) { return engine_() % count; }

  void flip_bit(double& value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    bits ^= std::uint64_t{1} << pick(64);
    std::memcpy(&value, &bits, sizeof bits);
  }

  template <typename List>
  void disturb(List& list) {
    if (list.empty() || pick(3) == 0)
      list.emplace_back();
    else if (pick(2) == 0)
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(pick(list.size())));
    else
      std::swap(list[pick(list.size())], list[pick(list.size())]);
  }

  void mutate_once(sensor_msgs::JointState& message) {
    switch (pick(8)) {
      case 0:
        return disturb(message.name);
      case 1:
        return disturb(message.position);
      case 2:
        return disturb(message.velocity);
      case 3:
        return disturb(message.effort);
      case 4:
        message.header.stamp.sec ^= 1U << pick(32);
        return;
      case 5:
        message.header.stamp.nsec ^= 1U << pick(32);
        return;
      case 6:
        if (!message.position.empty()) flip_bit(message.position[pick(message.position.size())]);
        return;
      default:
        message.header.seq = static_cast<std::uint32_t>(engine_());
        if (!message.name.empty()) message.name[pick(message.name.size())] += static_cast<char>(pick(256));
    }
  }

  std::mt19937 engine_;
};

double residual(const Manipulator& robot, const AspectState& state, const sensor_msgs::JointState& message) {
  double worst = 0.0;
  const auto pose = pose_from_base(robot, state.pose);
  if (!pose) return INFINITY;
  for (const Leg& leg : robot.legs()) {
    const auto found = std::find(message.name.begin(), message.name.end(), leg.actuated_joint);
    if (found == message.name.end()) continue;  // merged with a message before
    const double q = message.position[static_cast<std::size_t>(found - message.name.begin())];
    const double rod = (pose->transform(leg.anchor) - leg.proximal_point(q)).norm();
    worst = std::max(worst, std::abs(rod - std::sqrt(leg.squared_distance(q))));
  }
  return worst;
}

TEST(MutatedJointStates, AreAnsweredAndNeverMisread) {
  const auto mechanism = test::five_bar_mechanism();
  const Manipulator& robot = *mechanism->manipulator();
  NodeOptions options;
  options.start.pose = std::vector<double>{4.5, 8.0};
  int known = 0, refused = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    RobotMonitor monitor(mechanism, options);
    Mutator mutator(seed);
    for (int i = 0; i < 250; ++i) {
      const ros::Time now(1000.0 + 0.01 * i);
      auto message = test::joints_at(robot, test::pose_at(4.5, 8.0 + 1e-3 * i), {1, -1}, now);
      mutator.mutate(message);
      const MonitorUpdate update = monitor.update(message, now, "/driver");
      if (i % 50 == 0) monitor.work();
      if (!update.state) continue;
      EXPECT_TRUE(update.state->status.code == Status::OK || !update.state->status.message.empty());
      if (update.state->status.code != Status::OK) {
        ++refused;
        EXPECT_TRUE(std::isnan(update.state->pose.position.x)) << "seed " << seed << ", message " << i;
        continue;
      }
      ++known;
      if (update.state->header.stamp != message.header.stamp) continue;  // merged: of a time before
      ASSERT_LT(residual(robot, *update.state, message), 1e-6)
          << "seed " << seed << ", message " << i << ":\n"
          << message << *update.state;
    }
  }
  EXPECT_GT(known, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace parallel_aspects
