// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/workspace.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects::ask {
namespace {

LargestShapeQuestion largest(RegularShape shape) {
  LargestShapeQuestion question;
  question.shape.shape = shape;
  question.shape.gap = 0.1;
  question.map.resolution = 0.5;
  return question;
}

TEST(LargestShape, IsThatOfTheMapInEachAspect) {
  const auto robot = test::five_bar();
  Session session(robot);
  const auto outcome = answer(session, largest(RegularShape::disc));
  ASSERT_TRUE(outcome);
  const LargestShapeAnswer& found = outcome.answer;
  ASSERT_EQ(found.workspaces.size(), found.map->aspects().size());
  ASSERT_NE(found.best(), nullptr);
  for (const ShapeInAspect& each : found.workspaces) {
    const Aspect& aspect = found.map->aspects().at(static_cast<std::size_t>(each.found.aspect - 1));
    EXPECT_EQ(each.mode, aspect.mode);
    EXPECT_EQ(each.determinant_sign, aspect.determinant_sign);
    EXPECT_LE(each.found.lower, found.best()->found.lower);
    ASSERT_EQ(each.lengths.size(), 1U);
    EXPECT_EQ(each.lengths.front().second, each.found.lower);
  }
}

TEST(LargestShape, OfWorkingModesAndAspectsOfAMapThatIsThere) {
  const auto robot = test::five_bar();
  Session session(robot);
  MapOptions options;
  options.resolution = 0.5;
  session.know(compute_aspect_map(robot, options).map);
  LargestShapeQuestion question = largest(RegularShape::square);
  question.map = {};
  question.modes = {*WorkingMode::from_signs({1, -1})};
  const auto in_mode = answer(session, question);
  ASSERT_TRUE(in_mode);
  ASSERT_FALSE(in_mode.answer.workspaces.empty());
  for (const ShapeInAspect& each : in_mode.answer.workspaces) EXPECT_EQ(each.mode, question.modes.front());
  question.aspects.emplace_back().value = 1;
  EXPECT_EQ(answer(session, question).status, MapStatus::refused) << "aspect 1 is of another mode";
  question.modes.clear();
  question.aspects.emplace_back().value = 3;
  EXPECT_EQ(answer(session, question).answer.workspaces.size(), 2U);
}

TEST(LargestShape, OfACylinderHasTheRatioOfHeightToDiameter) {
  const auto robot = test::linear_delta();
  ShapeQuestion shape;
  shape.shape = RegularShape::cylinder;
  shape.aspect_ratio = {2.0, 1.0};
  ProblemList problems;
  EXPECT_EQ(shape.of(*robot, std::nullopt, problems).ratio, std::vector<double>{0.5});
  EXPECT_TRUE(problems.empty());
}

TEST(LargestShape, IsRefusedWithTheFieldAtFault) {
  struct Wrong {
    std::string field;
    std::function<void(LargestShapeQuestion&)> change;
  };
  const std::vector<Wrong> all{
      {"shape", [](LargestShapeQuestion& wrong) { wrong.shape.shape.reset(); }},
      {"gap", [](LargestShapeQuestion& wrong) { wrong.shape.gap = 1.0; }},
      {"center",
       [](LargestShapeQuestion& wrong) {
         wrong.shape.center = {{"z", 1.0}};
       }},
      {"aspect_ratio",
       [](LargestShapeQuestion& wrong) {
         wrong.shape.aspect_ratio = {1.0, 2.0, 3.0};
       }},
      {"orientation",
       [](LargestShapeQuestion& wrong) {
         wrong.shape.orientation = {{"phi", 0.0, 1.0}};
       }},
      {"aspect", [](LargestShapeQuestion& wrong) { wrong.aspects.emplace_back().value = 11; }}};
  Session session(test::five_bar());
  for (const Wrong& wrong : all) {
    LargestShapeQuestion question = largest(RegularShape::box);
    wrong.change(question);
    const auto outcome = answer(session, question);
    ASSERT_EQ(outcome.status, MapStatus::refused) << wrong.field;
    EXPECT_EQ(outcome.problems.front().field, wrong.field);
  }
  EXPECT_EQ(answer(session, largest(RegularShape::ball)).problems.front().kind, ProblemKind::told)
      << "which takes three positions";
}

}  // namespace
}  // namespace parallel_aspects::ask
