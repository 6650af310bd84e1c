// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/tracker.h"

#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <cmath>
#include <limits>
#include <random>

namespace parallel_aspects {
namespace {

const auto robot = test::five_bar();

JointVector joints(double q1, double q2) {
  JointVector q(2);
  q << q1, q2;
  return q;
}

Pose at(double x, double y) {
  Pose pose;
  pose.position << x, y, 0.0;
  return pose;
}

JointVector joint_values(const Pose& pose, int s1, int s2) {
  return inverse(*robot, pose, *WorkingMode::from_signs({s1, s2})).q;
}

TEST(Tracker, StartsAtTheDirectSolutionNearThePose) {
  Tracker tracker(robot);
  const JointVector q = joint_values(at(4.5, 8.0), -1, -1);
  ASSERT_TRUE(tracker.start_near(0.0, q, at(4.6, 7.9), 0.2));
  EXPECT_NEAR((tracker.state().pose.position - at(4.5, 8.0).position).norm(), 0.0, 1e-12);
  EXPECT_EQ(to_string(tracker.state().mode), "(-,-)");
  EXPECT_EQ(tracker.state().determinant_sign, 1);
}

TEST(Tracker, AStartThatFailsChangesNothing) {
  Tracker tracker(robot);
  const JointVector q = joint_values(at(4.5, 8.0), -1, -1);
  ASSERT_TRUE(tracker.start_near(0.0, q, at(4.5, 8.0), 0.2));
  tracker.update(0.1, q, joints(1e-6, 1e-6));
  const TrackedState before = tracker.state();
  const JointVector bend = tracker.bend();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const JointVector stretched = joints(0.0, joint_values(at(13.0, 0.0), 1, -1)[1]);
  EXPECT_FALSE(tracker.start_near(1.0, q, at(6.0, 8.0), 0.2)) << "too far away";
  EXPECT_FALSE(tracker.start_near(1.0, joints(nan, 0.0), at(4.5, 8.0), 0.2));
  EXPECT_FALSE(tracker.start_near(1.0, q, at(nan, 8.0), 0.2));
  EXPECT_FALSE(tracker.start_near(1.0, q, at(4.5, 8.0), 0.2, joints(10.0, 10.0))) << "too uncertain";
  EXPECT_FALSE(tracker.start_near(1.0, stretched, at(13.0, 0.0), 1e-3)) << "of no working mode";
  EXPECT_FALSE(tracker.start_with_sign(1.0, joints(EIGEN_PI, 0.0), 1)) << "cannot be assembled so";
  EXPECT_EQ(tracker.state().status, TrackStatus::tracking);
  EXPECT_EQ(tracker.state().time, before.time);
  EXPECT_EQ(tracker.state().q, before.q);
  EXPECT_EQ(tracker.state().spread, before.spread);
  EXPECT_EQ(tracker.bend(), bend);
  EXPECT_TRUE(tracker.update(0.2, q).followed());
  EXPECT_TRUE(tracker.update(0.3, joint_values(at(4.5, 8.01), -1, -1)).followed());
}

TEST(Tracker, StartsByTheSignOfTheDeterminant) {
  Tracker tracker(robot);
  const JointVector q = joint_values(at(4.5, 8.0), -1, -1);
  ASSERT_TRUE(tracker.start_with_sign(0.0, q, 1));
  EXPECT_NEAR((tracker.state().pose.position - at(4.5, 8.0).position).norm(), 0.0, 1e-12);
  ASSERT_TRUE(tracker.start_with_sign(0.0, q, -1));
  EXPECT_GT((tracker.state().pose.position - at(4.5, 8.0).position).norm(), 1.0);
}

TEST(Tracker, IgnoresWhatIsNotFinite) {
  Tracker tracker(robot);
  ASSERT_TRUE(tracker.start_with_sign(0.0, joint_values(at(4.5, 8.0), -1, -1), 1));
  const Eigen::Vector3d before = tracker.state().pose.position;
  tracker.update(1.0, joints(std::numeric_limits<double>::quiet_NaN(), 0.0));
  tracker.update(1.0, joints(0.0, std::numeric_limits<double>::infinity()));
  tracker.update(std::numeric_limits<double>::quiet_NaN(), joints(0.0, 0.0));
  tracker.update(1.0, JointVector(3));
  EXPECT_EQ(tracker.state().time, 0.0);
  EXPECT_EQ(tracker.state().pose.position, before);
  EXPECT_EQ(tracker.state().status, TrackStatus::tracking);
}

// Ground truth is the closed form: in T2 the two direct solutions differ in the sign of det A, which only
// vanishes where they meet. So a right answer is the solution with the sign of the start, for as long as one
// is given.
TEST(Tracker, NeverLeavesTheAssemblyModeInSilence) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-3.0, 3.0);
  int followed = 0, lost = 0;
  for (const double step : {0.01, 0.1, 0.5, 2.0}) {
    std::normal_distribution<double> change(0.0, step);
    for (int run = 0; run < 200; ++run) {
      Tracker tracker(robot);
      JointVector q = joints(angle(random), angle(random));
      if (!tracker.start_with_sign(0.0, q, run % 2 == 0 ? 1 : -1)) continue;
      for (int i = 1; i < 100 && tracker.state().status == TrackStatus::tracking; ++i) {
        q += joints(change(random), change(random));
        tracker.update(0.01 * i, q);
        if (tracker.state().status != TrackStatus::tracking) {
          ++lost;
          break;
        }
        ++followed;
        const DirectResult truth = direct(*robot, q);
        ASSERT_EQ(truth.solutions.size(), 2U);
        const AssemblyMode& expected = truth.solutions[run % 2 == 0 ? 0 : 1];
        ASSERT_LT((tracker.state().pose.position - expected.pose.position).norm(), 1e-8)
            << "run " << run << " step " << i << " q " << q.transpose();
      }
    }
  }
  EXPECT_GT(followed, 5000);
  EXPECT_GT(lost, 10);
}

