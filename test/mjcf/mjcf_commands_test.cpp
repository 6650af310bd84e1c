// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/five_bar_setup.h"
#include "support/styles.h"
#include <string>

namespace parallel_aspects {
namespace {

const std::string robot = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/mjcf/five_bar.xml";

TEST(MjcfCommands, SetupWritesAYamlThatAllCommandsTake) { test::expect_five_bar_is_set_up(robot); }

TEST(MjcfCommands, DescribeTakesTheFileAlone) {
  const test::Outcome described = test::run({"describe", robot.c_str()});
  EXPECT_EQ(described.code, tools::exit_code::ok) << described.messages;
  EXPECT_NE(described.output.find("fully parallel, task space T2"), std::string::npos) << described.output;
}

TEST(MjcfCommands, SetupFindsRobotsInStylesThatArePublished) {
  test::expect_found({"five_bar_leg.xml", TaskSpace::T2, "trunk", "foot", {"front_hip", "rear_hip"}, {0.2}});
  test::expect_found(
      {"delta_of_sites.xml", TaskSpace::T3, "base", "tcp", {"motor1", "motor2", "motor3"}, {0.5}});
}

}  // namespace
}  // namespace parallel_aspects
