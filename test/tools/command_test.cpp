// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::line_count;
using test::Outcome;
using test::run;
using test::run_json;

using Command = test::CommandTest;

TEST_F(Command, HelpGoesToTheOutput) {
  for (const auto& arguments : std::vector<std::vector<const char*>>{
           {"--help"}, {"map", "--help"}, {"describe", "--help"}, {"ik", "--help"}, {"fk", "--help"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::ok);
    EXPECT_TRUE(test::has(outcome.output, "Usage: aspects"));
    EXPECT_EQ(outcome.messages, "");
  }
}

TEST_F(Command, VersionIsPrinted) { EXPECT_TRUE(test::begins(run({"--version"}).output, "aspects ")); }

TEST_F(Command, MisunderstoodCommandLinesAreUsageErrors) {
  for (const auto& arguments : std::vector<std::vector<const char*>>{{},
                                                                     {"draw"},
                                                                     {"map", "five_bar", "--colour"},
                                                                     {"ik", "five_bar"},
                                                                     {"map"},
                                                                     {"plan", "five_bar", "--to", "4 6"},
                                                                     {"check", "five_bar"},
                                                                     {"choose", "five_bar"},
                                                                     {"ik", "five_bar", "--pose", "1 2", "x"},
                                                                     {"fk", "five_bar", "--joints"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_usage);
    EXPECT_EQ(outcome.output, "");
    EXPECT_NE(outcome.messages, "");
  }
}

TEST_F(Command, ValuesOfAListAreOneWordOrSeveral) {
  const std::string quoted = run({"ik", "five_bar", "--pose", "4.5 8"}).output;
  EXPECT_NE(quoted, "");
  EXPECT_EQ(run({"ik", "five_bar", "--pose", "4.5", "8"}).output, quoted);
  EXPECT_EQ(run({"ik", "--pose", "4.5", "8", "five_bar"}).output, quoted);
  EXPECT_EQ(run({"ik", "--pose=4.5,", "8", "--", "five_bar"}).output, quoted);
  const std::string distance = run({"distance", "five_bar", "--pose", "4.5 8", "--mode", "-+"}).output;
  EXPECT_EQ(run({"distance", "--mode", "-", "+", "--pose", "4.5", "8", "five_bar"}).output, distance);
}

TEST_F(Command, DistancesComeWithBoundsAndWitnesses) {
  const json report = run_json({"distance", "five_bar", "--pose", "4.5 8", "--mode", "-+"});
  ASSERT_EQ(report["answers"].size(), 1U);
  const json& answer = report["answers"][0];
  EXPECT_EQ(answer["status"], "measured");
  EXPECT_EQ(answer["parallel"]["status"], "tight");
  EXPECT_TRUE(answer["parallel"]["upper_proved"]);
  EXPECT_NEAR(answer["parallel"]["upper"], 1.5359, 5e-5);
  EXPECT_GE(answer["parallel"]["lower"], 0.98 * 1.5359);
  EXPECT_NEAR(answer["parallel"]["witness"]["x"], 4.218, 2e-3);
  EXPECT_EQ(answer["parallel"]["joint_displacement"].size(), 2U);
  EXPECT_TRUE(answer["parallel"]["leg"].is_null());
  EXPECT_NEAR(answer["serial"]["lower"], 3.821220, 1e-6);
  EXPECT_TRUE(answer["serial"]["leg"].is_string());
  EXPECT_EQ(answer["actuated_limit"]["status"], "absent");
  EXPECT_TRUE(answer["actuated_limit"]["lower"].is_null());
}

TEST_F(Command, DistancesAskAMap) {
  const std::vector<const char*> question{"distance", "five_bar", "--pose", "4.5 8", "--mode", "-+"};
  std::vector<const char*> with_map = question;
  with_map.insert(with_map.end(), {"--resolution", "0.5"});
  const json alone = run_json(question)["answers"][0], report = run_json(with_map);
  EXPECT_EQ(report["loaded"], false);
  const json& answer = report["answers"][0];
  EXPECT_EQ(answer["parallel"]["status"], "tight");
  EXPECT_NEAR(answer["parallel"]["upper"], double{alone["parallel"]["upper"]}, 1e-6);
  EXPECT_LT(int{answer["parallel"]["boxes"]}, int{alone["parallel"]["boxes"]});
  EXPECT_EQ(run({"distance", "stewart", "--pose", "0 0 0.6 0 0 0", "--map", "none.map"}).code,
            exit_code::bad_input);
}

// Only a map that is saved to the same file need not be there yet.
TEST_F(Command, RefusesAMapThatIsNotThere) {
  const std::vector<std::vector<const char*>> questions{
      {"distance", "five_bar", "--pose", "4.5 8", "--map", "/no/such"},
      {"map", "five_bar", "--load", "/no/such"},
      {"plan", "five_bar", "--from", "4.5 8", "--to", "4 6", "--load", "/no/such"},
      {"map", "five_bar", "--load", "/no/such", "--save", "elsewhere"},
      {"map", "five_bar", "--load", "/"}};
  for (const std::vector<const char*>& question : questions) {
    const Outcome outcome = run(question);
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(
        test::has(outcome.messages, "which is no file; write one by `aspects map --save`, or leave out --"));
  }
}

// Where the bounds of the command alone are loose it says how those of a map are had, to be typed as it
// stands.
TEST_F(Command, LooseDistancesSayWhatAMapGives) {
  const std::vector<const char*> question{"distance",      "linear_delta", "--pose",
                                          "0.05 0.02 0.2", "--boxes",      "1"};
  const std::string alone = run(question).output;
  std::smatch words;
  ASSERT_TRUE(std::regex_search(
      alone, words, std::regex("`aspects map (\\S+) --save (\\S+)`, and add --map (\\S+) here\\.\n$")))
      << alone;
  const std::string robot = words.str(1), file = testing::TempDir() + words.str(2);
  EXPECT_EQ(words.str(2), words.str(3));
  ASSERT_EQ(run({"map", robot.c_str(), "--save", file.c_str()}).code, exit_code::ok);
  std::vector<const char*> with_map = question;
  with_map.insert(with_map.end(), {"--map", file.c_str()});
  const json before = run_json(question), after = run_json(with_map);
  std::filesystem::remove(file);
  EXPECT_EQ(after.at("loaded"), true);
  bool is_tighter = false;
  for (std::size_t i = 0; i < before.at("answers").size(); ++i) {
    const json &one = before["answers"][i], &other = after["answers"][i];
    if (one.at("status") != "measured" || other["parallel"]["lower"].is_null()) continue;
    is_tighter = is_tighter || double{other["parallel"]["lower"]} > double{one["parallel"]["lower"]};
  }
  EXPECT_TRUE(is_tighter);
  EXPECT_FALSE(test::has(run(with_map).output, "aspects map"));
  EXPECT_FALSE(test::has(run({"distance", "five_bar", "--pose", "4.5 8"}).output, "aspects map"))
      << "tight as it is";
}

TEST_F(Command, DistancesAreATable) {
  const Outcome outcome = run({"distance", "bipod", "--pose", "2 4"});
  EXPECT_EQ(outcome.code, exit_code::ok);
  EXPECT_TRUE(test::has(outcome.output, "actuated joint limit, "));
  EXPECT_EQ(run({"distance", "five_bar", "--pose", "4.5 8", "--boxes", "0"}).code, exit_code::bad_input);
  EXPECT_EQ(run({"distance", "five_bar", "--pose", "4.5 8", "--tolerance", "2"}).code, exit_code::bad_input);
  EXPECT_EQ(run({"distance", "five_bar", "--pose", "4.5 80"}).code, exit_code::ok);
}

// What the one subcommand solves the other one measures, also where a leg is stretched.
TEST_F(Command, APoseAtASerialSingularityIsNotOutOfReach) {
  EXPECT_EQ(run_json({"ik", "five_bar", "--pose", "13 0"})["solutions"][0]["status"], "solved");
  const json answer = run_json({"distance", "five_bar", "--pose", "13 0"})["answers"][0];
  EXPECT_EQ(answer["status"], "at a serial singularity");
  EXPECT_EQ(answer["serial"]["status"], "touching");
  EXPECT_EQ(answer["serial"]["lower"], 0.0);
  EXPECT_EQ(answer["serial"]["leg"], "leg_1");
  EXPECT_TRUE(answer["joints"].is_array());
  EXPECT_TRUE(test::has(run({"distance", "five_bar", "--pose", "13 0"}).output, "touching"));
}

TEST_F(Command, PosesBeyondALimitSayByHowMuch) {
  const std::string answer = run({"ik", "bipod", "--pose", "0.4 1.9595917"}).output;
  EXPECT_TRUE(test::has(answer, "at 2 m, outside its limits [2, 6] by 9.2"));
}

TEST_F(Command, UnknownRobotIsAnsweredWithTheKnownOnes) {
  const Outcome outcome = run({"describe", "fife_bar"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(outcome.output, "");
  EXPECT_TRUE(test::has(outcome.messages, "'fife_bar'"));
  EXPECT_TRUE(test::has(outcome.messages, "five_bar"));
}

TEST_F(Command, EveryProblemIsALine) {
  const Outcome outcome =
      run({"map", "--urdf", "/no/such.urdf", "--config", "/", "--resolution", "nan", "--threads", "-1"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(line_count(outcome.messages), 4U) << outcome.messages;
  EXPECT_EQ(outcome.output, "");
}

TEST_F(Command, OneFileThatCannotBeReadIsOneProblem) {
  const Outcome outcome = run({"describe", "--urdf", "/no/such", "--config", "/no/such"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(outcome.messages, "File '/no/such' cannot be read; give one that exists and is readable.\n");
}

TEST_F(Command, NameAndFilesTogetherAreRefused) {
  const Outcome outcome = run({"describe", "five_bar", "--urdf", "x.urdf", "--config", "x.yaml"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(line_count(outcome.messages), 1U) << outcome.messages;
}

TEST_F(Command, ShareFolderWithoutRobotsIsRefused) {
  setenv("PARALLEL_ASPECTS_SHARE", "/no/such/folder", 1);
  const Outcome outcome = run({"robots"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(outcome.messages, "/no/such/folder"));
}

TEST_F(Command, ShippedRobotsAreListed) {
  const json robots = run_json({"robots"}).at("robots");
  EXPECT_NE(std::find(robots.begin(), robots.end(), "five_bar"), robots.end()) << robots;
}

TEST_F(Command, FilesServeAsWellAsAName) {
  const std::string source = PARALLEL_ASPECTS_SOURCE_DIR;
  const std::string urdf = source + "/urdf/five_bar.urdf";
  const std::string config = source + "/config/robots/five_bar.yaml";
  EXPECT_EQ(run_json({"describe", "--urdf", urdf.c_str(), "--config", config.c_str()}),
            run_json({"describe", "five_bar"}));
  EXPECT_EQ(run_json({"describe", urdf.c_str(), config.c_str()}), run_json({"describe", "five_bar"}));
  EXPECT_EQ(run_json({"describe", config.c_str(), "--urdf", urdf.c_str()}),
            run_json({"describe", "five_bar"}));
}

TEST_F(Command, TooFewAndTooManyFilesAreReported) {
  EXPECT_EQ(run({"map", "a.urdf"}).messages.substr(0, 70),
            "its YAML is required behind 'a.urdf'; `aspects setup a.urdf` writes it");
  EXPECT_EQ(run({"map", "a.urdf", "b.yaml", "c.yaml"}).messages.substr(0, 36),
            "'c.yaml': there is no place for it. ");
  const std::string twice =
      "A file is given twice, as a word and by its option; give ROBOT.urdf ROBOT.yaml.\n";
  EXPECT_EQ(run({"map", "a.urdf", "--urdf", "b.urdf", "--config", "c.yaml"}).messages, twice);
  EXPECT_EQ(run({"map", "a.urdf", "b.yaml", "--config", "c.yaml"}).messages, twice);
}

TEST_F(Command, FilesThatAreExchangedAreReported) {
  EXPECT_EQ(run({"map", "a.yaml", "b.urdf"}).messages,
            "'b.urdf' is given as the YAML of 'a.yaml'; give the URDF first, then the YAML.\n");
}

TEST_F(Command, WritesOverNoFileThatItReads) {
  const std::string urdf = testing::TempDir() + "own_five_bar.urdf",
                    config = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/config/robots/five_bar.yaml";
  const std::string text = "<robot name='x'/>";
  std::ofstream(urdf) << text;
  for (const auto& arguments : std::vector<std::vector<const char*>>{
           {"map", urdf.c_str(), config.c_str(), "--save", urdf.c_str()},
           {"map", "--urdf", urdf.c_str(), "--config", config.c_str(), "--save", urdf.c_str()},
           {"workspace", urdf.c_str(), config.c_str(), "--shape", "disc", "--save", urdf.c_str()},
           {"plan", urdf.c_str(), config.c_str(), "--save", urdf.c_str()},
           {"graph", urdf.c_str(), config.c_str(), "--save", urdf.c_str()}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << arguments.front();
    EXPECT_TRUE(test::has(outcome.messages, "would be overwritten"));
  }
  const Outcome other = run({"map", "five_bar", "--save", urdf.c_str()});
  EXPECT_EQ(other.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(other.messages, "is there and is no map"));
  std::stringstream kept;
  kept << std::ifstream(urdf).rdbuf();
  EXPECT_EQ(kept.str(), text);
}

TEST_F(Command, DescriptionsSayWhereThePosesAre) {
  const std::string text = run({"describe", "five_bar"}).output;
  EXPECT_TRUE(test::has(text, "poses are given in the task frame, which is the frame of base_link\n"));
  EXPECT_TRUE(test::has(text, "workspace: x from -3."));
  for (const char* robot : {"five_bar", "three_rpr", "delta", "agile_eye", "stewart"}) {
    const std::string description = run({"describe", robot}).output;
    const std::size_t start = description.find("--pose \"");
    ASSERT_NE(start, std::string::npos) << description;
    const std::string pose = description.substr(start + 8, description.find('"', start + 8) - start - 8);
    const Outcome outcome = run({"ik", robot, "--pose", pose.c_str()});
    EXPECT_TRUE(test::has(outcome.output, "solved")) << robot << outcome.output << outcome.messages;
  }
}

TEST_F(Command, LinksOnASphereAreAngles) {
  const std::string eye = run({"describe", "agile_eye"}).output;
  EXPECT_TRUE(test::has(eye, "90 deg (1.5708 rad)"));
  EXPECT_FALSE(test::has(eye, "[m]"));
  const std::string links = run({"describe", "spherical_3rrr"}).output;
  EXPECT_TRUE(test::has(links, "70 deg (1.22173 rad)  80 deg (1.39626 rad)"));
  const std::string solved = run({"ik", "agile_eye", "--pose", "0 0 0 1"}).output;
  EXPECT_TRUE(test::has(solved, "det A  smallest"));
  const std::string distances = run({"distance", "agile_eye", "--pose", "0 0 0 1"}).output;
  EXPECT_TRUE(test::has(distances, "deg ("));
  EXPECT_FALSE(test::has(distances, "[m]"));
}

TEST_F(Command, DescribesTheFiveBarOfThePaper) {
  const json robot = run_json({"describe", "five_bar"});
  EXPECT_EQ(robot.at("cones"), json::array());
  EXPECT_EQ(robot.at("task_space"), "T2");
  EXPECT_EQ(robot.at("mobility"), 2);
  EXPECT_EQ(robot.at("idle_degrees_of_freedom"), 0);
  EXPECT_TRUE(robot.at("joint_limits").at("elbow_1_joint").at("upper").is_null());
  EXPECT_EQ(robot.at("working_modes").size(), 4U);
  ASSERT_EQ(robot.at("legs").size(), 2U);
  EXPECT_NEAR(robot.at("legs")[0].at("crank_length").get<double>(), 8.0, 1e-12);
  EXPECT_NEAR(robot.at("legs")[0].at("rod_length").get<double>(), 5.0, 1e-12);
  EXPECT_NEAR(robot.at("legs")[1].at("crank_length").get<double>(), 5.0, 1e-12);
  EXPECT_NEAR(robot.at("legs")[1].at("rod_length").get<double>(), 8.0, 1e-12);
}

TEST_F(Command, InverseFindsTheReferenceAngles) {
  const json answer = run_json({"ik", "five_bar", "--pose", "4.5 8"});
  ASSERT_EQ(answer.at("solutions").size(), 4U);
  std::vector<double> first, second;
  for (const json& solution : answer.at("solutions")) {
    EXPECT_EQ(solution.at("status"), "solved");
    first.push_back(solution.at("joints")[0].get<double>());
    second.push_back(solution.at("joints")[1].get<double>());
  }
  EXPECT_NEAR(*std::max_element(first.begin(), first.end()), 1.633334, 1e-6);
  EXPECT_NEAR(*std::max_element(second.begin(), second.end()), 3.138465, 1e-6);
  EXPECT_NEAR(*std::min_element(second.begin(), second.end()), 1.027907, 1e-6);
}

TEST_F(Command, InverseSaysWhyALegCannotReach) {
  for (const char* pose : {"-1 2", "-1,2"}) {
    const json answer = run_json({"ik", "five_bar", "--pose", pose});
    for (const json& solution : answer.at("solutions")) {
      EXPECT_EQ(solution.at("status"), "out of reach");
      EXPECT_TRUE(test::has(solution.at("reason").get<std::string>(), "cannot reach"));
    }
  }
}

TEST_F(Command, NegativeNumbersAreReadInEveryWayOfWriting) {
  const json expected = run_json({"fk", "five_bar", "--joints", "-1 2"});
  EXPECT_EQ(run_json({"fk", "five_bar", "--joints=-1 2"}), expected);
  EXPECT_EQ(run_json({"fk", "--joints", "-1 2", "five_bar"}), expected);
  EXPECT_EQ(expected.at("assembly_modes").size(), 2U);
}

TEST_F(Command, DirectAndInverseAgree) {
  const json inverse = run_json({"ik", "five_bar", "--pose", "4.5 8"});
  for (const json& solution : inverse.at("solutions")) {
    const std::string joints = solution.at("joints")[0].dump() + " " + solution.at("joints")[1].dump();
    const json direct = run_json({"fk", "five_bar", "--joints", joints.c_str()});
    const auto is_pose = [&](const json& assembly) {
      return std::abs(assembly.at("pose").at("x").get<double>() - 4.5) < 1e-9 &&
             std::abs(assembly.at("pose").at("y").get<double>() - 8.0) < 1e-9 &&
             assembly.at("working_mode") == solution.at("working_mode");
    };
    const json& modes = direct.at("assembly_modes");
    EXPECT_EQ(std::count_if(modes.begin(), modes.end(), is_pose), 1) << direct;
  }
}

TEST_F(Command, DirectDistinguishesTheTrivialSolutionsOfTheAgileEye) {
  const json modes = run_json({"fk", "agile_eye", "--joints", "0.3 0.2 -0.4"}).at("assembly_modes");
  EXPECT_EQ(modes.size(), 8U);
  int trivial = 0;
  for (const json& mode : modes) {
    if (mode.at("serially_singular").get<bool>()) ++trivial;
    EXPECT_EQ(mode.at("working_mode").is_null(), mode.at("serially_singular").get<bool>()) << mode;
  }
  EXPECT_EQ(trivial, 4);
  const Outcome outcome = run({"fk", "agile_eye", "--joints", "0.3 0.2 -0.4"});
  EXPECT_TRUE(test::has(outcome.output, "8 assembly modes, 4 of them at a serial singularity"));
}

TEST_F(Command, InverseReportsPassiveLimits) {
  const json answer = run_json({"ik", "five_bar", "--pose", "4.5 8"});
  for (const json& solution : answer.at("solutions"))
    EXPECT_TRUE(solution.at("joint_outside_limits").is_null());
}

TEST_F(Command, EmptyValuesAreRefused) {
  for (const char* option : {"--mode", "--resolution", "--slice", "--save", "--constraint"}) {
    const Outcome outcome = run({"map", "five_bar", option, ""});
    EXPECT_EQ(outcome.code, exit_code::bad_usage) << option;
    EXPECT_TRUE(test::has(outcome.messages, std::string(option) + ": it is empty"));
  }
}

TEST_F(Command, BadNumbersAreRefused) {
  for (const auto& arguments :
       std::vector<std::vector<const char*>>{{"ik", "five_bar", "--pose", "nan 2"},
                                             {"ik", "five_bar", "--pose", "1"},
                                             {"fk", "five_bar", "--joints", "1 2 3"},
                                             {"fk", "five_bar", "--joints", "one 2"},
                                             {"map", "five_bar", "--resolution", "0"},
                                             {"map", "five_bar", "--resolution=-1"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << arguments.back();
    EXPECT_EQ(outcome.output, "");
    EXPECT_NE(outcome.messages, "");
  }
}

TEST_F(Command, UnwritableOutputIsAnError) {
  std::ostringstream messages;
  std::ostream output(nullptr);
  const std::vector<const char*> arguments{"aspects", "describe", "five_bar"};
  EXPECT_EQ(run_command(3, arguments.data(), {output, messages, false, nullptr}), exit_code::bad_input);
  EXPECT_NE(messages.str(), "");
}

// The five-bar with another part of its YAML in place of the empty `map`.
class DescribedWith {
 public:
  explicit DescribedWith(const std::string& more) {
    std::ifstream shipped(std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/config/robots/five_bar.yaml");
    std::ostringstream text;
    text << shipped.rdbuf();
    const std::string empty = "map: {}\n";
    const std::size_t at = text.str().find(empty);
    EXPECT_NE(at, std::string::npos);
    std::ofstream(file_) << text.str().replace(at, empty.size(), more);
  }
  ~DescribedWith() { std::remove(file_.c_str()); }
  DescribedWith(const DescribedWith&) = delete;
  DescribedWith& operator=(const DescribedWith&) = delete;

  Outcome operator()(const std::vector<const char*>& options = {}) const {
    std::vector<const char*> arguments{"describe", "--urdf", urdf_.c_str(), "--config", file_.c_str()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }

 private:
  std::string urdf_ = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/urdf/five_bar.urdf";
  std::string file_ = ::testing::TempDir() + "described.yaml";
};

TEST_F(Command, DescribeRefusesWhatMapRefuses) {
  const Outcome outcome = DescribedWith("map: {resolution: 0}\n")();
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(outcome.messages, "map.resolution that is not positive"));
  EXPECT_NE(DescribedWith("map: {region: {lower: [0], upper: [1]}}\n")().code, exit_code::ok);
  EXPECT_EQ(DescribedWith("map: {resolution: 0.5}\n")().code, exit_code::ok);
}

TEST_F(Command, DescribeCountsManyCones) {
  std::string cones = "constraints:\n  cones:\n";
  for (int k = 0; k < 200; ++k) cones += "    - {leg: 1, end: base, axis: [1, 0], angle: 1.0}\n";
  const DescribedWith described(cones);
  EXPECT_TRUE(test::has(
      described().output,
      "cones: the rod of leg_1 is at most 1 rad from 200 axes of the crank; --verbose lists them\n"));
  EXPECT_FALSE(test::has(described().output, "cone: the rod"));
  EXPECT_GE(line_count(described({"--verbose"}).output), 200U);
}

// Of one kind, whatever their angles.
TEST_F(Command, DescribeHasConesOfSeveralAnglesInOneLine) {
  const DescribedWith described(
      "constraints:\n  cones:\n    - {leg: 1, end: base, axis: [1, 0], angle: 1.0}\n"
      "    - {leg: 2, end: base, axis: [1, 0], angle: 1.5}\n    - {leg: 2, end: base, axis: [0, 1], angle: "
      "1.2}\n");
  EXPECT_TRUE(test::has(described().output,
                        "cones: the rods of leg_1, leg_2 are at most 1 to 1.5 rad from 3 axes of the crank; "
                        "--verbose lists them\n"));
}

}  // namespace
}  // namespace parallel_aspects::tools
