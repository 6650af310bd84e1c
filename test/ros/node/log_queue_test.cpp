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
  log.warn("the stamp is 0.1 s ahead");
  EXPECT_EQ(log.take_warnings(at(0.0)), Lines{"the stamp is 0.1 s ahead"});
  for (int i = 0; i < 4; ++i) {
    log.warn("the stamp is 0." + std::to_string(i) + " s ahead");
    EXPECT_TRUE(log.take_warnings(at(1.0 + i)).empty());
  }
  EXPECT_EQ(log.take_warnings(at(5.1)), Lines{"the stamp is 0.3 s ahead"});
  EXPECT_TRUE(log.take_warnings(at(20.0)).empty());
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
