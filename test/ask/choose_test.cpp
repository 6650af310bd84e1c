// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/choose.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects::ask {
namespace {

ChooseQuestion along(const Pose& first, const Pose& last) {
  ChooseQuestion question;
  question.path = {{0.0, first}, {1.0, last}};
  return question;
}

const Pose path_from = Pose::planar(3.0, 6.0), path_to = Pose::planar(5.0, 7.0);

TEST(Choose, ReportsAspectsOfAMapUnlessItIsBrief) {
  Session session(test::five_bar());
  ChooseQuestion question = along(path_from, path_to);
  const auto whole = answer(session, question);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole.answer.verdict(), TrajectoryAnswer::safe);
  EXPECT_EQ(whole.answer.prefer, Preference::clear);
  EXPECT_GT(whole.answer.path.modes.front().aspect, 0);
  EXPECT_FALSE(whole.answer.with_changes);
  Session other(test::five_bar());
  question.brief = question.changes = true;
  const auto brief = answer(other, question);
  ASSERT_TRUE(brief);
  EXPECT_EQ(brief.answer.path.modes.front().aspect, 0) << "no map is known";
  EXPECT_TRUE(brief.answer.with_changes);
}

TEST(Choose, OfARegionOrOfALineOfIt) {
  Session session(test::five_bar());
  ChooseQuestion question;
  question.region = {{"y", 5.0, 8.0}, {"x", 3.0, 6.0}};
  const auto found = answer(session, question);
  ASSERT_TRUE(found);
  EXPECT_EQ(found.answer.verdict(), TrajectoryAnswer::safe);
  EXPECT_GT(found.answer.region.modes.front().least_index.lower, 0.0);
  EXPECT_FALSE(found.answer.prefer);
  question.region = {{"x", -3.0, 12.0}, {"y", -10.0, 10.0}};
  EXPECT_EQ(answer(session, question).answer.apart().value().size(), 2U);
}

TEST(Choose, IsRefusedWithTheFieldAtFault) {
  struct Wrong {
    std::string field;
    std::function<void(ChooseQuestion&)> change;
  };
  const auto to_region = [](ChooseQuestion& wrong) {
    wrong.path.reset();
    wrong.region = {{"x", 3.0, 6.0}, {"y", 5.0, 8.0}};
  };
  const std::vector<Wrong> all{{"path", [](ChooseQuestion& wrong) { wrong.path.reset(); }},
                               {"path",
                                [](ChooseQuestion& wrong) {
                                  wrong.region = {{"x", 3.0, 6.0}};
                                }},
                               {"slice", [](ChooseQuestion& wrong) { wrong.hold.emplace(); }},
                               {"prefer",
                                [&](ChooseQuestion& wrong) {
                                  to_region(wrong);
                                  wrong.prefer = Preference::fast;
                                }},
                               {"changes",
                                [&](ChooseQuestion& wrong) {
                                  to_region(wrong);
                                  wrong.changes = true;
                                }},
                               {"region",
                                [&](ChooseQuestion& wrong) {
                                  to_region(wrong);
                                  wrong.region.pop_back();
                                }},
                               {"region", [&](ChooseQuestion& wrong) {
                                  to_region(wrong);
                                  wrong.region.front().lower = 7.0;
                                }}};
  Session session(test::five_bar());
  for (const Wrong& wrong : all) {
    ChooseQuestion question = along(path_from, path_to);
    wrong.change(question);
    const auto outcome = answer(session, question);
    ASSERT_EQ(outcome.status, MapStatus::refused) << wrong.field;
    EXPECT_EQ(outcome.problems.front().field, wrong.field);
  }
  ChooseQuestion empty;
  empty.path.emplace();
  EXPECT_EQ(answer(session, empty).problems.front().kind, ProblemKind::told) << "no waypoint";
}

}  // namespace
}  // namespace parallel_aspects::ask
