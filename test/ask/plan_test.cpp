// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/plan.h"

#include "parallel_aspects/aspects/connectivity.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include <atomic>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects::ask {
namespace {

/// Names of the fields of a question.
class FieldNames {
 public:
  template <class Value>
  void operator()(const Field& field, const Value& /*value*/) {
    names_.insert(field.name);
    with_names(field.help, [this](const std::string& name) {
      mentioned_.insert(name);
      return name;
    });
  }
  bool has(const std::string& name) const { return names_.count(name) != 0; }
  const std::set<std::string>& mentioned() const noexcept { return mentioned_; }

 private:
  std::set<std::string> names_, mentioned_;
};

FieldNames names_of_question() {
  FieldNames names;
  PlanQuestion question;
  describe(names, question);
  return names;
}

PlanQuestion between(const Pose& start, const Pose& goal) {
  PlanQuestion question;
  question.start.pose = start;
  question.goal.pose = goal;
  return question;
}

const Pose left = Pose::planar(4.5, 8.0), right = Pose::planar(4.0, 6.0);

struct Wrong {
  ProblemKind kind;
  std::string field;
  std::function<void(PlanQuestion&)> change;
};

void expect_refused(const std::shared_ptr<const Manipulator>& robot, const Pose& at, const Wrong& wrong) {
  static const FieldNames names = names_of_question();
  PlanQuestion question = between(at, at);
  wrong.change(question);
  Session session(robot);
  const auto outcome = answer(session, question);
  ASSERT_EQ(outcome.status, MapStatus::refused) << wrong.field;
  ASSERT_EQ(outcome.problems.size(), 1U) << wrong.field;
  const Problem& problem = outcome.problems.front();
  EXPECT_EQ(problem.kind, wrong.kind) << problem.fault;
  EXPECT_EQ(problem.field, wrong.field) << problem.fault;
  EXPECT_FALSE(problem.remedy.empty()) << problem.fault;
  text_of(problem, [&](const std::string& name) {
    EXPECT_TRUE(names.has(name)) << name << " is no field, but in: " << problem.fault;
    return name;
  });
}

TEST(PlanQuestion, NamesTheFieldAtFault) {
  const std::vector<Wrong> all{
      {ProblemKind::missing, "start", [](PlanQuestion& q) { q.start = {}; }},
      {ProblemKind::missing, "goal", [](PlanQuestion& q) { q.goal = {}; }},
      {ProblemKind::together, "start_aspect", [](PlanQuestion& q) { q.start.aspect.emplace().value = 1; }},
      {ProblemKind::value, "goal_aspect",
       [](PlanQuestion& q) {
         q.goal = {};
         q.goal.aspect.emplace().value = 99;
       }},
      {ProblemKind::value, "start_joints",
       [](PlanQuestion& q) { q.start.joints = JointVector(Eigen::Vector2d(1e13, 0.0)); }},
      {ProblemKind::value, "acceleration",
       [](PlanQuestion& q) { q.acceleration = JointVector(Eigen::Vector2d(1.0, 0.0)); }},
      {ProblemKind::together, "acceleration", [](PlanQuestion& q) { q.prefer = PathPreference::fast; }},
      {ProblemKind::robot, "policy",
       [](PlanQuestion& q) {
         q.roadmap.samples.emplace().value = 9;
         q.policy = PathPolicy::any;
       }},
      {ProblemKind::robot, "around_cusp", [](PlanQuestion& q) {
         q.goal = {};
         q.around_cusp.emplace().value = 1;
       }}};
  for (const Wrong& wrong : all) expect_refused(test::five_bar(), left, wrong);
}

TEST(PlanQuestion, NamesTheFieldAtFaultInSE3) {
  const std::vector<Wrong> all{
      {ProblemKind::robot, "policy", [](PlanQuestion& q) { q.policy = PathPolicy::any; }},
      {ProblemKind::robot, "load", [](PlanQuestion& q) { q.map.resolution = 0.1; }},
      {ProblemKind::robot, "start_aspect", [](PlanQuestion& q) {
         q.start = {};
         q.start.aspect.emplace().value = 1;
       }}};
  const auto robot = test::shipped("stewart")->mapped_manipulator();
  Pose home;
  home.position.z() = 1.3;
  for (const Wrong& wrong : all) expect_refused(robot, home, wrong);
}

// Each face writes what stands in braces, so that must be a field.
TEST(FieldsOfPlan, MentionFieldsAlone) {
  const FieldNames question = names_of_question();
  for (const std::string& name : question.mentioned()) EXPECT_TRUE(question.has(name)) << name;
  FieldNames answers;
  describe(answers, PlanAnswer());
  for (const std::string& name : answers.mentioned()) EXPECT_TRUE(question.has(name)) << name;
}

// Whoever has a map is not made to wait for another.
TEST(Session, AsksTheMapThatIsKnown) {
  const auto robot = test::five_bar();
  const auto map = compute_aspect_map(robot).map;
  Session session(robot);
  session.know(map);
  const auto known = answer(session, between(left, right));
  ASSERT_TRUE(known);
  EXPECT_EQ(known.answer.map, map);
  PlanQuestion finer = between(left, right);
  finer.map.resolution = map->resolution() / 2.0;
  const auto computed = answer(session, finer);
  ASSERT_TRUE(computed);
  EXPECT_NE(computed.answer.map, map);
  EXPECT_EQ(computed.answer.path.answer, known.answer.path.answer);
}

TEST(PlanQuestion, AsksARoadmapWhereSamplesAreGiven) {
  PlanQuestion question = between(left, right);
  question.roadmap.samples.emplace().value = 50;
  Session session(test::five_bar());
  const auto outcome = answer(session, question);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome.answer.map, nullptr);
  EXPECT_EQ(outcome.answer.path.answer, SameAspect::yes) << outcome.answer.path.message;
  session.know(compute_aspect_map(test::five_bar()).map);
  EXPECT_EQ(answer(session, question).status, MapStatus::refused);
}

// A finer map of a slice is one of the slice.
TEST(Session, StaysInTheSliceThatIsKnown) {
  const auto robot = test::five_bar();
  MapOptions options;
  options.slice = test::slice_of(robot, {{"x", 4.5}});
  options.modes = {*WorkingMode::from_signs({1, 1})};
  Session session(robot);
  session.know(compute_aspect_map(robot, options).map);
  PlanQuestion question = between(left, Pose::planar(4.5, 6.0));
  question.map.resolution = 0.05;
  const auto outcome = answer(session, question);
  ASSERT_TRUE(outcome);
  ASSERT_TRUE(outcome.answer.map && outcome.answer.map->slice());
  EXPECT_EQ(outcome.answer.map->working_modes(), options.modes);
  ASSERT_TRUE(outcome.answer.path) << outcome.answer.path.message;
  for (const PathPoint& point : outcome.answer.path.points) EXPECT_NEAR(point.pose.position.x(), 4.5, 1e-9);
}

TEST(Session, KeepsTheMapThatItComputed) {
  Session session(test::five_bar());
  const auto first = answer(session, between(left, right)), second = answer(session, between(right, left));
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_NE(first.answer.map, nullptr);
  EXPECT_EQ(first.answer.map, second.answer.map);
}

TEST(Session, EndsWhereItIsCancelled) {
  const std::atomic<bool> cancelled{true};
  Control control;
  control.cancelled = &cancelled;
  Session session(test::five_bar());
  EXPECT_EQ(answer(session, between(left, right), control).status, MapStatus::cancelled);
}

}  // namespace
}  // namespace parallel_aspects::ask
