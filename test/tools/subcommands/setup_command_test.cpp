// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace parallel_aspects::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Outcome;
using test::run;

// Writes into a folder of its own.
class SetupCommand : public test::CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    std::string pattern = (fs::temp_directory_path() / "setup_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    output_ = (folder_ / "robot.yaml").string();
    launch_ = (folder_ / "robot.launch").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string urdf(const std::string& file) {
    return std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/" + file;
  }

  static std::string text_of(const std::string& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::string written() const { return text_of(output_); }
  std::string launch() const { return text_of(launch_); }

  // On a terminal where this is typed.
  Outcome answered(std::vector<const char*> arguments, const std::string& typed) const {
    std::ostringstream output, messages;
    std::istringstream answers(typed);
    arguments.insert(arguments.begin(), "aspects");
    const int code = run_command(static_cast<int>(arguments.size()), arguments.data(),
                                 {output, messages, true, nullptr, &answers});
    return {code, output.str(), messages.str()};
  }

  fs::path folder_;
  std::string output_, launch_;
  const std::string five_bar_ = urdf("urdf/five_bar.urdf");
  const std::string unnamed_ = urdf("test/data/setup/unnamed_three_rpr.urdf");
};

TEST_F(SetupCommand, WritesWhatLoadsAndSaysWhatIsNext) {
  const Outcome outcome = run({"setup", five_bar_.c_str(), "-o", output_.c_str()});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  EXPECT_TRUE(test::has(outcome.output, "five_bar: fully parallel, task space T2"));
  EXPECT_TRUE(test::has(outcome.output, "\n  aspects map " + five_bar_ + " " + output_ + "\n"));
  EXPECT_EQ(run({"describe", "--urdf", five_bar_.c_str(), "--config", output_.c_str()}).code, exit_code::ok);
  EXPECT_TRUE(test::has(written(), "# Actuated joints, one a leg: "));
  EXPECT_TRUE(test::has(outcome.output, "\n  roslaunch " + launch_ + " simulated:=true\n"));
  EXPECT_TRUE(fs::exists(launch_));
}

// Where the monitor begins, and the robot assembles there.
TEST_F(SetupCommand, WritesTheHomePoseAsTheStart) {
  for (const char* name : {"five_bar", "three_rrr", "delta", "agile_eye", "stewart"}) {
    const std::string robot = urdf("urdf/" + std::string(name) + ".urdf");
    ASSERT_EQ(run({"setup", robot.c_str(), "-o", output_.c_str(), "--replace"}).code, exit_code::ok);
    const std::string config = written();
    std::smatch pose;
    ASSERT_TRUE(std::regex_search(config, pose, std::regex("\nstart:\n(?:  #.*\n)*  pose: \\[(.*)\\]\n")))
        << config;
    const std::string coordinates = pose.str(1);
    const json inverse = test::run_json(
        {"ik", "--urdf", robot.c_str(), "--config", output_.c_str(), "--pose", coordinates.c_str()});
    const json& solutions = inverse.at("solutions");
    EXPECT_TRUE(std::any_of(solutions.begin(), solutions.end(),
                            [](const json& each) { return each.at("status") == "solved"; }))
        << name << " at " << coordinates << ": " << inverse;
  }
}

TEST_F(SetupCommand, TheLaunchFileNamesWhatLiesBesideItFromThere) {
  const fs::path beside = folder_ / "my & robot.urdf";
  fs::copy(five_bar_, beside);
  ASSERT_EQ(run({"setup", beside.c_str(), "-o", output_.c_str()}).code, exit_code::ok);
  EXPECT_TRUE(test::has(launch(), "value=\"$(dirname)/my &amp; robot.urdf\""));
  EXPECT_TRUE(test::has(launch(), "value=\"$(dirname)/robot.yaml\""));
  ASSERT_EQ(run({"setup", five_bar_.c_str(), "-o", output_.c_str(), "--replace"}).code, exit_code::ok);
  EXPECT_TRUE(test::has(launch(), "value=\"" + fs::canonical(five_bar_).string() + "\""));
}

TEST_F(SetupCommand, LeavesALaunchFileThatExists) {
  std::ofstream(launch_) << "mine\n";
  const Outcome outcome = run({"setup", five_bar_.c_str(), "-o", output_.c_str()});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(outcome.messages, "is left as it is: " + launch_));
  EXPECT_EQ(launch(), "mine\n");
  EXPECT_FALSE(fs::exists(output_));
  const Outcome same = run({"setup", five_bar_.c_str(), "-o", launch_.c_str(), "--replace"});
  EXPECT_TRUE(test::has(same.messages, "ends with .yaml"));
  EXPECT_EQ(launch(), "mine\n");
}

