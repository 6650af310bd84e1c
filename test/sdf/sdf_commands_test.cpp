// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/five_bar_setup.h"
#include "support/styles.h"
#include <string>

namespace parallel_aspects {
namespace {

const std::string robot = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/sdf/five_bar.sdf";

TEST(SdfCommands, SetupWritesAYamlThatAllCommandsTake) {
  test::expect_five_bar_is_set_up(robot, {"--actuated", "crank_1_joint crank_2_joint"});
}

TEST(SdfCommands, DescribeTakesTheFileAlone) {
  const test::Outcome described = test::run({"describe", robot.c_str()});
  EXPECT_EQ(described.code, tools::exit_code::ok) << described.messages;
  EXPECT_NE(described.output.find("actuated"), std::string::npos) << "which joints are is a guess";
}

std::vector<std::string> six_of(const std::string& joint) {
  std::vector<std::string> joints;
  for (int leg = 1; leg <= 6; ++leg) joints.push_back(joint + "_" + std::to_string(leg));
  return joints;
}

TEST(SdfCommands, SetupFindsRobotsInStylesThatArePublished) {
  test::expect_found({"stewart_universal.sdf", TaskSpace::SE3, "base", "top", six_of("piston"), {0.641641}});
  test::expect_found({"hexaglide.sdf", TaskSpace::SE3, "world", "nacelle", six_of("rail"), {0.75}});
}

}  // namespace
}  // namespace parallel_aspects
