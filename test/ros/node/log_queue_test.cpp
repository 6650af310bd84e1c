// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/log_queue.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Lines = std::vector<std::string>;

ros::SteadyTime at(double seconds) { return ros::SteadyTime(1000.0 + seconds); }

TEST(LogQueue, WritesOneCauseEveryFiveSecondsAndTheNewestLineOfIt) {
  LogQueue log;
  log.warn("the stamp is 0.1 s ahead", at(0.0));
  EXPECT_EQ(log.take_warnings(at(0.0)), Lines{"the stamp is 0.1 s ahead"});
  for (int i = 0; i < 4; ++i) {
    log.warn("the stamp is 0." + std::to_string(i) + " s ahead", at(1.0 + i));
    EXPECT_TRUE(log.take_warnings(at(1.0 + i)).empty());
  }
  EXPECT_EQ(log.take_warnings(at(5.1)), Lines{"the stamp is 0.3 s ahead"});
  EXPECT_TRUE(log.take_warnings(at(20.0)).empty());
}

// What waits for its five seconds is not written once the fault has ended; what is new is.
TEST(LogQueue, WhatHasEndedIsNotSaidLater) {
  LogQueue log;
  log.warn("the clock stands still", at(0.0));
  log.withdraw();
  EXPECT_EQ(log.take_warnings(at(0.1)).size(), 1U) << "it stood still";
  log.warn("the clock stands still", at(1.0));
  log.withdraw();
  EXPECT_TRUE(log.take_warnings(at(5.2)).empty());
  log.warn("the clock stands still", at(6.0));
  log.withdraw();
  EXPECT_EQ(log.take_warnings(at(6.1)).size(), 1U);
}

TEST(LogQueue, WritesAnotherCauseAtOnce) {
  LogQueue log;
  log.warn("joint gripper is ignored.");
  EXPECT_EQ(log.take_warnings(at(0.0)).size(), 1U);
  log.warn("both /one and /two publish the actuated joints");
  log.warn("joint gripper is ignored.");
  EXPECT_EQ(log.take_warnings(at(0.1)), Lines{"both /one and /two publish the actuated joints"});
  log.warn("the last usable joint_states are older than 0.5 s.");
  EXPECT_EQ(log.take_warnings(at(0.2)).size(), 1U);
}

TEST(LogQueue, CausesWithoutEndAreNoFlood) {
  LogQueue log;
  std::size_t written = 0;
  for (int i = 0; i < 1000; ++i) {
    log.warn("joint x" + std::string(static_cast<std::size_t>(i % 100), 'y') + " is ignored.");
    written += log.take_warnings(at(0.001 * i)).size();
  }
  EXPECT_EQ(written, 10U);
}

}  // namespace
}  // namespace parallel_aspects
