// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/configurations.h"

#include "ros/monitor/five_bar_setup.h"

#include <gtest/gtest.h>

namespace parallel_aspects {
namespace {

// `[0]` is what the completion of rosservice fills in.
TEST(ConfigurationsAtPose, TakeEveryWorkingModeUnlessOneIsNamed) {
  const auto mechanism = test::five_bar_mechanism();
  const auto at = [&](const std::vector<std::int8_t>& mode) {
    return configurations_at_pose(*mechanism->manipulator(), test::pose_at(4.5, 8.0), mode);
  };
  for (const std::vector<std::int8_t>& any : {std::vector<std::int8_t>{}, {0}, {0, 0}})
    EXPECT_EQ(at(any).configurations.size(), 4U);
  EXPECT_EQ(at({1, -1}).configurations.size(), 1U);
  for (const std::vector<std::int8_t>& wrong : {std::vector<std::int8_t>{1}, {1, 0}, {1, 2}, {1, 1, 1}})
    EXPECT_EQ(at(wrong).status.code, Status::INVALID_REQUEST);
}

}  // namespace
}  // namespace parallel_aspects
