// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command_line.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using Arguments = std::vector<std::string>;

class CommandLine : public testing::Test {
 protected:
  bool parse(const Arguments& arguments) { return parse_arguments(subcommand_, arguments); }

  std::string problem_of(const Arguments& arguments) {
    try {
      parse(arguments);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }

  std::string robot_, pose_, mode_;
  bool json_ = false;
  const Subcommand subcommand_{"turn",
                               "Turn the platform",
                               {{"ROBOT", "", "Name of a robot", &robot_},
                                {"--pose", "\"x y\"", "Pose [m]", &pose_, true},
                                {"--mode", "SIGNS", "Working mode", &mode_}},
                               {},
                               {{"--json", "Print JSON", &json_}}};
};

TEST_F(CommandLine, ValuesComeInAnyOrderAndBothWaysOfWriting) {
  EXPECT_TRUE(parse({"--json", "--pose=-1 2", "five_bar", "--mode", "--"}));
  EXPECT_EQ(robot_, "five_bar");
  EXPECT_EQ(pose_, "-1 2");
  EXPECT_EQ(mode_, "--");
  EXPECT_TRUE(json_);
}

TEST_F(CommandLine, ValuesMayHoldEqualsSignsAndStartWithOne) {
  EXPECT_TRUE(parse({"--pose=x=1 y=2", "--mode", "=+"}));
  EXPECT_EQ(pose_, "x=1 y=2");
  EXPECT_EQ(mode_, "=+");
}

TEST_F(CommandLine, WhatIsNotGivenStaysAsItWas) {
  mode_ = "(+)";
  EXPECT_TRUE(parse({"--pose", "1"}));
  EXPECT_EQ(mode_, "(+)");
  EXPECT_EQ(robot_, "");
  EXPECT_FALSE(json_);
}

TEST_F(CommandLine, HelpIsAnsweredWhateverElseIsGiven) {
  EXPECT_FALSE(parse({"--help"}));
  EXPECT_FALSE(parse({"five_bar", "-h", "--colour"}));
  EXPECT_TRUE(parse({"--pose", "-h"}));
}

TEST_F(CommandLine, EveryMisunderstandingHasItsSentence) {
  EXPECT_EQ(problem_of({"five_bar"}), "--pose: it is required; give a value");
  EXPECT_EQ(problem_of({"--pose"}), "--pose: its value is missing");
  EXPECT_EQ(problem_of({"--pose", ""}), "--pose: it is empty; give a value, or leave the option out");
  EXPECT_EQ(problem_of({"--pose=", "1"}), "--pose: it is empty; give a value, or leave the option out");
  EXPECT_EQ(problem_of({"", "--pose", "1"}), "ROBOT: it is empty; give a value, or leave the option out");
  EXPECT_EQ(problem_of({"--pose", "1", "--pose=1"}), "--pose: it is given twice; give it once");
  EXPECT_EQ(problem_of({"--pose", "1", "--colour"}), "--colour: there is no such option");
  EXPECT_EQ(problem_of({"--pos", "1"}), "--pos: there is no such option; did you mean --pose?");
  EXPECT_EQ(problem_of({"--psoe", "1"}), "--psoe: there is no such option; did you mean --pose?");
  EXPECT_EQ(problem_of({"--jsno"}), "--jsno: there is no such option; did you mean --json?");
  EXPECT_EQ(problem_of({"--pose", "1", "--json=no"}), "--json: it takes no value; leave it out");
  json_ = false;
  EXPECT_EQ(problem_of({"--json", "--pose", "1", "--json"}), "--json: it is given twice; give it once");
  EXPECT_EQ(problem_of({"five_bar", "--pose", "1", "2"}),
            "'2': there is no place for it; values of several words are quoted");
}

TEST_F(CommandLine, HelpHasEveryOptionOnALine) {
  EXPECT_EQ(help_of("aspects", subcommand_),
            "Turn the platform\n\n"
            "Usage: aspects turn [ROBOT] --pose \"x y\" [OPTIONS]\n\n"
            "Options:\n"
            "  ROBOT         Name of a robot\n"
            "  --pose \"x y\"  Pose [m]\n"
            "  --mode SIGNS  Working mode\n"
            "  --json        Print JSON\n"
            "  -h, --help    Print this help and exit\n");
}

}  // namespace
}  // namespace parallel_aspects::tools
