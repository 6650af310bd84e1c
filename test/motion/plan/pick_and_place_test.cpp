// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/pick_and_place.h"

#include "motion/demo_rounds.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double interval = 0.01;  // from one sample to the next [s]

struct Start {
  std::shared_ptr<const AspectMap> map;
  Pose pose;
  WorkingMode mode;
};

Start start_of(const std::string& name, double resolution = 0.0) {
  const auto mechanism = test::shipped(name);
  MapOptions options;
  if (resolution > 0.0) options.resolution = resolution;
  const AssembledConfiguration home = mechanism->assembled();
  return {compute_aspect_map(mechanism->manipulator(), options).map, home.pose,
          *working_mode(*mechanism->manipulator(), home.pose, home.q)};
}

SampledMotion rehearsed(const Start& start, const std::vector<JointVector>& corners) {
  Rehearsal rehearsal(start.map->manipulator(), {}, interval);
  EXPECT_TRUE(rehearsal.start(start.pose, corners.front()));
  return rehearsal.slow_enough(corners, 20.0);
}

PickAndPlace task_of(const Start& start) {
  return plan_pick_and_place(start.map, start.pose, start.mode, [&](const std::vector<JointVector>& corners) {
    return !rehearsed(start, corners).samples.empty();
  });
}

double distance(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() + a.orientation.angularDistance(b.orientation);
}

/// What a tracker sees on the round, sample by sample.
struct Round {
  bool followed = true;
  int changes = 0;         // of the working mode
  bool keeps_sign = true;  // of det A, by the samples
  double to_pick = 1e9, to_place = 1e9;
  Pose end;
  WorkingMode end_mode;
};

Round play(const Start& start, const PickAndPlace& task) {
  const auto robot = start.map->manipulator();
  SampledMotion motion = rehearsed(start, task.joint_values);
  motion.samples.push_back(task.joint_values.back());
  Tracker tracker(robot);
  Round round;
  round.followed = tracker.start_near(0.0, task.joint_values.front(), start.pose, 1e-6 * robot->size());
  const double sign = direct_determinant(*robot, start.pose, task.joint_values.front());
  double time = 0.0;
  for (const JointVector& q : motion.samples) {
    round.followed = tracker.update(time += interval, q).followed() && round.followed;
    for (const Transition& each : tracker.transitions())
      round.changes += each.kind == TransitionKind::working_mode ? 1 : 0;
    const Pose& pose = tracker.state().pose;
    round.keeps_sign = round.keeps_sign && sign * direct_determinant(*robot, pose, q) > 0.0;
    round.to_pick = std::min(round.to_pick, distance(pose, task.pick));
    round.to_place = std::min(round.to_place, distance(pose, task.place));
  }
  round.end = tracker.state().pose;
  round.end_mode = tracker.state().mode;
  return round;
}

void expect_done(const Start& start, const PickAndPlace& task) {
  ASSERT_TRUE(task) << task.reason;
  ASSERT_TRUE(task.carry) << task.carry.message;
  EXPECT_FALSE(task.carry.crossings.empty());
  EXPECT_EQ(task.carry.points.front().mode, start.mode);
  EXPECT_NE(task.carry.points.back().mode, start.mode);
  const Round round = play(start, task);
  EXPECT_TRUE(round.followed);
  EXPECT_TRUE(round.keeps_sign);
  EXPECT_GE(round.changes, 2) << "there and back";
  EXPECT_LT(round.to_pick, 1e-6);
  EXPECT_LT(round.to_place, 1e-6);
  EXPECT_LT(distance(round.end, start.pose), 1e-6);
  EXPECT_EQ(round.end_mode, start.mode);
}

TEST(PickAndPlace, ChangesTheWorkingModeOfTheFiveBar) {
  const Start start = start_of("five_bar");
  const PickAndPlace task = task_of(start);
  expect_done(start, task);
  EXPECT_NE(task.reason.find(" cannot do it. Proved: "), std::string::npos) << task.reason;
  EXPECT_NE(task.reason.find("through a gate at x "), std::string::npos) << task.reason;
}

// That the aspect of the start cannot do it, by plain arithmetic: its sign of det A is not that of the place.
TEST(PickAndPlace, IsBeyondTheAspectOfTheStart) {
  const Start start = start_of("five_bar");
  const Manipulator& robot = *start.map->manipulator();
  const PickAndPlace task = task_of(start);
  ASSERT_TRUE(task) << task.reason;
  const InverseSolution pick = inverse(robot, task.pick, start.mode),
                        place = inverse(robot, task.place, start.mode);
  ASSERT_EQ(pick.status, InverseStatus::solved);
  ASSERT_EQ(place.status, InverseStatus::solved);
  EXPECT_LT(direct_determinant(robot, task.pick, pick.q) * direct_determinant(robot, task.place, place.q),
            0.0);
}

TEST(PickAndPlace, ChangesTheWorkingModeOfThe3Rrr) {
  if (test::is_sanitized) GTEST_SKIP() << "takes long there";
  const Start start = start_of("three_rrr", 1.0);
  expect_done(start, task_of(start));
}

TEST(PickAndPlace, ChangesTheWorkingModeOfThe3Prr) {
  if (test::is_sanitized) GTEST_SKIP() << "takes long there";
  const Start start = start_of("three_prr");
  expect_done(start, task_of(start));
}

TEST(PickAndPlace, ChangesTheWorkingModeOfTheDelta) {
  if (test::is_sanitized) GTEST_SKIP() << "takes long there";
  const Start start = start_of("delta", 0.1);
  expect_done(start, task_of(start));
}

TEST(PickAndPlace, SaysWhyThereIsNone) {
  const PickAndPlace task = task_of(start_of("bipod"));
  EXPECT_FALSE(task);
  EXPECT_EQ(task.reason.find("No pick and place: no serial gate leads from aspect "), 0U) << task.reason;
}

TEST(PickAndPlace, IsRefusedWhereNoRoundIsAccepted) {
  const Start start = start_of("five_bar");
  int asked = 0;
  const PickAndPlace task =
      plan_pick_and_place(start.map, start.pose, start.mode, [&](const std::vector<JointVector>&) {
        ++asked;
        return false;
      });
  EXPECT_FALSE(task);
  EXPECT_GT(asked, 1);
  EXPECT_EQ(task.reason,
            "No pick and place: every one that was planned comes too close to a singularity to be followed.");
}

TEST(PickAndPlace, EndsWhereItIsCancelled) {
  const Start start = start_of("five_bar");
  const std::atomic<bool> cancelled{true};
  MapControl control;
  control.cancelled = &cancelled;
  const auto accepts = [](const std::vector<JointVector>&) { return true; };
  const PickAndPlace task = plan_pick_and_place(start.map, start.pose, start.mode, accepts, control);
  EXPECT_FALSE(task);
  EXPECT_EQ(task.reason, "No pick and place: none was found in time.");
}

}  // namespace
}  // namespace parallel_aspects
