// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/check.h"

#include "ask/question_parts.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/texts.h"
#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects::ask {
namespace {

const WorkingMode mode_of_check = *WorkingMode::from_signs({-1, 1});
const Pose check_from = Pose::planar(4.5, 8.0), check_to = Pose::planar(4.6, 8.0);

CheckQuestion of_poses(const Pose& first, const Pose& last) {
  CheckQuestion question;
  question.path = {{1.0, first}, {2.0, last}};
  question.mode = mode_of_check;
  return question;
}

CheckQuestion of_joints(const Manipulator& robot) {
  CheckQuestion question;
  question.trajectory = {{0.0, inverse(robot, check_from, mode_of_check).q, {}, {}},
                         {1.0, inverse(robot, check_to, mode_of_check).q, {}, {}}};
  return question;
}

TEST(Check, OfPosesAndOfJoints) {
  const auto robot = test::five_bar();
  Session session(robot);
  CheckQuestion question = of_poses(check_from, check_to);
  const auto poses = answer(session, question);
  ASSERT_TRUE(poses);
  EXPECT_EQ(poses.answer.check.answer, TrajectoryAnswer::safe);
  EXPECT_EQ(poses.answer.from, 1.0);
  EXPECT_FALSE(poses.answer.least_distance()) << "none were asked for";
  EXPECT_TRUE(poses.answer.check.samples.empty());
  question = of_joints(*robot);
  question.start_sign = Sign::plus;
  question.distances.emplace().value = 3;
  const auto joints = answer(session, question);
  ASSERT_TRUE(joints);
  EXPECT_EQ(joints.answer.check.answer, TrajectoryAnswer::safe);
  EXPECT_EQ(joints.answer.speeds.at(1).joint, robot->leg(1).actuated_joint);
  EXPECT_GT(joints.answer.least_distance().value().at(0).second, 0.0);
}

TEST(Check, AnAmbiguousStartNamesThoseThereAre) {
  const auto robot = test::five_bar();
  Session session(robot);
  const auto outcome = answer(session, of_joints(*robot));
  ASSERT_EQ(outcome.status, MapStatus::refused);
  const std::string text = text_of(outcome.problems.at(0), [](const std::string& field) {
    return field == "start_sign +" ? "A" : field == "start_sign -" ? "B" : field;
  });
  EXPECT_TRUE(test::has(text, "state which. Give start_pose \""));
  EXPECT_TRUE(test::has(text, "(the same as A), or start_pose"));
  EXPECT_TRUE(test::has(text, "(the same as B)."));
}

TEST(Check, IsRefusedWithTheFieldAtFault) {
  struct Wrong {
    std::string field;
    std::function<void(CheckQuestion&)> change;
  };
  const auto robot = test::five_bar();
  const std::vector<Wrong> all{{"path", [](CheckQuestion& wrong) { wrong.path.reset(); }},
                               {"path", [](CheckQuestion& wrong) { wrong.trajectory.emplace(); }},
                               {"mode", [](CheckQuestion& wrong) { wrong.mode.reset(); }},
                               {"start_pose", [](CheckQuestion& wrong) { wrong.start_sign = Sign::plus; }},
                               {"policy", [](CheckQuestion& wrong) { wrong.policy = CheckPolicy::serial; }},
                               {"", [](CheckQuestion& wrong) { wrong.path->back().time = 0.0; }},
                               {"mode",
                                [&](CheckQuestion& wrong) {
                                  wrong = of_joints(*robot);
                                  wrong.mode = mode_of_check;
                                }},
                               {"start_pose", [&](CheckQuestion& wrong) {
                                  wrong = of_joints(*robot);
                                  wrong.start_pose = check_from;
                                  wrong.start_sign = Sign::plus;
                                }}};
  Session session(robot);
  for (const Wrong& wrong : all) {
    CheckQuestion question = of_poses(check_from, check_to);
    wrong.change(question);
    const auto outcome = answer(session, question);
    ASSERT_EQ(outcome.status, MapStatus::refused) << wrong.field;
    EXPECT_EQ(outcome.problems.front().field, wrong.field);
  }
}

TEST(Check, ColumnsOfJointsAreByName) {
  const auto robot = test::five_bar();
  const std::string first = robot->leg(0).actuated_joint, second = robot->leg(1).actuated_joint;
  Problems problems;
  const JointColumns columns(*robot, {second, first}, "It", problems);
  EXPECT_EQ(columns.ordered({1.0, 2.0}, "q", problems), Eigen::Vector2d(2.0, 1.0));
  EXPECT_EQ(columns.ordered({}, "q", problems).size(), 0);
  EXPECT_EQ(problems, Problems());
  columns.ordered({1.0, 2.0, 3.0}, "q", problems);
  EXPECT_EQ(problems, Problems{"It has 3 numbers in q; give one a joint."});
  problems.clear();
  JointColumns(*robot, {first, "gripper"}, "It", problems);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_TRUE(test::begins(problems[0], "It has the unknown joint 'gripper'; there are '"));
  EXPECT_EQ(problems[1], "It does not have the joint '" + second + "' once; name every actuated joint.");
  problems.clear();
  JointColumns(*robot, {first, second + "t"}, "It", problems);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0], "It has the unknown joint '" + second + "t'; did you mean '" + second + "'?");
}

}  // namespace
}  // namespace parallel_aspects::ask
