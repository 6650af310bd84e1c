// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/configurations.h"

#include "ask/question_parts.h"
#include "ros/monitor/five_bar_setup.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"

namespace parallel_aspects {
namespace {

// `[0]` is what the completion of rosservice fills in.
TEST(StatedSigns, TakeEveryWorkingModeUnlessOneIsNamed) {
  const auto mechanism = test::five_bar_mechanism();
  Configuration configuration;
  const auto stated = [&](const std::vector<std::int8_t>& mode) {
    configuration.working_mode = mode;
    return stated_signs(configuration).mode;
  };
  for (const std::vector<std::int8_t>& any : {std::vector<std::int8_t>{}, {0}, {0, 0}}) {
    EXPECT_FALSE(stated(any));
    EXPECT_EQ(fault_of(*mechanism->manipulator(), configuration), "");
  }
  EXPECT_EQ(stated({1, -1}), WorkingMode::from_signs({1, -1}));
  for (const std::vector<std::int8_t>& wrong : {std::vector<std::int8_t>{1}, {1, 0}, {1, 2}, {1, 1, 1}}) {
    stated(wrong);
    EXPECT_NE(fault_of(*mechanism->manipulator(), configuration).find("working_mode"), std::string::npos);
  }
}

// Fields that a kind does not look at are not ignored; what rosservice fills in by itself says nothing.
TEST(FaultOf, NamesTheFieldThatIsNotRead) {
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
  const auto at = [](const Manipulator& one) {
    std::string why;
    return ask::configurations_at(one, Pose::planar(4.5, 8.0), WorkingMode::from_signs({1, -1}), why);
  };
  EXPECT_EQ(beyond_margins(at(*five_bar)), "");
  const std::string text = beyond_margins(at(*robot));
  EXPECT_NE(text.find(" the parallel index is 0."), std::string::npos) << text;
  EXPECT_NE(text.find(", below the margin 0.999."), std::string::npos) << text;
}

}  // namespace
}  // namespace parallel_aspects
