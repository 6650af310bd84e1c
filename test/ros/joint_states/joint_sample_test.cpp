// SPDX-License-Identifier: BSD-3-Clause
#include "ros/joint_states/joint_sample.h"

#include "ros/monitor/five_bar_setup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

JointSample read(const Names& names, const Values& positions, const Values& velocities = {}) {
  sensor_msgs::JointState message;
  message.name = names;
  message.position = positions;
  message.velocity = velocities;
  return JointSampleReader(test::five_bar_mechanism()).read(message);
}

TEST(JointSample, TakesTheDrivesInAnyOrder) {
  const JointSample sample = read({"crank_2_joint", "crank_1_joint"}, {2.0, 1.0});
  ASSERT_EQ(sample.status, SampleStatus::usable);
  EXPECT_TRUE(sample.message.empty());
  EXPECT_EQ(sample.q[0], 1.0);
  EXPECT_EQ(sample.q[1], 2.0);
}

TEST(JointSample, TakesPassiveJointsOfTheRobotWithoutAWord) {
  const JointSample sample = read({"crank_1_joint", "elbow_1_joint", "crank_2_joint"}, {1.0, 5.0, 2.0});
  ASSERT_EQ(sample.status, SampleStatus::usable);
  EXPECT_TRUE(sample.message.empty());
}

TEST(JointSample, IgnoresAnUnknownJointAndSaysSo) {
  const JointSample sample = read({"crank_1_joint", "gripper_joint", "crank_2_joint"}, {1.0, 5.0, 2.0});
  ASSERT_EQ(sample.status, SampleStatus::usable);
  EXPECT_NE(sample.message.find("gripper_joint"), std::string::npos);
  EXPECT_EQ(sample.q[1], 2.0);
}

TEST(JointSample, AMessageWithNoneOfTheDrivesIsForeign) {
  EXPECT_EQ(read({"gripper_joint"}, {1.0}).status, SampleStatus::foreign);
  EXPECT_EQ(read({"elbow_1_joint"}, {1.0}).status, SampleStatus::foreign);
}

TEST(JointSample, AMessageMayHoldSomeOfTheDrives) {
  const JointSample sample = read({"crank_2_joint"}, {1.0});
  ASSERT_EQ(sample.status, SampleStatus::partial);
  EXPECT_NE(sample.message.find("crank_1_joint is missing"), std::string::npos) << sample.message;
  EXPECT_EQ(sample.named_joints, JointSet().set(1));
  EXPECT_TRUE(std::isnan(sample.q[0]));
  EXPECT_EQ(sample.q[1], 1.0);
}

struct Fault {
  Names names;
  Values positions, velocities;
  const char* words;
};

class JointSampleFault : public testing::TestWithParam<Fault> {};

TEST_P(JointSampleFault, IsRefusedWithASentence) {
  const Fault& fault = GetParam();
  const JointSample sample = read(fault.names, fault.positions, fault.velocities);
  EXPECT_EQ(sample.status, SampleStatus::invalid);
  EXPECT_NE(sample.message.find(fault.words), std::string::npos) << sample.message;
}

const Names both{"crank_1_joint", "crank_2_joint"};
const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    All, JointSampleFault,
    testing::Values(
        Fault{{}, {}, {}, "no joint"}, Fault{both, {1.0}, {}, "name has length 2, position 1"},
        Fault{both, {}, {}, "position 0"}, Fault{both, {1.0, 2.0, 3.0}, {}, "position 3"},
        Fault{both, {1.0, 2.0}, {0.0}, "velocity 1"},
        Fault{both, {1.0, not_a_number}, {}, "crank_2_joint is not a finite number"},
        Fault{both, {-infinity, 1.0}, {}, "crank_1_joint is not a finite number"},
        Fault{both, {1.0, 1e308}, {}, "crank_2_joint is beyond a million"},
        Fault{{"crank_1_joint", "crank_2_joint", "crank_1_joint"}, {1.0, 2.0, 1.0}, {}, "there twice"}));

TEST(ActuatedValues, RefusesListsThatDoNotMatch) {
  const auto mechanism = test::five_bar_mechanism();
  EXPECT_EQ(actuated_values(*mechanism->manipulator(), both, {1.0}).status, SampleStatus::invalid);
  EXPECT_EQ(actuated_values(*mechanism->manipulator(), both, {1.0, 2.0}).status, SampleStatus::usable);
}

TEST(ActuatedValues, NamesOneJointThatIsMissingOrSeveral) {
  const auto mechanism = test::five_bar_mechanism();
  EXPECT_EQ(actuated_values(*mechanism->manipulator(), {}, {}).message,
            "actuated joints crank_1_joint, crank_2_joint are missing.");
  EXPECT_EQ(actuated_values(*mechanism->manipulator(), {"crank_1_joint"}, {1.0}).message,
            "actuated joint crank_2_joint is missing.");
  EXPECT_EQ(actuated_values(*mechanism->manipulator(), {"crank_1_joint", "crank2_joint"}, {1.0, 1.0}).message,
            "actuated joint crank_2_joint is missing. Did you mean crank_2_joint by crank2_joint?");
  EXPECT_EQ(
      actuated_values(*mechanism->manipulator(), {"crank_joint"}, {1.0}).message,
      "actuated joints crank_1_joint, crank_2_joint are missing. Did you mean crank_1_joint by crank_joint?")
      << "one name is not meant for two";
}

}  // namespace
}  // namespace parallel_aspects
