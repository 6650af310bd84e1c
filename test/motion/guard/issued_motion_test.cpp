// SPDX-License-Identifier: BSD-3-Clause
#include "motion/guard/issued_motion.h"

#include <gtest/gtest.h>

namespace parallel_aspects {
namespace {

constexpr double latency = 0.02, oldest_sample = 0.05;

TaskVector along(double x) { return (TaskVector(2) << x, 0.0).finished(); }

double seconds_left(const IssuedMotion& issued, double seen, double now) {
  IssuedMotion::Pending pending;
  issued.pending(seen, now, pending);
  double seconds = 0.0;
  for (std::size_t i = 0; i < pending.count; ++i)
    if (!pending.list[i].twist.isZero(0.0)) seconds += pending.list[i].seconds;
  return seconds;
}

TEST(IssuedMotion, IsPendingForTheLatency) {
  IssuedMotion issued(latency, oldest_sample, 0);
  ASSERT_TRUE(issued.issue(0.0, along(1.0), 0.0));
  EXPECT_NEAR(seconds_left(issued, 0.01, 0.01), 0.01, 1e-12);
  ASSERT_TRUE(issued.issue(0.01, along(0.0), 0.0));
  // It was in force for 10 ms, and may have begun up to 20 ms late.
  EXPECT_NEAR(seconds_left(issued, 0.01, 0.02), 0.01, 1e-12);
  EXPECT_NEAR(seconds_left(issued, 0.025, 0.03), 0.005, 1e-12);
  EXPECT_EQ(seconds_left(issued, 0.031, 0.04), 0.0);
}

TEST(IssuedMotion, KeepsCommandsWhileTheRobotBrakes) {
  IssuedMotion issued(latency, oldest_sample, 0);
  ASSERT_TRUE(issued.issue(0.0, along(1.0), 0.5));
  ASSERT_TRUE(issued.issue(0.01, along(0.0), 0.0));
  IssuedMotion::Pending pending;
  issued.pending(0.4, 0.4, pending);
  ASSERT_EQ(pending.count, 2U);
  EXPECT_EQ(pending.list[0].brake, 0.5);
  EXPECT_EQ(pending.list[0].seconds, 0.0);
}

TEST(IssuedMotion, MergesWhatFollowsQuickly) {
  IssuedMotion issued(latency, oldest_sample, 1);
  for (int i = 0; i < 100000; ++i)
    ASSERT_TRUE(issued.issue(1e-4 * i, (TaskVector(2) << 0.1 + 1e-7 * i, 0.2).finished(), 0.1)) << i;
  IssuedMotion::Pending pending;
  issued.pending(10.0, 10.0, pending);
  EXPECT_LT(pending.count, IssuedMotion::most);
  for (std::size_t i = 0; i < pending.count; ++i) {
    EXPECT_LT(pending.list[i].turn_off, 1e-4);
    EXPECT_EQ(pending.list[i].slide_off, 0.0);
  }
}

TEST(IssuedMotion, RefusesMoreThanItKeeps) {
  IssuedMotion issued(latency, oldest_sample, 0);
  bool refused = false;
  for (int i = 0; i < 1000; ++i) {
    const double brake = i == 0 ? 100.0 : 0.0;
    refused = refused || !issued.issue(0.01 * i, along(1.0 + i), brake);
  }
  EXPECT_TRUE(refused);
}

TEST(IssuedMotion, BeginsAnewWhenTimeGoesBack) {
  IssuedMotion issued(latency, oldest_sample, 0);
  ASSERT_TRUE(issued.issue(100.0, along(1.0), 0.5));
  ASSERT_TRUE(issued.issue(1.0, along(0.0), 0.0));
  EXPECT_EQ(seconds_left(issued, 1.0, 1.01), 0.0);
}

}  // namespace
}  // namespace parallel_aspects