// As -0 and 1.7e-17, which rounding leaves of zero.
TEST_F(SetupCommand, PrintsNoNumbersThatAreNoise) {
  for (const char* name : {"layered_five_bar", "wrist"}) {
    const std::string robot = urdf("test/data/setup/" + std::string(name) + ".urdf");
    const std::string told =
        run({"setup", robot.c_str(), "-o", (folder_ / (std::string(name) + ".yaml")).c_str()}).output;
    EXPECT_TRUE(test::has(told, "home pose: "));
    EXPECT_FALSE(std::regex_search(told, std::regex("-0[,) \"\n]|e-1[0-9]"))) << told;
  }
}

TEST_F(SetupCommand, LeavesAFileThatExists) {
  std::ofstream(output_) << "mine\n";
  const Outcome outcome = run({"setup", five_bar_.c_str(), "-o", output_.c_str()});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(outcome.messages, "is left as it is"));
  EXPECT_EQ(answered({"setup", five_bar_.c_str(), "-o", output_.c_str()}, "n\n").code, exit_code::bad_input);
  EXPECT_EQ(written(), "mine\n");
  EXPECT_EQ(answered({"setup", five_bar_.c_str(), "-o", output_.c_str()}, "y\n").code, exit_code::ok);
  EXPECT_NE(written(), "mine\n");
  EXPECT_EQ(run({"setup", five_bar_.c_str(), "-o", output_.c_str(), "--replace"}).code, exit_code::ok);
}

// What is wrong is said before what is in the way.
TEST_F(SetupCommand, ReportsTheFileThatExistsLast) {
  std::ofstream(output_) << "mine\n";
  const auto messages = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "setup");
    arguments.insert(arguments.end(), {"-o", output_});
    std::vector<const char*> words;
    for (const std::string& argument : arguments) words.push_back(argument.c_str());
    return answered(words, "").messages;
  };
  EXPECT_FALSE(test::has(messages({"nowhere.urdf"}), "is left as it is"));
  EXPECT_TRUE(test::has(messages({five_bar_, "--actuated", "crank_9_joint"}), "crank_9_joint"));
  EXPECT_FALSE(test::has(messages({five_bar_, "--actuated", "crank_9_joint"}), "is left as it is"));
  EXPECT_FALSE(test::has(messages({unnamed_}), "is left as it is"));
  EXPECT_TRUE(test::has(messages({five_bar_}), "is left as it is"));
  EXPECT_EQ(written(), "mine\n");
}

// Typed in for the letters that the question shows.
TEST_F(SetupCommand, TakesAPlaceInALink) {
  const std::string half = urdf("test/data/setup/half_blunt_three_rrr.urdf");
  const Outcome asked = run({"setup", half.c_str(), "-o", output_.c_str()});
  EXPECT_EQ(asked.code, exit_code::needs_answer);
  const std::string shown = "corner_1=shank_1_end corner_2=shank_2@X:Y:Z corner_3=shank_3@X:Y:Z";
  EXPECT_TRUE(test::has(asked.messages, "--closures '" + shown + "'"));
  const std::string closures = "corner_1=shank_1_end corner_2=shank_2@0.28:0:0 corner_3=shank_3@0.28:0:0";
  const Outcome found = run({"setup", half.c_str(), "-o", output_.c_str(), "--closures", closures.c_str()});
  EXPECT_EQ(found.code, exit_code::ok) << found.messages;
  EXPECT_EQ(run({"describe", "--urdf", half.c_str(), "--config", output_.c_str()}).code, exit_code::ok);
}

