// SPDX-License-Identifier: BSD-3-Clause
//
// The guard takes its memory when it is made: what malloc is asked for is counted while it works.
#include "parallel_aspects/motion/motion_guard.h"

#include <gtest/gtest.h>

#include "support/counted_allocations.h"
#include "support/guard_campaign.h"
#include "support/robots/shipped.h"
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

TEST(GuardMemory, HookCounts) {
  ASSERT_TRUE(counting);
  const long before = allocations;
  const std::vector<double> numbers(100);
  EXPECT_GT(allocations, before) << numbers.size();
}

TEST(GuardMemory, GuardingTakesNone) {
  for (const std::string name : {"five_bar", "three_rrr", "delta", "spherical_3rrr", "stewart"}) {
    const auto robot = test::shipped(name)->manipulator();
    const GuardOptions options = test::guard_options_for(*robot);
    test::GuardLoop loop(robot, options);
    test::PosePairs random(robot, 5);
    MotionGuard guard(robot, options);
    const auto start = test::draw_start(random, loop, Hazard::parallel_singularity, options);
    ASSERT_TRUE(start) << name;
    const BoundaryDistances measured = loop.measure(start->pose, start->mode);
    const ProvedDistances proved = test::proved_of(measured, start->pose, start->mode);
    const TaskVector towards = 0.3 * robot->size() * measured.parallel.direction;
    long taken = 0;
    for (int i = 0; i < 200; ++i) {
      const double time = 0.002 * i;
      const Pose pose = pose_between(start->pose, measured.parallel.witness, 0.005 * i);
      const TrackedState state = test::tracked_at(*robot, pose, start->mode, time);
      if (!state.followed()) break;
      const long before = allocations;
      guard.guard(state, proved, i % 50 < 40 ? towards : TaskVector(-towards), time);
      guard.guard_joints(state, proved, 0.01 * state.q, time);
      if (i % 70 == 69) guard.halt(time);
      taken += allocations - before;
    }
    EXPECT_EQ(taken, 0) << name;
  }
}

}  // namespace
}  // namespace parallel_aspects
