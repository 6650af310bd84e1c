// SPDX-License-Identifier: BSD-3-Clause
#include "tools/subcommands.h"

#include <gtest/gtest.h>

#include "support/texts.h"
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

  std::string robot_, pose_, mode_, slice_, names_;
  bool json_ = false;
  const Subcommand subcommand_{"turn",
                               "Turn the platform",
                               {{"ROBOT", "", "Name of a robot", &robot_},
                                {"--pose", "\"x y\"", "Pose [m]", &pose_, true, Words::numbers},
                                {"--mode", "SIGNS", "Working mode", &mode_, false, Words::signs},
                                {"--slice", "\"z=1\"", "What is held", &slice_, false, Words::assignments},
                                {"--only", "LIST", "Constraints", &names_, false, Words::names}},
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

TEST_F(CommandLine, NumbersOfAListMayBeWords) {
  EXPECT_TRUE(parse({"--pose", "-1", "-2.5e-1", "five_bar"}));
  EXPECT_EQ(pose_, "-1 -2.5e-1");
  EXPECT_EQ(robot_, "five_bar");
  EXPECT_EQ(problem_of({"--pose", "4.5,", "8", "--mode", "+"}), "");
  EXPECT_EQ(pose_, "4.5, 8");
  EXPECT_EQ(problem_of({"--pose=4", "5 6", "3_rpr"}), "");
  EXPECT_EQ(pose_, "4 5 6");
  EXPECT_EQ(robot_, "3_rpr");
}

TEST_F(CommandLine, SignsOfAListMayBeWords) {
  EXPECT_TRUE(parse({"--mode", "-", "+", "-", "five_bar", "--pose", "1"}));
  EXPECT_EQ(mode_, "- + -");
  EXPECT_TRUE(parse({"--mode", "--", "(+,-)", "-+", "--pose", "1"}));
  EXPECT_EQ(mode_, "-- (+,-) -+");
}

TEST_F(CommandLine, AssignmentsOfAListMayBeWordsUpToTheNextOption) {
  EXPECT_TRUE(parse({"--slice", "z=1", "roll=-0.5", "--pose=1", "five_bar"}));
  EXPECT_EQ(slice_, "z=1 roll=-0.5");
  EXPECT_EQ(pose_, "1");
  EXPECT_TRUE(parse({"--slice", "z=1", "five_bar", "--pose", "1"}));
  EXPECT_EQ(slice_, "z=1");
  EXPECT_EQ(robot_, "five_bar");
}

TEST_F(CommandLine, NamesOfAListMayBeWordsOnceTheRobotIsGiven) {
  EXPECT_TRUE(parse({"five_bar", "--only", "cones", "margins", "--pose", "1"}));
  EXPECT_EQ(names_, "cones margins");
  EXPECT_TRUE(parse({"--only", "cones", "five_bar", "--pose", "1"}));
  EXPECT_EQ(names_, "cones");
  EXPECT_EQ(robot_, "five_bar");
}

TEST_F(CommandLine, FilesArePositionalValuesALineEach) {
  std::string parts, whole;
  const Subcommand merge{
      "merge", "", {{"PARTS", "", "", &parts, true, Words::files}, {"-o", "FILE", "", &whole, true}}, {}};
  EXPECT_TRUE(parse_arguments(merge, {"my a.csv", "b.csv", "-o", "whole.csv", "--", "-c.csv"}));
  EXPECT_EQ(parts, "my a.csv\nb.csv\n-c.csv");
  EXPECT_EQ(whole, "whole.csv");
  EXPECT_THROW(parse_arguments(merge, {"a.csv", "", "-o", "whole.csv"}), UsageError);
}

TEST_F(CommandLine, OutputIsTheLongFormOfO) {
  std::string file;
  const Subcommand draw{"draw", "Draw", {{"-o", "FILE", "The picture", &file, true}}, {}};
  EXPECT_TRUE(parse_arguments(draw, {"--output", "a.svg"}));
  EXPECT_EQ(file, "a.svg");
  EXPECT_THROW(parse_arguments(draw, {"--output=a.svg", "-o", "b.svg"}), UsageError);
  EXPECT_TRUE(test::has(help_of("aspects", draw), "  -o, --output FILE  The picture\n"));
}

TEST_F(CommandLine, TwoDashesEndTheOptions) {
  EXPECT_TRUE(parse({"--pose", "1", "--", "-h"}));
  EXPECT_EQ(robot_, "-h");
  EXPECT_TRUE(parse({"--pose=1", "--mode", "+", "--", "--json"}));
  EXPECT_EQ(mode_, "+");
  EXPECT_EQ(robot_, "--json");
  EXPECT_FALSE(json_);
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
  EXPECT_EQ(problem_of({"five_bar", "--pose", "1", "x"}), "'x': there is no place for it");
}

// What another subcommand calls it, also where another name looks more alike: --hold is near --help.
TEST_F(CommandLine, OptionsOfOtherSubcommandsNameTheOneHere) {
  EXPECT_EQ(problem_of({"--hold", "z=1"}), "--hold: there is no such option; did you mean --slice?");
  EXPECT_EQ(problem_of({"--from-mode=+"}), "--from-mode: there is no such option; did you mean --mode?");
  EXPECT_EQ(problem_of({"--from", "1"}), "--from: there is no such option; did you mean --pose?");
  EXPECT_EQ(problem_of({"--map", "file"}), "--map: there is no such option") << "nor one to load it by";
}

TEST_F(CommandLine, HelpHasEveryOptionOnALine) {
  EXPECT_EQ(help_of("aspects", subcommand_),
            "Turn the platform\n\n"
            "Usage: aspects turn [ROBOT] --pose \"x y\" [OPTIONS]\n\n"
            "Options:\n"
            "  ROBOT          Name of a robot\n"
            "  --pose \"x y\"   Pose [m]\n"
            "  --mode SIGNS   Working mode\n"
            "  --slice \"z=1\"  What is held\n"
            "  --only LIST    Constraints\n"
            "  --json         Print JSON\n"
            "  -h, --help     Print this help and exit\n");
}

}  // namespace
}  // namespace parallel_aspects::tools
