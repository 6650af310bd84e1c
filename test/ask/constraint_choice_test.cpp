// SPDX-License-Identifier: BSD-3-Clause
#include "ask/constraint_choice.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <string>

namespace parallel_aspects::ask {
namespace {

class ConstraintChoices : public testing::Test {
 protected:
  const std::shared_ptr<const Manipulator> robot_ = test::shipped("three_rpr")->manipulator();

  std::string problem_of(const ConstraintChoice& choice) const {
    ProblemList problems;
    constrained(robot_, choice, problems);
    return problems.size() == 1 ? text_of(problems.front(), plain_name) : std::to_string(problems.size());
  }
};

TEST_F(ConstraintChoices, NothingSaidChangesNothing) {
  ProblemList problems;
  EXPECT_EQ(constrained(robot_, {}, problems), robot_);
  EXPECT_TRUE(problems.empty());
}

TEST_F(ConstraintChoices, AreThoseOfTheRobotThatIsMade) {
  ProblemList problems;
  ConstraintChoice choice;
  choice.without = "all";
  choice.margins = {{"parallel", 0.05}};
  choice.tolerance = {0.001};
  const auto chosen = constrained(robot_, choice, problems);
  ASSERT_TRUE(problems.empty()) << text_of(problems.front(), plain_name);
  EXPECT_FALSE(chosen->constraint_kinds()[index_of(ConstraintKind::actuated_limits)]);
  EXPECT_EQ(chosen->constraints().margins.parallel, 0.05);
  EXPECT_GT(chosen->tolerance(), 0.0);
  refuse_tolerance(choice, *chosen, problems);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().field, "tolerance");
}

TEST_F(ConstraintChoices, WhatIsWrongNamesItsField) {
  ConstraintChoice choice;
  choice.only = "nothing";
  EXPECT_EQ(problem_of(choice), "constraint names 'nothing'; give some of " + constraint_names() + ".");
  choice.only = "cones";
  EXPECT_EQ(problem_of(choice),
            "constraint names cones, but 'three_rpr' has none; state them in the robot's YAML or URDF, or "
            "leave the name out.");
  choice = {};
  choice.margins = {{"paralel", 0.05}};
  EXPECT_EQ(problem_of(choice),
            "margin has 'paralel=0.05'; give some of parallel, serial and det_a, such as \"parallel=0.05 "
            "serial=0.1\".");
  choice.margins = {{"serial", 0.05}, {"serial", 0.1}};
  EXPECT_EQ(problem_of(choice), "margin names serial twice; give one value for it.");
  choice.margins = {{"serial", 0.05}};
  choice.without = "margins";
  EXPECT_EQ(problem_of(choice),
            "margin sets margins and no_constraint leaves them out; give one of the two.");
  for (const std::vector<double>& tolerance : {std::vector<double>{-0.1}, {0.2}, {0.01, 0.02}}) {
    choice = {};
    choice.tolerance = tolerance;
    EXPECT_EQ(problem_of(choice),
              "tolerance is not from 0 to 0.1; give a share of the robot's size such as 0.001.");
  }
}

}  // namespace
}  // namespace parallel_aspects::ask
