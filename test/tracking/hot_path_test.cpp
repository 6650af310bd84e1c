// SPDX-License-Identifier: BSD-3-Clause
//
// The hot path asks for no memory: what malloc is asked for is counted while the tracker works.
#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/hazards.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/counted_allocations.h"
#include "support/robots/robots.h"
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

static_assert(noexcept(std::declval<Tracker&>().update(0.0, std::declval<const JointVector&>())));
static_assert(noexcept(std::declval<DistanceThresholds&>().update({})));
static_assert(noexcept(std::declval<ApproachSpeed&>().add(0.0, 0.0)));
static_assert(noexcept(std::declval<HazardMemory&>().see(std::declval<const DistanceThresholds&>(), {},
                                                         0.0)));

struct Seen {
  long updates = 0, crossings = 0, losses = 0, gaps = 0, candidates = 0, assembly_modes = 0, silences = 0,
       allocations = 0;
};

// Random walks through crossings, losses and gaps; after a loss the candidates are followed for a while.
Seen walk(const std::shared_ptr<const Manipulator>& robot, const JointVector& start, double size, int runs) {
  Seen seen;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Tracker tracker(robot);
  DistanceThresholds thresholds;
  HazardMemory hazards;
  ApproachSpeed speed;
  for (int run = 0; run < runs; ++run) {
    JointVector q = start, direction = start;
    const DirectResult solutions = direct(*robot, q);
    if (!tracker.start_near(
            0.0, q, solutions.solutions[static_cast<std::size_t>(run) % solutions.solutions.size()].pose,
            1e-3))
      continue;
    double time = 0.0;
    for (int i = 0; i < 300; ++i) {
      if (i % 50 == 0)
        for (double& entry : coefficients_of(direction)) entry = size * uniform(random);
      q += direction;
      if (i % 97 == 96) q += 100.0 * direction;
      if (i % 113 == 112) time += 0.1;
      if (i == 120) q[0] = std::numeric_limits<double>::quiet_NaN();
      const bool followed = tracker.state().followed();
      const long before = allocations;
      tracker.update(time += 0.001, q);
      thresholds.update({0.1, 0.2, 0.3});
      hazards.see(thresholds, {}, time);
      if (i % 7 == 0) hazards.lose();
      speed.add(time, tracker.state().pose.position.norm());
      tracker.report_residual(speed.speed(), i % 40 == 0);
      seen.allocations += allocations - before;
      if (i == 120) q[0] = start[0];
      ++seen.updates;
      seen.candidates += static_cast<long>(tracker.candidates().size());
      for (const Transition& each : tracker.transitions()) {
        seen.crossings += each.kind == TransitionKind::working_mode;
        seen.assembly_modes += each.kind == TransitionKind::assembly_mode;
      }
      if (!followed || tracker.state().followed()) continue;
      ++seen.losses;
      const Ambiguity why = tracker.state().ambiguity;
      seen.gaps += why == Ambiguity::gap;
      seen.silences += why == Ambiguity::silence || why == Ambiguity::pause;
      tracker.find_candidates();
    }
  }
  return seen;
}

std::shared_ptr<const Manipulator> with_velocity(const Manipulator& robot, double velocity) {
  std::vector<Leg> legs = robot.legs();
  for (Leg& leg : legs) leg.limits.velocity = velocity;
  return test::manipulator(robot.name(), robot.task_space(), std::move(legs));
}

TEST(HotPath, IsCountedByWhatWorks) {
  ASSERT_TRUE(counting);
  const long before = allocations;
  const auto number = std::make_unique<double>(1.0);
  const Eigen::VectorXd vector = Eigen::VectorXd::Constant(100, *number);
  EXPECT_GE(allocations, before + 2) << vector.size();
}

TEST(HotPath, AllocatesNothing) {
  const auto five_bar = with_velocity(*test::five_bar(), 50.0);
  Pose pose;
  pose.position << 4.5, 8.0, 0.0;
  const JointVector q = inverse(*five_bar, pose, *WorkingMode::from_signs({-1, -1})).q;
  const Seen planar = walk(five_bar, q, 0.03, 300);
  EXPECT_EQ(planar.allocations, 0);
  EXPECT_GT(planar.updates, 10000);
  EXPECT_GT(planar.crossings, 10);
  EXPECT_GT(planar.losses, 30);
  EXPECT_GT(planar.gaps, 10);
  EXPECT_GT(planar.candidates, 100);
}

TEST(HotPath, AllocatesNothingWithSixCandidates) {
  JointVector q(3);
  q << 14.98, 15.38, 12.0;
  const Seen seen = walk(test::three_rpr(), q, 0.02, 30);
  EXPECT_EQ(seen.allocations, 0);
  EXPECT_GT(seen.losses, 5);
  EXPECT_GT(seen.silences, 5);
  EXPECT_GT(seen.candidates, 100);
}

TEST(HotPath, AllocatesNothingInSpace) {
  Pose pose;
  pose.position << 0.05, 0.02, 0.62;
  const auto robot = test::stewart();
  const JointVector q = inverse(*robot, pose, working_modes(*robot).front()).q;
  const Seen seen = walk(robot, q, 0.0005, 4);
  EXPECT_EQ(seen.allocations, 0);
  EXPECT_GT(seen.updates, 1000);
}

}  // namespace
}  // namespace parallel_aspects
