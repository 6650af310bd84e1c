// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/configurations.h"

#include "ros/monitor/five_bar_setup.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"

namespace parallel_aspects {
namespace {

// `[0]` is what the completion of rosservice fills in.
TEST(ConfigurationsAtPose, TakeEveryWorkingModeUnlessOneIsNamed) {
  const auto mechanism = test::five_bar_mechanism();
  const auto at = [&](const std::vector<std::int8_t>& mode) {
    return configurations_at_pose(*mechanism->manipulator(), test::pose_at(4.5, 8.0), mode);
  };
  for (const std::vector<std::int8_t>& any : {std::vector<std::int8_t>{}, {0}, {0, 0}})
    EXPECT_EQ(at(any).configurations.size(), 4U);
  EXPECT_EQ(at({1, -1}).configurations.size(), 1U);
  for (const std::vector<std::int8_t>& wrong : {std::vector<std::int8_t>{1}, {1, 0}, {1, 2}, {1, 1, 1}})
    EXPECT_EQ(at(wrong).status.code, Status::INVALID_REQUEST);
}

// Fields that a kind does not look at are not ignored; what rosservice fills in by itself says nothing.
TEST(FaultOf, NamesTheFieldThatIsNotLookedAt) {
  const auto mechanism = test::five_bar_mechanism();
  const auto fault = [&](const Configuration& configuration) {
    return fault_of(*mechanism->manipulator(), configuration);
  };
  Configuration filled_in;
  filled_in.joint_names = {""};
  filled_in.joint_positions = {0.0};
  filled_in.working_mode = {0};
  EXPECT_EQ(fault(filled_in), "");
  Configuration posed;
  posed.pose.pose.position.x = 4.5;
  EXPECT_NE(fault(posed).find("pose belongs to kind 1"), std::string::npos) << fault(posed);
  posed.kind = Configuration::POSE;
  EXPECT_EQ(fault(posed), "");
  posed.joint_positions = {1.0};
  EXPECT_NE(fault(posed).find("belong to kind 2"), std::string::npos) << fault(posed);
}

TEST(BeyondLimits, AreSaidWithTheJoint) {
  const auto five_bar = test::five_bar_mechanism()->manipulator();
  std::vector<Leg> legs = five_bar->legs();
  legs[1].limits.lower = -1.0;
  legs[1].limits.upper = 1.5;
  const auto robot = test::manipulator("limited", five_bar->task_space(), legs);
  JointVector q(2);
  q << 9.0, 1.5;
  EXPECT_EQ(beyond_limits(*robot, q), "");
  q[1] = 2.0;
  EXPECT_EQ(beyond_limits(*robot, q), "Joint crank_2_joint is at 2 rad, beyond its limits -1 to 1.5 rad.");
}

TEST(Configurations, MarginsAreNamedWithTheirValues) {
  const auto five_bar = test::five_bar_mechanism()->manipulator();
  const auto robot = five_bar->with_margins({0.999, 0.0, 0.0});
  const auto answer = configurations_at_pose(*robot, Pose::planar(4.5, 8.0), {1, -1});
  EXPECT_EQ(beyond_margins(*five_bar, answer.configurations), "");
  const std::string text = beyond_margins(*robot, answer.configurations);
  EXPECT_NE(text.find(" the parallel index is 0."), std::string::npos) << text;
  EXPECT_NE(text.find(", below the margin 0.999."), std::string::npos) << text;
}

TEST(AsStated, RefusesWhatContradicts) {
  const auto mechanism = test::five_bar_mechanism();
  const Manipulator& robot = *mechanism->manipulator();
  const auto all = configurations_at_pose(robot, test::pose_at(4.5, 8.0), {});
  std::size_t found = 0;
  for (const int sign : {1, -1}) found += as_stated(robot, all, {{}, sign}).configurations.size();
  EXPECT_EQ(found, 4U);
  EXPECT_EQ(as_stated(robot, all, {{1, -1}, 0}).configurations.size(), 1U);
  auto one = all;
  one.configurations.resize(1);  // (+,+)
  const auto refused = as_stated(robot, one, {{-1, 1}, 0});
  EXPECT_EQ(refused.status.code, Status::NO_SOLUTION);
  EXPECT_NE(refused.status.message.find("in (+,+), det A"), std::string::npos) << refused.status.message;
  EXPECT_NE(refused.status.message.find("contradicts working_mode (-,+)"), std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects
