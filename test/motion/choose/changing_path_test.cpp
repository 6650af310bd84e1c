// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/choose_working_mode.h"

#include <gtest/gtest.h>

#include "support/path_samples.h"
#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::path_text;
using test::side;
using test::Waypoints;
using At = test::ConfigurationAt<long double>;

// Even in pose coordinates.
Pose straight(TaskSpace space, const Pose& from, const Pose& to, double share) {
  return *pose_from_coordinates(
      space, (1.0 - share) * pose_coordinates(space, from) + share * pose_coordinates(space, to));
}

Pose pose_at(const Waypoints& path, double time) {
  std::size_t i = 1;
  while (i + 1 < path.size() && path[i].time < time) ++i;
  return test::mixed_pose(
      path[i - 1].pose, path[i].pose,
      std::clamp((time - path[i - 1].time) / (path[i].time - path[i - 1].time), 0.0, 1.0));
}

// Samples of every piece and of every way to a singularity lie on one side of det A = 0, and the way ends at
// B_jj = 0 of the leg by which the modes differ.
void expect_feasible(const Manipulator& robot, const Waypoints& path, const ChangingPath& found) {
  ASSERT_EQ(found.pieces.size(), found.changes.size() + 1);
  EXPECT_EQ(found.pieces.front().start, path.front().time);
  EXPECT_EQ(found.pieces.back().end, path.back().time);
  const int sign = side(robot, path.front().pose, found.pieces.front().mode);
  ASSERT_NE(sign, 0);
  for (const PathPiece& piece : found.pieces)
    for (int k = 0; k <= 200; ++k)
      ASSERT_EQ(side(robot, pose_at(path, piece.start + (piece.end - piece.start) * k / 200), piece.mode),
                sign);
  for (std::size_t i = 0; i < found.changes.size(); ++i) {
    const PostureChange& change = found.changes[i];
    EXPECT_EQ(change.from, found.pieces[i].mode);
    EXPECT_EQ(change.to, found.pieces[i + 1].mode);
    EXPECT_EQ(change.time, found.pieces[i].end);
    EXPECT_EQ(change.time, found.pieces[i + 1].start);
    EXPECT_EQ(change.from.index() ^ change.to.index(), 1U << change.leg);
    for (int k = 0; k < 200; ++k)
      for (const WorkingMode& mode : {change.from, change.to})
        ASSERT_EQ(side(robot, straight(robot.task_space(), change.pose, change.singular, k / 200.0), mode),
                  sign)
            << k;
    EXPECT_NEAR(static_cast<double>(At(robot, change.singular, change.from).squared_serial()), 0.0, 1e-9);
    EXPECT_LT((pose_at(path, change.time).position - change.pose.position).norm(), 1e-12 * robot.size());
  }
}

class RandomPaths : public testing::TestWithParam<const char*> {
 protected:
  std::shared_ptr<const Manipulator> robot =
      test::shipped(GetParam())->manipulator()->with_constraints(ConstraintKinds{});
  SegmentCertifier certifier{robot};
  test::PosePairs pairs{robot, 20261123};
};

