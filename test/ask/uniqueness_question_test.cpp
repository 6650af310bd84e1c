// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/uniqueness_question.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects::ask {
namespace {

UniquenessAnswer found(Session& session, const UniquenessQuestion& question) {
  const auto outcome = answer(session, question);
  EXPECT_TRUE(outcome) << (outcome.problems.empty() ? "" : text_of(outcome.problems.front(), plain_name));
  return outcome.answer;
}

TEST(UniquenessAsked, OfTheoremsAsksTheMapThatIsThere) {
  const auto robot = test::five_bar();
  MapOptions options;
  options.resolution = 0.5;
  const auto map = compute_aspect_map(robot, options).map;
  Session session(robot);
  session.know(map);
  const auto uniqueness = std::get<0>(found(session, {}).found);
  EXPECT_EQ(uniqueness->map, map);
  EXPECT_TRUE(uniqueness->at_most_one_a_sign);
  UniquenessQuestion finer;
  finer.resolution = 0.25;
  EXPECT_NE(std::get<0>(found(session, finer).found)->map, map);
}

TEST(UniquenessAsked, OfASliceIsThatOfTheLibrary) {
  const auto robot = test::shipped("three_rpr")->mapped_manipulator();
  Session session(robot);
  UniquenessQuestion question;
  question.slice = HeldJoint{0, 14.98, false};
  const auto uniqueness = std::get<0>(found(session, question).found);
  const CuspList cusps = find_cusps(*robot, *question.slice);
  ASSERT_EQ(uniqueness->cusps.size(), cusps.cusps.size());
  EXPECT_EQ(uniqueness->cusps_complete, cusps.complete);
  EXPECT_FALSE(uniqueness->domains.empty());
  int below = 0;
  for (const BasicRegion& region : uniqueness->basic_regions) {
    const auto component = component_below(*uniqueness, region);
    if (!component) continue;
    ++below;
    EXPECT_FALSE(uniqueness->basic_components.at(*component).solutions.empty());
  }
  EXPECT_GT(below, 0);
}

TEST(UniquenessAsked, FollowsCuspsOverAJoint) {
  Session session(test::shipped("three_rpr")->mapped_manipulator());
  UniquenessQuestion question;
  question.cusps_over = HeldRange{0, 26.0, 26.1};
  const auto curves = std::get<CuspsOverJoint>(found(session, question).found);
  EXPECT_EQ(curves.joint, "strut_1_joint");
  EXPECT_EQ(curves.unit, "m");
  EXPECT_TRUE(curves.found.complete);
}

TEST(UniquenessAsked, OfAHexapodLooksAtARoadmap) {
  Session session(test::shipped("stewart")->mapped_manipulator());
  UniquenessQuestion question;
  question.roadmap.samples = Count<1, 100000>{20};
  question.poses = Count<1, 1000000>{2};
  const auto survey = std::get<SurveyOfRoadmap>(found(session, question).found);
  EXPECT_EQ(survey.roadmap->poses().size(), 20U);
  EXPECT_EQ(survey.survey.poses, 2U);
}

TEST(UniquenessAsked, IsRefusedWithTheFieldAtFault) {
  struct Wrong {
    std::string robot, text;
    std::function<void(UniquenessQuestion&)> change;
  };
  const auto held = [](UniquenessQuestion& wrong) { wrong.slice = HeldJoint{0, 1.0, true}; };
  const auto samples = [](UniquenessQuestion& wrong) { wrong.roadmap.samples = Count<1, 100000>{9}; };
  const auto both = [](UniquenessQuestion& wrong) {
    wrong.slice = HeldJoint{0, 12.0, false};
    wrong.cusps_over = HeldRange{0, 12.0, 13.0};
  };
  const auto coarse_slice = [](UniquenessQuestion& wrong) {
    wrong.slice = HeldJoint{0, 0.3, true};
    wrong.resolution = 0.1;
  };
  const std::vector<Wrong> all{
      {"five_bar", "In T2 every aspect is a uniqueness domain as a whole; leave slice out.", held},
      {"five_bar", "samples is of the roadmap of SO3 or SE3, and 'five_bar' moves in T2; leave it out.",
       samples},
      {"stewart", "In SE3 a roadmap is examined, which has no slice; leave it out.", held},
      {"three_rpr", "cusps_over lists curves of cusps alone; leave slice or it out.", both},
      {"spherical_3rrr",
       "In SO3 slice lists cusps and numbers of direct solutions alone; leave resolution or it out.",
       coarse_slice}};
  for (const Wrong& wrong : all) {
    Session session(test::shipped(wrong.robot)->mapped_manipulator());
    UniquenessQuestion question;
    wrong.change(question);
    const auto outcome = answer(session, question);
    ASSERT_EQ(outcome.problems.size(), 1U) << wrong.text;
    EXPECT_EQ(text_of(outcome.problems.front(), plain_name), wrong.text);
  }
}

}  // namespace
}  // namespace parallel_aspects::ask
