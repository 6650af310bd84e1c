// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/config/map_and_motion_config.h"

#include <gtest/gtest.h>

#include "support/texts.h"
#include <string>

namespace parallel_aspects {
namespace {

TEST(MotionConfig, HasAnAccelerationForEachActuatedJoint) {
  Problems problems;
  const JointVector acceleration =
      read_acceleration("motion: {acceleration: [1.5, 20]}", "robot.yaml", 2, problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_EQ(acceleration.size(), 2);
  EXPECT_EQ(acceleration[0], 1.5);
  EXPECT_EQ(acceleration[1], 20.0);
}

TEST(MotionConfig, IsEmptyWhereNothingIsStated) {
  Problems problems;
  for (const char* text : {"", "map: {}", "motion:", "motion: {}", "{no yaml", "- list"})
    EXPECT_EQ(read_acceleration(text, "robot.yaml", 2, problems).size(), 0) << text;
  EXPECT_TRUE(problems.empty());
}

TEST(MotionConfig, SaysWhatIsWrong) {
  for (const char* text : {"motion: 3", "motion: {acceleration: 3}", "motion: {acceleration: [1]}",
                           "motion: {acceleration: [1, 2, 3]}", "motion: {acceleration: [1, 0]}",
                           "motion: {acceleration: [1, -2]}", "motion: {acceleration: [1, .inf]}",
                           "motion: {acceleration: [1, .nan]}", "motion: {acceleration: [1, fast]}",
                           "motion: {speed: [1, 1]}"}) {
    Problems problems;
    EXPECT_EQ(read_acceleration(text, "robot.yaml", 2, problems).size(), 0) << text;
    ASSERT_EQ(problems.size(), 1U) << text;
    EXPECT_TRUE(test::begins(problems.front(), "robot.yaml "));
  }
}

}  // namespace
}  // namespace parallel_aspects
