// SPDX-License-Identifier: BSD-3-Clause
#include "ros/plan/cusp_question.h"

#include "parallel_aspects/aspects/aspect_map.h"
#include "ros/messages/conversions.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
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
  CuspPath ask(PathEnd from, unsigned cusp, const std::string& joint) const {
    PlanPathGoal goal;
    goal.around_cusp = cusp;
    goal.held_joint = joint;
    std::optional<CuspQuestion> question;
    const Status status = read_cusp(*robot_, goal, from, question);
    EXPECT_EQ(status.code, Status::OK) << status.message;
    return plan_around_cusp(robot_, from, question.value(), {});
  }

  const std::shared_ptr<const Manipulator> robot_ = test::shipped("three_rpr")->mapped_manipulator();
};

// The deepest pose of the other component, whose actuated values no other of its poses has.
TEST_F(CuspQuestions, AreAnsweredWithAStartThatHasAPath) {
  MapOptions options;
  options.slice = test::slice_of(robot_, {{"strut_1_joint", 14.98}});
  const auto map = compute_aspect_map(robot_, options).map;
  const CuspPath none = ask({map->aspects().at(1).deepest, {}}, 1, "strut_1_joint");
  ASSERT_FALSE(none.path);
  EXPECT_NE(none.path.message.find("Cusp 1 belongs to component 1 of the slice"), std::string::npos)
      << none.path.message;
  const CuspPath found = ask(named_start(*robot_, none.path.message), 1, "strut_1_joint");
  EXPECT_TRUE(found.path) << found.path.message;
  EXPECT_NE(found.turns_around_cusps.at(0), 0);
}

}  // namespace
}  // namespace parallel_aspects