TEST_F(SetupCommand, NeverReplacesTheUrdf) {
  std::ofstream(output_) << std::ifstream(five_bar_).rdbuf();
  const std::string before = written();
  const Outcome outcome = run({"setup", output_.c_str(), "-o", output_.c_str(), "--replace"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(outcome.messages, "is the URDF itself"));
  EXPECT_EQ(written(), before);
}

TEST_F(SetupCommand, WithoutATerminalAQuestionIsAllThatIsWritten) {
  const Outcome outcome = run({"setup", unnamed_.c_str(), "-o", output_.c_str()});
  EXPECT_EQ(outcome.code, exit_code::needs_answer);
  EXPECT_EQ(outcome.output, "");
  EXPECT_FALSE(fs::exists(output_));
  const std::string option = "--closures 'ash=green_tip oak=blue_tip'";
  EXPECT_TRUE(test::has(outcome.messages, option));
  EXPECT_EQ(
      run({"setup", unnamed_.c_str(), "-o", output_.c_str(), "--closures", "ash=green_tip oak=blue_tip"})
          .code,
      exit_code::ok);
}

TEST_F(SetupCommand, OnATerminalItAsks) {
  const Outcome outcome = answered({"setup", unnamed_.c_str(), "-o", output_.c_str()}, "2\n");
  EXPECT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  EXPECT_TRUE(test::has(outcome.messages, "Which one, 1 to 2?"));
  EXPECT_TRUE(test::has(written(), "[oak, green_tip]"));
  for (const char* typed : {"", "\n", "3\n", "0\n", "-1\n", "all\n"})
    EXPECT_EQ(answered({"setup", unnamed_.c_str(), "-o", output_.c_str(), "--replace"}, typed).code,
              exit_code::needs_answer)
        << typed;
}

TEST_F(SetupCommand, JsonListsAndWritesOnlyWhereAFileIsNamed) {
  const json report = test::run_json({"setup", five_bar_.c_str()});
  EXPECT_EQ(report["status"], "found");
  EXPECT_TRUE(report["written"].is_null());
  EXPECT_EQ(report["choices"].size(), 4U);
  EXPECT_EQ(report["describe"]["task_space"], "T2");
  EXPECT_EQ(test::run_json({"setup", five_bar_.c_str(), "-o", output_.c_str()})["written"], output_);
  EXPECT_EQ(written(), report["config"]);
  const Outcome asked = run({"setup", unnamed_.c_str(), "--json"});
  EXPECT_EQ(asked.code, exit_code::needs_answer);
  const json question = json::parse(asked.output, nullptr, false);
  EXPECT_EQ(question["status"], "undecided");
  EXPECT_EQ(question["question"]["candidates"].size(), 2U);
}

TEST_F(SetupCommand, DescribeDoesTheSameWithoutWriting) {
  const Outcome outcome = run({"describe", "--urdf", five_bar_.c_str()});
  EXPECT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  EXPECT_TRUE(test::has(outcome.output, "task space T2"));
  EXPECT_TRUE(test::has(outcome.output, "Nothing is written"));
  EXPECT_EQ(run({"describe", "--urdf", unnamed_.c_str()}).code, exit_code::needs_answer);
}

TEST_F(SetupCommand, BadAnswersAreOneSentenceEach) {
  const Outcome outcome = run({"setup", five_bar_.c_str(), "-o", output_.c_str(), "--closures", "tool",
                               "--actuated", "crank_9_joint"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
  EXPECT_EQ(run({"setup"}).code, exit_code::bad_usage);
  EXPECT_EQ(run({"setup", "nowhere.urdf", "-o", output_.c_str()}).code, exit_code::bad_input);
  EXPECT_FALSE(fs::exists(output_));
  const std::atomic<bool> interrupted{true};
  EXPECT_EQ(run({"setup", five_bar_.c_str(), "-o", output_.c_str()}, &interrupted).code,
            exit_code::interrupted);
}

}  // namespace
}  // namespace parallel_aspects::tools
