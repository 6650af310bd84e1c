// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/command_run.h"
#include <filesystem>

namespace parallel_aspects {
namespace {

namespace fs = std::filesystem;

const std::string robot = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/mjcf/five_bar.xml";

// Only a URDF can be launched.
TEST(MjcfCommands, SetupWritesAYamlThatAllCommandsTake) {
  std::string folder = (fs::temp_directory_path() / "mjcf_XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::string config = folder + "/robot.yaml";
  const test::Outcome setup = test::run({"setup", robot.c_str(), "-o", config.c_str()});
  EXPECT_EQ(setup.code, tools::exit_code::ok) << setup.output << setup.messages;
  EXPECT_NE(setup.output.find(config + " is written; comments in it say what is a guess."),
            std::string::npos);
  EXPECT_EQ(setup.output.find("roslaunch"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder + "/robot.launch"));
  EXPECT_EQ(test::run_json({"describe", robot.c_str(), config.c_str()})["task_space"], "T2");
  EXPECT_EQ(test::run_json({"map", robot.c_str(), config.c_str()})["aspects"].size(), 10U);
  fs::remove_all(folder);
}

TEST(MjcfCommands, DescribeTakesTheFileAlone) {
  const test::Outcome described = test::run({"describe", robot.c_str()});
  EXPECT_EQ(described.code, tools::exit_code::ok) << described.messages;
  EXPECT_NE(described.output.find("fully parallel, task space T2"), std::string::npos) << described.output;
}

}  // namespace
}  // namespace parallel_aspects
