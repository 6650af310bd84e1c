// SPDX-License-Identifier: BSD-3-Clause
//
// What is said of joints by other names than those of the actuated joints.
#include "ros/monitor/robot_monitor_fixture.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::RobotMonitorTest;

class JointNames : public RobotMonitorTest {};

TEST_F(JointNames, ReportsWhichJointsAreExpectedAndWhichArrive) {
  const auto named = [](const std::vector<std::string>& names) {
    sensor_msgs::JointState message;
    message.header.stamp = at(1.0);
    message.name = names;
    message.position.assign(names.size(), 0.0);
    return message;
  };
  const MonitorUpdate first = update(named({"crank1_joint", "crank2_joint"}), 1.0);
  ASSERT_TRUE(first.state);
  EXPECT_EQ(first.state->status.code, Status::NO_JOINT_STATES);
  for (const char* words :
       {"'crank_1_joint', 'crank_2_joint' are expected", "'crank1_joint', 'crank2_joint' arrive",
        "did you mean 'crank_1_joint', 'crank_2_joint' by 'crank1_joint', 'crank2_joint'?"})
    EXPECT_NE(first.state->status.message.find(words), std::string::npos) << first.state->status.message;
  EXPECT_EQ(first.warning, first.state->status.message);
  EXPECT_EQ(monitor_.current(at(1.0)).status.message, first.warning);
  EXPECT_FALSE(update(named({"crank1_joint", "crank2_joint"}), 1.1).state) << "that was said";
  const MonitorUpdate other = update(named({"panda_finger"}), 1.2);
  ASSERT_TRUE(other.state);
  EXPECT_NE(other.state->status.message.find("'panda_finger' arrive"), std::string::npos);
  EXPECT_TRUE(other.warning.empty()) << "once in the log";
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 1.3), 1.3).state->status.code, Status::OK);
  EXPECT_FALSE(update(named({"another"}), 1.4).state);
}

TEST_F(JointNames, SaysWhatIsExpectedWhereNothingArrives) {
  const RobotMonitor quiet(mechanism_, {}, "/arm/joint_states");
  EXPECT_EQ(
      quiet.current(at(1.0)).status.message,
      "Nothing has arrived on /arm/joint_states yet; joints 'crank_1_joint', 'crank_2_joint' are expected.");
}

// What an earlier message was called is no reason why this one cannot be used.
TEST_F(JointNames, NoNameOfAnEarlierMessageIsGuessedAt) {
  auto message = joint_values(4.5, 8.0, {1, -1}, 1.0);
  message.name[1] = "crank2_joint";
  update(message, 1.0);
  auto broken = joint_values(4.5, 8.0, {1, -1}, 1.1);
  broken.position.pop_back();
  const std::string text = update(broken, 1.1).state->status.message;
  EXPECT_EQ(text.find("did you mean"), std::string::npos) << text;
}

// Names of other robots would be work at their rate; what came while all was well is no reason for a silence.
TEST_F(JointNames, JointsOfOthersAreHeardOnlyWhileNothingUsableComes) {
  sensor_msgs::JointState other;
  other.name = {"panda_finger"};
  other.position = {0.0};
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  update(other, 1.1);
  const auto stale = expire(1.6);
  ASSERT_TRUE(stale);
  EXPECT_EQ(stale->status.message.find("panda_finger"), std::string::npos) << stale->status.message;
  update(other, 1.7);
  EXPECT_NE(monitor_.current(at(1.8)).status.message.find("'panda_finger' arrives"), std::string::npos)
      << monitor_.current(at(1.8)).status.message;
}

TEST_F(JointNames, GuessesTheJointThatIsMissing) {
  auto message = joint_values(4.5, 8.0, {1, -1}, 1.0);
  message.name[1] = "crank2_joint";
  const MonitorUpdate refused = update(message, 1.0);
  ASSERT_TRUE(refused.state);
  const std::string& text = refused.state->status.message;
  EXPECT_NE(text.find("did you mean 'crank_2_joint' by 'crank2_joint'?"), std::string::npos) << text;
}

// A passive joint of the robot is no actuated one by another name, and one name stands for one joint.
TEST_F(JointNames, AJointThatIsInUseIsNotMeant) {
  auto message = joint_values(4.5, 8.0, {1, -1}, 1.0);
  message.name[1] = "elbow_2_joint";
  const std::string passive = update(message, 1.0).state->status.message;
  EXPECT_EQ(passive.find("did you mean"), std::string::npos) << passive;
  RobotMonitor another(mechanism_, {});
  message.name = {"crank_joint", "elbow_2_joint"};
  const std::string text = another.update(message, at(1.0)).state->status.message;
  EXPECT_NE(text.find("did you mean 'crank_1_joint' by 'crank_joint'?"), std::string::npos) << text;
}

TEST_F(JointNames, KeepsLittleOfEnormousNames) {
  sensor_msgs::JointState message;
  for (int i = 0; i < 100000; ++i) message.name.push_back(std::string(300, 'x') + std::to_string(i));
  message.name.emplace_back(10000000, 'y');
  message.position.assign(message.name.size(), 0.0);
  const MonitorUpdate first = update(message, 1.0);
  ASSERT_TRUE(first.state);
  EXPECT_LT(first.state->status.message.size(), 3000U);
  for (int i = 0; i < 100; ++i) {
    message.name = {"joint_" + std::to_string(i)};
    message.position = {0.0};
    update(message, 1.1 + 0.001 * i);
  }
  EXPECT_NE(monitor_.current(at(2.0)).status.message.find("and others arrive"), std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects
