// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/five_bar_setup.h"
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

}  // namespace
}  // namespace parallel_aspects