// From (4.5, 8) actuated revolute joint 1 pulls the platform to the left, away from base point 2: leg 2 goes
// through its stretched position and comes out in the other posture, with det A of the same sign.
TEST(Tracker, ReportsTheLegAndTimeOfAWorkingModeChange) {
  Tracker tracker(robot);
  JointVector q = joint_values(at(4.5, 8.0), -1, -1);
  ASSERT_TRUE(tracker.start_with_sign(0.0, q, 1));
  std::vector<Transition> seen;
  for (int i = 1; i <= 4000 && seen.empty(); ++i) {
    q[0] += 0.001;
    tracker.update(i * 0.001, q);
    seen.insert(seen.end(), tracker.transitions().begin(), tracker.transitions().end());
  }
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].kind, TransitionKind::working_mode);
  EXPECT_EQ(seen[0].leg, 1U);
  EXPECT_EQ(to_string(seen[0].mode_before), "(-,-)");
  EXPECT_EQ(to_string(seen[0].mode_after), "(-,+)");
  // At the time told, B_22 is zero.
  TrackerOptions straight;
  straight.samples.path_bend = 0.0;
  straight.samples.longest_interval = std::numeric_limits<double>::infinity();
  Tracker again(robot, straight);
  const JointVector start = joint_values(at(4.5, 8.0), -1, -1);
  ASSERT_TRUE(again.start_with_sign(0.0, start, 1));
  const JointVector there = start + joints(seen[0].time, 0.0);
  again.update(1.0, there);
  EXPECT_NEAR(inverse_diagonal(*robot, again.state().pose, there)[1], 0.0, 1e-4);
}

