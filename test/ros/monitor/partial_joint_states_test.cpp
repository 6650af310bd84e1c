// SPDX-License-Identifier: BSD-3-Clause
//
// One publisher for each joint: how seldom their messages may come for the robot to be followed, and whether
// it is where it is said to be.
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "ros/monitor/robot_monitor.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/robots/shipped.h"
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

enum class Motion { still, moving, jumping };

// In what share of the period the messages of all joints come, one after the other.
constexpr double evenly = 1.0, almost_at_once = 0.02;

/// A robot near the start that its file states, and a monitor that starts there.
class PartialJointStates {
 public:
  PartialJointStates(const std::string& robot, Motion motion, double rate, double share)
      : mechanism_(test::shipped(robot)),
        home_(start_of(robot, *mechanism_)),
        motion_(motion),
        rate_(rate),
        share_(share),
        truth_(manipulator()) {}

  // Whether it is, from the start on.
  bool followed() {
    const std::size_t joints = manipulator()->leg_count();
    if (!truth_.start_near(0.0, joints_at(0.0), home_.pose, 1e-6)) return false;
    for (int i = 0; i < static_cast<int>(2.0 * rate_); ++i)
      for (std::size_t j = 0; j < joints; ++j)
        if (!send(j, (i + share_ * static_cast<double>(j) / static_cast<double>(joints)) / rate_))
          return false;
    return started_;
  }

 private:
  static AssembledConfiguration start_of(const std::string& robot, const Mechanism& mechanism) {
    const YAML::Node start =
        YAML::Load(test::source_file("config/robots/" + robot + ".yaml"))["start"]["pose"];
    const auto given = start.as<std::vector<double>>();
    const Manipulator& manipulator = *mechanism.manipulator();
    const Eigen::VectorXd coordinates =
        Eigen::Map<const Eigen::VectorXd>(given.data(), static_cast<Eigen::Index>(given.size()));
    const Pose pose = *pose_from_coordinates(manipulator.motions(), coordinates);
    const AssembledConfiguration assembled = mechanism.assembled();
    return {pose, inverse(manipulator, pose, *working_mode(manipulator, assembled.pose, assembled.q)).q};
  }

  const std::shared_ptr<const Manipulator>& manipulator() const { return mechanism_->manipulator(); }

  // It moves up to about 0.4 rad, or 0.1 of its size, in a second.
  JointVector joints_at(double time) const {
    JointVector q = home_.q;
    if (motion_ == Motion::still) return q;
    for (std::size_t j = 0; j < manipulator()->leg_count(); ++j) {
      const double size = manipulator()->leg(j).actuated_by_angle() ? 0.05 : 0.01 * manipulator()->size();
      q[static_cast<Eigen::Index>(j)] +=
          size * std::sin(EIGEN_PI * (1.0 + 0.3 * static_cast<double>(j)) * time);
    }
    if (motion_ == Motion::jumping && time > 1.0)
      q[0] += manipulator()->leg(0).actuated_by_angle() ? 0.5 : 0.2;
    return q;
  }

  bool send(std::size_t actuation, double time) {
    sensor_msgs::JointState message;
    message.header.stamp = start_ + ros::Duration(time);
    message.name = {manipulator()->leg(actuation).actuated_joint};
    message.position = {joints_at(time)[static_cast<Eigen::Index>(actuation)]};
    const MonitorUpdate update =
        monitor_.update(message, message.header.stamp, "/" + manipulator()->leg(actuation).actuated_joint);
    if (!update.state || update.state->status.code == Status::NO_JOINT_STATES) return !started_;
    if (!started_) return started_ = monitor_.start_near(home_.pose, message.header.stamp).code == Status::OK;
    if (update.state->status.code != Status::OK) return false;
    compare(*update.tracked, (update.state->header.stamp - start_).toSec());
    return true;
  }

  void compare(const TrackedState& told, double time) {
    for (const int step : {1, 2, 3, 4, 5})  // from one sample of the truth to the next, which are seldom
      truth_.update(last_ + (time - last_) * 0.2 * step, joints_at(last_ + (time - last_) * 0.2 * step));
    last_ = time;
    ASSERT_TRUE(truth_.state().followed());
    EXPECT_LE(anchor_distance(*manipulator(), truth_.state().pose, told.pose),
              told.spread + 1e-6 * manipulator()->size());
  }

  static NodeOptions options() {
    NodeOptions options;
    options.start.tolerance = 1.0;
    return options;
  }

  const std::shared_ptr<const Mechanism> mechanism_;
  const AssembledConfiguration home_;
  const Motion motion_;
  const double rate_;  // of each joint [Hz]
  const double share_;
  const ros::Time start_{100.0};
  Tracker truth_;
  RobotMonitor monitor_{mechanism_, options()};
  bool started_ = false;
  double last_ = 0.0;
};

class PartialJointStatesTest : public testing::TestWithParam<std::string> {};

TEST_P(PartialJointStatesTest, AreFollowedAtTwentyHertz) {
  for (const Motion motion : {Motion::still, Motion::moving})
    for (const double share : {evenly, almost_at_once})
      EXPECT_TRUE(PartialJointStates(GetParam(), motion, 20.0, share).followed())
          << (motion == Motion::still ? "still" : "moving") << ", in a share of " << share;
}

// Faster than the velocity limits, in the room that is left between two values.
TEST_P(PartialJointStatesTest, AreNotFollowedThroughAJump) {
  for (const double share : {evenly, almost_at_once})
    EXPECT_FALSE(PartialJointStates(GetParam(), Motion::jumping, 100.0, share).followed()) << share;
}

// Prints at which rates they are followed: --gtest_also_run_disabled_tests.
TEST_P(PartialJointStatesTest, DISABLED_PrintRates) {
  for (const Motion motion : {Motion::still, Motion::moving}) {
    std::cout << GetParam() << (motion == Motion::still ? ", still:" : ", moving:");
    for (const double rate : {10.0, 15.0, 20.0, 50.0, 100.0, 250.0, 500.0, 1000.0, 2000.0})
      if (PartialJointStates(GetParam(), motion, rate, evenly).followed()) std::cout << ' ' << rate;
    std::cout << '\n';
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, PartialJointStatesTest, testing::Values("five_bar", "delta", "stewart"),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace parallel_aspects
