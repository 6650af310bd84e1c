// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_FIVE_BAR_SETUP_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_FIVE_BAR_SETUP_H

#include <gtest/gtest.h>

#include "support/command_run.h"
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// The five-bar in a format that is no URDF: `aspects setup` with these further options writes a YAML that
/// all commands take, and no launch file, since only a URDF can be launched.
inline void expect_five_bar_is_set_up(const std::string& robot, const std::vector<const char*>& more = {}) {
  namespace fs = std::filesystem;
  std::string folder = (fs::temp_directory_path() / "five_bar_XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::string config = folder + "/robot.yaml";
  std::vector<const char*> arguments{"setup", robot.c_str(), "-o", config.c_str()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome setup = run(arguments);
  EXPECT_EQ(setup.code, tools::exit_code::ok) << setup.output << setup.messages;
  EXPECT_NE(setup.output.find(config + " is written; comments in it say what is a guess."),
            std::string::npos);
  EXPECT_EQ(setup.output.find("roslaunch"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder + "/robot.launch"));
  EXPECT_EQ(run_json({"describe", robot.c_str(), config.c_str()})["task_space"], "T2");
  EXPECT_EQ(run_json({"map", robot.c_str(), config.c_str()})["aspects"].size(), 10U);
  fs::remove_all(folder);
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_FIVE_BAR_SETUP_H
