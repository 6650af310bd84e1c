// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/inverse_direct.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <string>

namespace parallel_aspects::ask {
namespace {

InverseAnswer solved_at(Session& session, const Pose& pose) {
  InverseQuestion question;
  question.pose = pose;
  const auto outcome = answer(session, question);
  EXPECT_TRUE(outcome);
  return outcome.answer;
}

TEST(Inverse, EverySolutionHoldsThePoseInItsMode) {
  Session session(test::five_bar());
  const Pose pose = Pose::planar(4.5, 8.0);
  const InverseAnswer found = solved_at(session, pose);
  EXPECT_EQ(found.solutions.size(), working_modes(*session.robot()).size());
  for (const InverseInMode& each : found.solutions) {
    ASSERT_TRUE(each.solution);
    EXPECT_EQ(each.reason, "");
    DirectQuestion question;
    question.joints = each.solution.q;
    const DirectAnswer poses = answer(session, question).answer;
    EXPECT_TRUE(poses.within_limits);
    int same = 0;
    for (const DirectSolution& solution : poses.assembly_modes) {
      if ((solution.assembly.pose.position - pose.position).norm() > 1e-6) continue;
      ++same;
      EXPECT_EQ(solution.mode, each.solution.mode);
      EXPECT_NEAR(solution.indices.determinant, each.indices.value().determinant, 1e-5);
    }
    EXPECT_EQ(same, 1);
  }
}

TEST(Inverse, SaysWhyAPoseIsNotReached) {
  Session far(test::five_bar()), limited(test::shipped("bipod")->mapped_manipulator());
  const InverseInMode away = solved_at(far, Pose::planar(-1.0, 2.0)).solutions.at(0);
  EXPECT_TRUE(test::has(away.reason, "cannot reach"));
  EXPECT_FALSE(away.indices);
  const InverseInMode beyond = solved_at(limited, Pose::planar(0.4, 1.9595917)).solutions.at(0);
  EXPECT_TRUE(test::has(beyond.reason, " at 2 m, outside its limits [2, 6] by 9.2"));
  EXPECT_TRUE(beyond.indices);
}

TEST(Direct, TrivialSolutionsHaveNoMode) {
  Session session(test::shipped("agile_eye")->mapped_manipulator());
  DirectQuestion question;
  question.joints = Eigen::Vector3d(0.3, 0.2, -0.4);
  int trivial = 0;
  for (const DirectSolution& each : answer(session, question).answer.assembly_modes) {
    trivial += each.mode ? 0 : 1;
    EXPECT_EQ(each.mode.has_value(), !each.assembly.serially_singular);
  }
  EXPECT_EQ(trivial, 4);
}

TEST(Kinematics, NeedsWhatIsAsked) {
  Session session(test::five_bar());
  EXPECT_EQ(answer(session, InverseQuestion()).problems.at(0).field, "pose");
  EXPECT_EQ(answer(session, DirectQuestion()).problems.at(0).field, "joints");
}

}  // namespace
}  // namespace parallel_aspects::ask
