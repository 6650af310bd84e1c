// SPDX-License-Identifier: BSD-3-Clause
#include "ros/questions/plan_question.h"

#include "ask/question_parts.h"
#include "parallel_aspects/ask/jacobian.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "ros/messages/conversions.h"

#include <gtest/gtest.h>
#include <ros/message_traits.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include <cstdlib>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

/// The numbers in the brackets that follow these words; none where these are not there.
std::vector<double> numbers_behind(const std::string& words, const std::string& text) {
  std::vector<double> numbers;
  const std::size_t at = text.find(words);
  if (at == std::string::npos) return numbers;
  const char* next = text.c_str() + at + words.size();
  for (char* end = nullptr;; next = end + 1) {
    numbers.push_back(std::strtod(next, &end));
    if (*end != ',') return numbers;
  }
}

/// The start that an answer names, as a goal would have it.
PathEnd named_start(const Manipulator& robot, const std::string& answer) {
  const std::vector<double> at = numbers_behind("position (", answer),
                            turned = numbers_behind("orientation (", answer),
                            signs = numbers_behind("working_mode [", answer);
  EXPECT_EQ(at.size(), 3U) << answer;
  EXPECT_EQ(turned.size(), 4U) << answer;
  EXPECT_EQ(signs.size(), robot.leg_count()) << answer;
  geometry_msgs::Pose pose;
  pose.position.x = at.at(0), pose.position.y = at.at(1), pose.position.z = at.at(2);
  pose.orientation.x = turned.at(0), pose.orientation.y = turned.at(1);
  pose.orientation.z = turned.at(2), pose.orientation.w = turned.at(3);
  return {pose_from_base(robot, pose).value(),
          WorkingMode::from_signs(std::vector<int>(signs.begin(), signs.end())),
          {}};
}

class CuspQuestions : public testing::Test {
 protected:
  PlanPathResult ask(const PathEnd& from, unsigned cusp, const std::string& joint) const {
    PlanPathGoal goal;
    goal.path_only = true;
    goal.around_cusp = cusp;
    goal.held_joint = joint;
    ask::PlanQuestion question;
    question.start.pose = from.pose;
    question.start.mode = from.mode;
    const Status status = read_wish(*robot_, goal, question);
    EXPECT_EQ(status.code, Status::OK) << status.message;
    ask::Session session(robot_);
    const auto outcome = ask::answer(session, question);
    EXPECT_TRUE(outcome) << refused(outcome.problems).message;
    PlanPathResult result;
    write_answer(*robot_, outcome.answer, result);
    return result;
  }

  const std::shared_ptr<const Manipulator> robot_ = test::shipped("three_rpr")->mapped_manipulator();
};

// The deepest pose of the other component, whose actuated values no other of its poses has.
TEST_F(CuspQuestions, AreAnsweredWithAStartThatHasAPath) {
  MapOptions options;
  options.slice = test::slice_of(robot_, {{"strut_1_joint", 14.98}});
  const auto map = compute_aspect_map(robot_, options).map;
  const PlanPathResult none = ask({map->aspects().at(1).deepest, {}}, 1, "strut_1_joint");
  ASSERT_NE(none.answer, PlanPathResult::YES);
  EXPECT_NE(none.reason.find("Cusp 1 belongs to component 1 of the slice"), std::string::npos) << none.reason;
  const PlanPathResult found = ask(named_start(*robot_, none.reason), 1, "strut_1_joint");
  EXPECT_EQ(found.answer, PlanPathResult::YES) << found.reason;
  EXPECT_NE(found.turns_around_cusps.at(0), 0);
  EXPECT_GT(found.encoder_noise, 0.0);
}

// What a question has, the message has, but for what a node has no need of.
class FieldsOfMessages {
 public:
  explicit FieldsOfMessages(const std::string& definition) {
    static const std::regex comment("#[^\n]*");
    definition_ = "\n" + std::regex_replace(definition, comment, "");
  }

  template <class Value>
  void operator()(const ask::Field& field, const Value& /*value*/) {
    if (definition_.find(" " + field.name + " ") == std::string::npos &&
        definition_.find(" " + field.name + "\n") == std::string::npos)
      missing_.push_back(field.name);
  }
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  std::string definition_;
  std::vector<std::string> missing_;
};

TEST(FieldsOfQuestion, HaveTheirTwinInTheMessage) {
  FieldsOfMessages fields(ros::message_traits::Definition<PlanPathGoal>::value());
  ask::PlanQuestion question;
  describe(fields, question);
  // A Configuration has the first ones; held_names, held_values and held_joint are `slice`; maps, roadmaps
  // and accelerations are those of the node's parameters.
  const std::vector<std::string> others{
      "start_mode", "start_joints", "start_aspect", "goal_mode", "goal_joints", "goal_aspect", "resolution",
      "slice",      "load",         "save",         "samples",   "seed",        "acceleration"};
  EXPECT_EQ(fields.missing(), others);
}

TEST(FieldsOfAnswer, HaveTheirTwinInTheMessage) {
  FieldsOfMessages fields(ros::message_traits::Definition<PlanPathResult>::value());
  describe(fields, ask::PlanAnswer());
  // Those of the goal and of the node's map; yes and no are proved, and `reason` names another start.
  const std::vector<std::string> others{"policy",      "prefer",      "proved", "slice",
                                        "around_cusp", "other_start", "loaded"};
  EXPECT_EQ(fields.missing(), others);
}

TEST(FieldsOfJacobian, HaveTheirTwinInTheMessage) {
  FieldsOfMessages fields(ros::message_traits::Definition<Jacobian>::value());
  describe(fields, ask::JacobianAnswer());
  describe(fields, ask::JacobianAt());
  // A SolvedConfiguration has joint_names and joint_positions, and tells what is beyond limits by its status.
  const std::vector<std::string> others{"task_space",     "direct_status", "actuated_joints",
                                        "configurations", "joints",        "within_limits"};
  EXPECT_EQ(fields.missing(), others);
}

TEST(JacobianMessage, IsRowByRow) {
  const auto robot = test::shipped("three_rpr")->manipulator();
  const AssembledConfiguration home = test::shipped("three_rpr")->home();
  const ask::JacobianAt at = ask::jacobian_at(*robot, home.pose, home.q);
  const Jacobian message =
      jacobian_message(*robot, ask::configuration_of(*robot, home.pose, home.q), ros::Time());
  EXPECT_EQ(message.status, Jacobian::REGULAR);
  EXPECT_EQ(message.twist, (std::vector<std::string>{"wz", "vx", "vy"}));
  ASSERT_EQ(message.jacobian.size(), 9U);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto k = static_cast<std::size_t>(3 * i + j);
      EXPECT_EQ(message.a.at(k), at.a.value()(i, j));
      EXPECT_EQ(message.jacobian.at(k), at.jacobian.value()(i, j));
      EXPECT_EQ(message.inverse_jacobian.at(k), at.inverse_jacobian.value()(i, j));
      EXPECT_EQ(message.force_transmission.at(k), at.inverse_jacobian.value()(j, i));
    }
  EXPECT_EQ(message.condition_number, at.condition_number.value());
}

}  // namespace
}  // namespace parallel_aspects
