// SPDX-License-Identifier: BSD-3-Clause
//
// The start that `aspects setup` writes is a guess, and the first sample refutes it.
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "ros/monitor/robot_monitor.h"
#include "urdf/setup/setup_texts.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/robots/random_robots.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

/// A monitor that hears its first sample.
class FirstSample {
 public:
  FirstSample(const std::shared_ptr<const Mechanism>& mechanism, const NodeOptions& options)
      : robot_(*mechanism->manipulator()), monitor_(mechanism, options) {}

  std::uint8_t code(const JointVector& q) {
    sensor_msgs::JointState message;
    message.header.stamp = ros::Time(100.0 + 0.01 * ++samples_);
    for (const Leg& leg : robot_.legs()) message.name.push_back(leg.actuated_joint);
    message.position.assign(q.data(), q.data() + q.size());
    return monitor_.update(message, message.header.stamp).state->status.code;
  }

  void work() { monitor_.work(); }

 private:
  const Manipulator& robot_;
  RobotMonitor monitor_;
  int samples_ = 0;
};

double distance_of_nearest(const Manipulator& robot, const JointVector& q, const Pose& pose) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const AssemblyMode& mode : direct(robot, q).solutions)
    nearest = std::min(nearest, anchor_distance(robot, mode.pose, pose));
  return nearest;
}

TEST(StartOfSetup, IsRefutedByAFirstSampleThatDoesNotFit) {
  const SetupResult found = test::set_up_text(test::urdf_of("exported_five_bar"));
  ASSERT_TRUE(found.mechanism);
  NodeOptions options;
  options.start.pose = YAML::Load(found.config)["start"]["pose"].as<std::vector<double>>();
  const Manipulator& robot = *found.mechanism->manipulator();
  const AssembledConfiguration home = found.mechanism->assembled();
  const double tolerance = robot.size() / 20.0;
  test::RandomRobots random(1);
  int believed = 0, refuted = 0;
  for (int i = 0; i < 60; ++i) {
    JointVector q = home.q;
    for (Eigen::Index j = 0; j < q.size(); ++j) q[j] += random.uniform(-0.3, 0.3);
    const double distance = distance_of_nearest(robot, q, home.pose);
    if (std::abs(distance - tolerance) < 0.01 * tolerance) continue;
    FirstSample sample(found.mechanism, options);
    const std::uint8_t code = sample.code(q);
    EXPECT_EQ(code, distance < tolerance ? Status::OK : Status::NOT_STARTED) << distance << " m away";
    ++(code == Status::OK ? believed : refuted);
    if (code == Status::OK) continue;
    sample.work();
    EXPECT_EQ(sample.code(q), Status::AMBIGUOUS);
    EXPECT_EQ(sample.code(home.q), Status::AMBIGUOUS) << "nor is it believed later, near the guess";
  }
  EXPECT_GT(believed, 0);
  EXPECT_GT(refuted, 0);
}

}  // namespace
}  // namespace parallel_aspects