TEST_P(RandomPaths, WithChangesAreFeasibleByFormulasOfTheTest) {
  int one_mode = 0, changed = 0, refuted = 0, unknown = 0;
  for (int i = 0; i < test::thinned(robot->leg_count() == 2 ? 150 : 40); ++i) {
    const WorkingMode mode = pairs.mode();
    const auto from = pairs.reached(mode), to = pairs.reached(mode);
    if (!from || !to) continue;
    const Waypoints path{{0.0, *from}, {1.0, *to}};
    SCOPED_TRACE(path_text(*robot, path));
    const ChangingPath found = choose_posture_changes(certifier, path);
    const bool safe = choose_working_mode(certifier, path).answer == TrajectoryAnswer::safe;
    if (safe) {
      EXPECT_EQ(found.answer, TrajectoryAnswer::safe);
      EXPECT_TRUE(found.changes.empty());
    }
    if (found.answer == TrajectoryAnswer::safe) {
      expect_feasible(*robot, path, found);
      ++(found.changes.empty() ? one_mode : changed);
    }
    if (found.answer == TrajectoryAnswer::unknown) ++unknown;
    if (found.answer != TrajectoryAnswer::unsafe) continue;
    ++refuted;
    bool unreached = false;
    for (int k = 0; k <= 5000; ++k)
      unreached = unreached || side(*robot, pose_at(path, k / 5000.0), working_modes(*robot).front()) == 0;
    EXPECT_TRUE(unreached);
  }
  std::cout << GetParam() << ": one mode " << one_mode << ", changed " << changed << ", no " << refuted
            << ", unknown " << unknown << '\n';
  EXPECT_GT(one_mode, 0);
  if (!test::is_sanitized && robot->leg_count() == 2) {
    EXPECT_GT(changed, 5);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RandomPaths, testing::Values("five_bar", "three_rrr", "delta"),
                         [](const auto& each) { return std::string(each.param); });

// Crank 1 of 8 m about the origin and its rod of 5 m fold on the circle of 3 m about the origin.
TEST(PathOfTheFiveBar, IsChangedWhereTheWayToTheFoldedLegIsShortest) {
  const auto robot = test::shipped("five_bar")->manipulator()->with_constraints(ConstraintKinds{});
  const SegmentCertifier certifier(robot);
  const Waypoints path{{0.0, Pose::planar(2.0, -7.0)}, {1.0, Pose::planar(8.4, 8.8)}};
  EXPECT_EQ(choose_working_mode(certifier, path).answer, TrajectoryAnswer::unsafe);
  const ChangingPath found = choose_posture_changes(certifier, path);
  ASSERT_EQ(found.answer, TrajectoryAnswer::safe) << found.reason;
  ASSERT_EQ(found.changes.size(), 1U);
  expect_feasible(*robot, path, found);
  const PostureChange& change = found.changes.front();
  EXPECT_EQ(change.from, *WorkingMode::from_signs({-1, 1}));
  EXPECT_EQ(change.to, WorkingMode(2));
  EXPECT_EQ(robot->leg(change.leg).name, "leg_1");
  EXPECT_NEAR(change.singular.position.norm(), 3.0, 1e-6);
  // By brute force: both modes have one sign from the start to there, and from there to the end.
  const int sign = side(*robot, path.front().pose, change.from);
  double shortest = std::numeric_limits<double>::infinity(), where = 0.0;
  for (int k = 0; k <= 2000; ++k) {
    const auto keeps = [&](const WorkingMode& mode, int first, int last) {
      for (int n = first; n <= last; ++n)
        if (side(*robot, pose_at(path, n / 2000.0), mode) != sign) return false;
      return true;
    };
    const double way = 2.0 * (pose_at(path, k / 2000.0).position.norm() - 3.0);
    if (way >= shortest || !keeps(change.from, 0, k) || !keeps(change.to, k, 2000)) continue;
    shortest = way;
    where = k / 2000.0;
  }
  EXPECT_GE(change.detour, shortest - 1e-3);
  EXPECT_LE(change.detour, 1.05 * shortest);
  EXPECT_NEAR(change.time, where, 0.05);
}

// As many poses as a controller records: what is examined does not grow with them.
TEST(PathOfManyPoses, IsChosenAsThatOfFew) {
  const auto robot = test::shipped("five_bar")->manipulator();
  const SegmentCertifier certifier(robot);
  const auto circle = [](int poses) {
    Waypoints path;
    for (int i = 0; i < poses; ++i) {
      const double angle = 2.0 * EIGEN_PI * i / (poses - 1);
      path.push_back({1.0 * i / (poses - 1), Pose::planar(4.5 + std::cos(angle), 6.5 + std::sin(angle))});
    }
    return path;
  };
  const Waypoints many = circle(test::thinned(20000));
  const PathChoice few_found = choose_working_mode(certifier, circle(400)),
                   found = choose_working_mode(certifier, many);
  ASSERT_EQ(found.answer, TrajectoryAnswer::safe);
  EXPECT_EQ(found.modes.front().mode, few_found.modes.front().mode);
  ASSERT_TRUE(found.modes.front().clearance);
  EXPECT_LE(found.modes.front().clearance->measures, 201U);
  const double measured = few_found.modes.front().clearance->measured;
  EXPECT_GE(found.modes.front().clearance->lower, 0.9 * measured);
  EXPECT_LE(found.modes.front().clearance->lower, 1.01 * measured);
  EXPECT_EQ(choose_posture_changes(certifier, many).answer, TrajectoryAnswer::safe);
  std::atomic<bool> cancelled{true};
  EXPECT_EQ(choose_posture_changes(certifier, many, {{}, &cancelled}).answer, TrajectoryAnswer::unknown);
  cancelled = false;
  double share = 0.0;
  PathChoiceOptions options;
  options.control = {[&](double done) {
                       EXPECT_GE(done, share);
                       share = done;
                       cancelled = done > 0.3;
                     },
                     &cancelled};
  EXPECT_EQ(choose_working_mode(certifier, many, options).modes.back().check.answer,
            TrajectoryAnswer::unknown);
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.5);
}

TEST(PathWithoutALift, IsNotGuessed) {
  const auto robot = test::shipped("hexa")->manipulator()->with_constraints(ConstraintKinds{});
  test::PosePairs pairs(robot, 5);
  const WorkingMode mode = pairs.mode();
  const auto from = pairs.reached(mode), to = pairs.reached(mode);
  ASSERT_TRUE(from && to);
  const Waypoints path{{0.0, *from}, {1.0, *to}};
  const bool safe = choose_working_mode(SegmentCertifier(robot), path).answer == TrajectoryAnswer::safe;
  const ChangingPath found = choose_posture_changes(SegmentCertifier(robot), path);
  EXPECT_EQ(found.answer == TrajectoryAnswer::safe, safe) << found.reason;
  EXPECT_TRUE(found.changes.empty());
}

}  // namespace
}  // namespace parallel_aspects
