// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/distance.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects::ask {
namespace {

DistanceQuestion from(const Pose& pose) {
  DistanceQuestion question;
  question.pose = pose;
  return question;
}

const Pose above = Pose::planar(4.5, 8.0);

TEST(Distance, IsThatOfAMeterInEveryMode) {
  const auto robot = test::five_bar();
  Session session(robot);
  const auto outcome = answer(session, from(above));
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome.answer.answers.size(), working_modes(*robot).size());
  BoundaryDistanceMeter meter(robot);
  for (const DistancesInMode& each : outcome.answer.answers) {
    const BoundaryDistances measured = meter.measure(above, each.mode);
    EXPECT_EQ(each.distances.parallel.lower, measured.parallel.lower);
    EXPECT_EQ(each.distances.serial.upper, measured.serial.upper);
    EXPECT_FALSE(each.parallel().leg);
    ASSERT_TRUE(each.serial().leg);
    EXPECT_EQ(each.serial().leg->index, measured.serial.leg);
    EXPECT_FALSE(each.actuated_limit().limit) << "there is none";
  }
  EXPECT_FALSE(outcome.answer.loaded) << "no map was asked";
}

TEST(Distance, AsksTheMapThatIsThereUnlessItIsOfASlice) {
  const auto robot = test::five_bar();
  MapOptions options;
  options.resolution = 0.5;
  Session alone(robot), with_map(robot), with_slice(robot);
  with_map.know(compute_aspect_map(robot, options).map);
  options.slice = test::slice_of(robot, {{"y", 8.0}});
  with_slice.know(compute_aspect_map(robot, options).map);
  const auto boxes = [](Session& session) {
    DistanceQuestion question = from(above);
    question.mode = *WorkingMode::from_signs({-1, 1});
    return answer(session, question).answer.answers.at(0).distances.parallel.boxes;
  };
  EXPECT_LT(boxes(with_map), boxes(alone));
  EXPECT_EQ(boxes(with_slice), boxes(alone));
}

TEST(Distance, OfAPoseOutOfReachIsUnavailable) {
  Session session(test::five_bar());
  const DistancesInMode found = answer(session, from(Pose::planar(4.5, 80.0))).answer.answers.at(0);
  EXPECT_FALSE(found.is_reached());
  EXPECT_EQ(found.distances.parallel.status, DistanceStatus::unavailable);
  EXPECT_TRUE(found.missed_margins.empty());
}

TEST(Distance, IsRefusedWithTheFieldAtFault) {
  struct Wrong {
    std::string robot, field;
    ProblemKind kind;
    std::function<void(DistanceQuestion&)> change;
  };
  const std::vector<Wrong> all{
      {"five_bar", "pose", ProblemKind::missing, [](DistanceQuestion& wrong) { wrong.pose.reset(); }},
      {"five_bar", "tolerance", ProblemKind::value, [](DistanceQuestion& wrong) { wrong.tolerance = 1.0; }},
      {"stewart", "map", ProblemKind::robot, [](DistanceQuestion& wrong) { wrong.map.load = "none.map"; }}};
  for (const Wrong& wrong : all) {
    Session session(test::shipped(wrong.robot)->mapped_manipulator());
    DistanceQuestion question = from(above);
    wrong.change(question);
    const auto outcome = answer(session, question);
    ASSERT_EQ(outcome.status, MapStatus::refused) << wrong.field;
    EXPECT_EQ(outcome.problems.front().field, wrong.field);
    EXPECT_EQ(outcome.problems.front().kind, wrong.kind);
  }
}

}  // namespace
}  // namespace parallel_aspects::ask
