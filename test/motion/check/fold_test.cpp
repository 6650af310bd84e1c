// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/fold.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "tracking/continuation.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {
namespace {

class Folds : public testing::TestWithParam<const char*> {
 protected:
  std::shared_ptr<const Manipulator> robot = test::shipped(GetParam())->manipulator()->with_constraints({});
  SegmentCertifier certifier{robot};
  PoseCertifier poses{*robot};
  test::PosePairs pairs{robot, 20261125};

  // The fold that is proved from a share of the way on, to which the platform is followed straight.
  std::optional<double> latest(const Pose& start, const JointWaypoint& from, const JointWaypoint& to,
                               double share) const {
    CertifiedPoint point;
    if (!certify_solution(poses, start, from.q, point)) return std::nullopt;
    Continuation way(poses, point, from.q + share * (to.q - from.q));
    if (way.run(1000) != ContinuationStatus::finished) return std::nullopt;
    const RoundingUpward upward;
    const JointPath path(from, to);
    const TaskVector still = TaskVector::Zero(from.q.size());
    const TaskVector rounding = TaskVector::Constant(from.q.size(), 1e-12);
    const CertifiedBall ball = poses.ball(way.at(), still, rounding, 0.0, 0.0);
    if (!ball.certified) return std::nullopt;
    return FoldProof(*robot, poses, path).latest(way.at(), ball.radius, 0.0, share, 1.0);
  }
};

// From half way, where the solutions are far from a fold: what is safe has none, and others not too early.
TEST_P(Folds, AreProvedExactlyWhereTheyAre) {
  int safe = 0, folded = 0, proved = 0;
  for (int i = 0; i < test::thinned(100); ++i) {
    const WorkingMode mode = pairs.mode();
    const auto start = pairs.reached(mode);
    const auto end = start ? pairs.nearby(*start, mode) : std::nullopt;
    if (!end) continue;
    const JointWaypoint from{0.0, inverse(*robot, *start, mode).q, {}, {}};
    const JointWaypoint to{1.0, inverse(*robot, *end, mode).q, {}, {}};
    SCOPED_TRACE(to_string(robot->task_space(), *start) + " to " + to_string(robot->task_space(), *end) +
                 " in " + to_string(mode));
    const TrajectoryCheck check = check_trajectory(certifier, {from, to}, {*start, 0});
    const bool meets = !check.crossings.empty() && !check.crossings.back().leg;
    const auto found = latest(*start, from, to, 0.5 * check.followed_until);
    if (meets && found) {
      EXPECT_GE(*found, check.crossings.back().after);
      EXPECT_LE(*found, 1.0);
    }
    if (!meets && check.not_followed.empty()) {
      EXPECT_FALSE(found) << *found;
      ++safe;
    }
    folded += meets ? 1 : 0;
    proved += meets && found ? 1 : 0;
  }
  std::cout << GetParam() << ": " << safe << " without, " << folded << " with a fold, " << proved
            << " of them proved from half way\n";
  EXPECT_TRUE(test::is_sanitized || safe > 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, Folds,
                         testing::Values("five_bar", "three_rpr", "three_rrr", "delta", "spherical_3rrr",
                                         "stewart"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace parallel_aspects