TEST(Tracker, TouchingASerialSingularityIsNoChange) {
  Tracker tracker(robot);
  const JointVector start = joint_values(at(4.5, 8.0), -1, -1);
  ASSERT_TRUE(tracker.start_with_sign(0.0, start, 1));
  JointVector q = start;
  double closest = 1e9;
  // Find the turn at which leg 2 is stretched, from a first pass.
  double turn = 0.0;
  for (int i = 1; i <= 40000; ++i) {
    q[0] = start[0] + 1e-4 * i;
    tracker.update(1e-4 * i, q);
    if (tracker.state().status != TrackStatus::tracking || !tracker.transitions().empty()) break;
    const double entry = std::abs(inverse_diagonal(*robot, tracker.state().pose, q)[1]);
    if (entry < closest) {
      closest = entry;
      turn = q[0] - start[0];
    }
  }
  ASSERT_GT(turn, 0.0);
  ASSERT_TRUE(tracker.start_with_sign(0.0, start, 1));
  for (int i = 0; i <= 1000; ++i) {
    tracker.update(1e-4 * (i + 1), start + joints(turn * std::sin(EIGEN_PI * i / 1000.0), 0.0));
    EXPECT_TRUE(tracker.transitions().empty());
  }
  EXPECT_EQ(to_string(tracker.state().mode), "(-,-)");
}

// Actuated joints that pull the two cranks' tips apart until the rods are in line: det A = 0.
TEST(Tracker, SaysThatItIsLostAtAParallelSingularity) {
  Tracker tracker(robot);
  JointVector q = joint_values(at(4.5, 8.0), -1, 1);
  ASSERT_TRUE(tracker.start_near(0.0, q, at(4.5, 8.0), 1e-6));
  int lost = 0;
  for (int i = 1; i <= 3000; ++i) {
    q += joints(0.001, -0.001);
    tracker.update(i * 0.001, q);
    for (const Transition& each : tracker.transitions()) {
      lost += each.kind == TransitionKind::lost;
      EXPECT_EQ(each.determinant, each.kind == TransitionKind::lost);
    }
  }
  EXPECT_EQ(lost, 1);
  EXPECT_EQ(tracker.state().status, TrackStatus::ambiguous);
  EXPECT_EQ(tracker.state().aspect, 0);
}

TEST(Tracker, ReportsTheAspectsBeforeAndAfter) {
  const auto map = compute_aspect_map(robot).map;
  ASSERT_TRUE(map);
  Tracker tracker(robot);
  JointVector q = joint_values(at(4.5, 8.0), -1, -1);
  ASSERT_TRUE(tracker.start_with_sign(0.0, q, 1));
  tracker.set_map(map);
  const int first = tracker.state().aspect;
  ASSERT_NE(first, 0);
  int before = 0, after = 0;
  for (int i = 1; i <= 4000 && after == 0; ++i) {
    q[0] += 0.001;
    tracker.update(i * 0.001, q);
    for (const Transition& each : tracker.transitions()) {
      if (each.kind == TransitionKind::working_mode) before = each.aspect_before;
      after = each.aspect_after;
    }
  }
  EXPECT_EQ(before, first);
  ASSERT_NE(after, 0);
  const Aspect& reached = map->aspects()[static_cast<std::size_t>(after - 1)];
  EXPECT_EQ(to_string(reached.mode), "(-,+)");
  EXPECT_EQ(reached.determinant_sign, 1);
}

// Lost, and told where it is: the aspect comes from unknown, not from itself.
TEST(Tracker, AnAspectThatBecomesKnownAgainWasUnknownBefore) {
  Tracker tracker(robot);
  tracker.set_map(compute_aspect_map(robot).map);
  const JointVector q = joint_values(at(4.5, 8.0), -1, -1);
  ASSERT_TRUE(tracker.start_with_sign(0.0, q, 1));
  const int aspect = tracker.state().aspect;
  ASSERT_NE(aspect, 0);
  ASSERT_EQ(tracker.take_transitions().count, 1U);
  ASSERT_TRUE(tracker.start_with_sign(0.1, q, 1));
  EXPECT_TRUE(tracker.take_transitions().empty()) << "nothing has changed";
  ASSERT_FALSE(tracker.update(9.0, q).followed());
  EXPECT_EQ(tracker.take_transitions().begin()->kind, TransitionKind::lost);
  ASSERT_TRUE(tracker.start_with_sign(9.0, q, 1));
  const Transitions told = tracker.take_transitions();
  ASSERT_EQ(told.count, 1U);
  EXPECT_EQ(told.begin()->aspect_before, 0);
  EXPECT_EQ(told.begin()->aspect_after, aspect);
}

}  // namespace
}  // namespace parallel_aspects
