// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

struct Outcome {
  int code = 0;
  std::string output;
  std::string messages;
};

Outcome run(std::vector<const char*> arguments, const std::atomic<bool>* interrupted = nullptr) {
  std::ostringstream output, messages;
  arguments.insert(arguments.begin(), "aspects");
  const int code = run_command(static_cast<int>(arguments.size()), arguments.data(),
                               {output, messages, false, interrupted});
  return {code, output.str(), messages.str()};
}

json run_json(std::vector<const char*> arguments) {
  arguments.push_back("--json");
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  EXPECT_EQ(outcome.messages, "");
  return json::parse(outcome.output, nullptr, false);
}

std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

class Command : public testing::Test {
 protected:
  void SetUp() override { setenv("PARALLEL_ASPECTS_SHARE", PARALLEL_ASPECTS_SOURCE_DIR, 1); }
};

TEST_F(Command, HelpGoesToTheOutput) {
  for (const auto& arguments : std::vector<std::vector<const char*>>{
           {"--help"}, {"map", "--help"}, {"describe", "--help"}, {"ik", "--help"}, {"fk", "--help"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::ok);
    EXPECT_NE(outcome.output.find("Usage: aspects"), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.messages, "");
  }
}

TEST_F(Command, VersionIsPrinted) { EXPECT_EQ(run({"--version"}).output.rfind("aspects ", 0), 0U); }

TEST_F(Command, MisunderstoodCommandLinesAreUsageErrors) {
  for (const auto& arguments : std::vector<std::vector<const char*>>{{},
                                                                     {"draw"},
                                                                     {"map", "five_bar", "--colour"},
                                                                     {"ik", "five_bar"},
                                                                     {"ik", "five_bar", "--pose", "1", "2"},
                                                                     {"fk", "five_bar", "--joints"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_usage);
    EXPECT_EQ(outcome.output, "");
    EXPECT_NE(outcome.messages, "");
  }
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
  EXPECT_FALSE(answer["parallel"].contains("leg"));
  EXPECT_NEAR(answer["serial"]["lower"], 3.821220, 1e-6);
  EXPECT_TRUE(answer["serial"].contains("leg"));
  EXPECT_EQ(answer["drive_limit"]["status"], "absent");
  EXPECT_TRUE(answer["drive_limit"]["lower"].is_null());
}

TEST_F(Command, DistancesAreATable) {
  const Outcome outcome = run({"distance", "bipod", "--pose", "2 4"});
  EXPECT_EQ(outcome.code, exit_code::ok);
  EXPECT_NE(outcome.output.find("drive limit, "), std::string::npos) << outcome.output;
  EXPECT_EQ(run({"distance", "five_bar", "--pose", "4.5 8", "--boxes", "0"}).code, exit_code::bad_input);
  EXPECT_EQ(run({"distance", "five_bar", "--pose", "4.5 8", "--tolerance", "2"}).code, exit_code::bad_input);
  EXPECT_EQ(run({"distance", "five_bar", "--pose", "4.5 80"}).code, exit_code::ok);
}

TEST_F(Command, UnknownRobotIsAnsweredWithTheKnownOnes) {
  const Outcome outcome = run({"describe", "four_bar"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(outcome.output, "");
  EXPECT_NE(outcome.messages.find("'four_bar'"), std::string::npos);
  EXPECT_NE(outcome.messages.find("five_bar"), std::string::npos);
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
  EXPECT_NE(outcome.messages.find("/no/such/folder"), std::string::npos);
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
}

TEST_F(Command, DescribesTheFiveBarOfThePaper) {
  const json robot = run_json({"describe", "five_bar"});
  EXPECT_EQ(robot.at("task_space"), "T2");
  EXPECT_EQ(robot.at("mobility"), 2);
  EXPECT_EQ(robot.at("idle_freedoms"), 0);
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
      EXPECT_NE(solution.at("reason").get<std::string>().find("cannot reach"), std::string::npos);
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

TEST_F(Command, DirectTellsTheTrivialSolutionsOfTheAgileEyeApart) {
  const json modes = run_json({"fk", "agile_eye", "--joints", "0.3 0.2 -0.4"}).at("assembly_modes");
  EXPECT_EQ(modes.size(), 8U);
  int trivial = 0;
  for (const json& mode : modes) {
    if (mode.at("serially_singular").get<bool>()) ++trivial;
    EXPECT_EQ(mode.at("working_mode").is_null(), mode.at("serially_singular").get<bool>()) << mode;
  }
  EXPECT_EQ(trivial, 4);
  const Outcome outcome = run({"fk", "agile_eye", "--joints", "0.3 0.2 -0.4"});
  EXPECT_NE(outcome.output.find("8 assembly modes, 4 of them at a serial singularity"), std::string::npos)
      << outcome.output;
}

TEST_F(Command, InverseTellsOfPassiveLimits) {
  const json answer = run_json({"ik", "five_bar", "--pose", "4.5 8"});
  for (const json& solution : answer.at("solutions"))
    EXPECT_TRUE(solution.at("joint_outside_limits").is_null());
}

TEST_F(Command, EmptyValuesAreRefused) {
  for (const char* option : {"--mode", "--resolution", "--slice", "--save", "--constraint"}) {
    const Outcome outcome = run({"map", "five_bar", option, ""});
    EXPECT_EQ(outcome.code, exit_code::bad_usage) << option;
    EXPECT_NE(outcome.messages.find(std::string(option) + ": it is empty"), std::string::npos);
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

TEST_F(Command, MapHasTheTenAspectsOfThePaper) {
  const json map = run_json({"map", "five_bar"});
  EXPECT_EQ(map.at("proved_count"), 10);
  EXPECT_EQ(map.at("inside_components"), 10);
  EXPECT_EQ(map.at("unresolved"), json::array());
  std::map<std::string, int> count;
  for (const json& aspect : map.at("aspects"))
    ++count[aspect.at("working_mode").dump() + (aspect.at("det_a_sign").get<int>() > 0 ? "+" : "-")];
  const std::map<std::string, int> expected{{"[1,1]+", 1},  {"[1,1]-", 1},  {"[-1,-1]+", 1}, {"[-1,-1]-", 1},
                                            {"[1,-1]+", 2}, {"[1,-1]-", 1}, {"[-1,1]+", 1},  {"[-1,1]-", 2}};
  EXPECT_EQ(count, expected);
}

TEST_F(Command, MapHasTheDocumentedFields) {
  const json map = run_json({"map", "five_bar", "--resolution", "0.5", "--threads", "1"});
  for (const char* field :
       {"mechanism", "task_space", "resolution", "seconds", "loaded", "working_modes", "aspects",
        "proved_count", "inside_components", "unresolved", "measure_undecided"})
    EXPECT_TRUE(map.contains(field)) << field;
  for (const json& aspect : map.at("aspects"))
    for (const char* field : {"id", "working_mode", "det_a_sign", "measure", "unit", "inside_leaves",
                              "bounding_box", "deepest_pose"})
      EXPECT_TRUE(aspect.contains(field)) << field;
  EXPECT_LE(map.at("resolution").get<double>(), 0.5);
}

TEST_F(Command, ConstraintsAreChosen) {
  const json whole = run_json({"map", "five_bar", "--resolution", "0.5"});
  EXPECT_TRUE(whole["constraints"].empty());
  const json bounded = run_json({"map", "five_bar", "--resolution", "0.5", "--constraint", "self_collision"});
  ASSERT_EQ(bounded["constraints"].size(), 1U);
  EXPECT_EQ(bounded["constraints"][0]["name"], "self_collision");
  EXPECT_GT(bounded["constraints"][0]["undecided_leaves"], 10);
  EXPECT_EQ(bounded["proved_count"], 10);
  EXPECT_EQ(run_json({"map", "bipod"})["constraints"][0]["name"], "driven_limits");
  EXPECT_TRUE(bounded["empty_working_modes"].empty());
}

TEST_F(Command, BadConstraintsAreRefused) {
  const std::vector<std::pair<std::vector<const char*>, std::string>> cases{
      {{"map", "five_bar", "--constraint", "gravity"},
       "--constraint names 'gravity'; give some of driven_limits, passive_limits, self_collision, obstacles, "
       "workspace, all or none.\n"},
      {{"map", "five_bar", "--no-constraint", "gravity"},
       "--no-constraint names 'gravity'; give some of driven_limits, passive_limits, self_collision, "
       "obstacles, "
       "workspace, all or none.\n"},
      {{"map", "five_bar", "--constraint", "obstacles"},
       "--constraint names obstacles, which 'five_bar' has none of; state it in the robot's YAML or URDF, or "
       "leave it out.\n"},
      {{"map", "bipod", "--no-constraint", "driven_limits"},
       "The legs of 'bipod' have no limits that bound the workspace; limit the drives in the URDF, or give a "
       "region or a workspace.\n"},
      {{"map", "three_prr", "--constraint", "driven_limits,self_collision", "--slice", "phi=0"},
       "Maps of slices of planar robots know no constraints but driven_limits; leave the others out, or map "
       "all "
       "poses.\n"}};
  for (const auto& [arguments, sentence] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    EXPECT_EQ(outcome.messages, sentence);
  }
}

TEST_F(Command, SlicesAreMapped) {
  const json plane =
      run_json({"map", "stewart", "--slice", "z=1.3, roll=0 pitch=0 yaw=0", "--resolution", "0.1"});
  EXPECT_EQ(plane.at("slice").at("held").at("z"), 1.3);
  EXPECT_EQ(plane.at("slice").at("free"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(plane.at("unit"), "m^2");
  EXPECT_EQ(plane.at("region").at("lower").size(), 2U);
  EXPECT_EQ(plane.at("proved_count"), 1);
  EXPECT_EQ(plane.at("aspects").at(0).at("deepest_pose").at("z"), 1.3);
  const json line = run_json({"map", "three_rrr", "--slice", "x=-3 y=0", "--mode", "(+,+,+) (-,+,+)"});
  EXPECT_EQ(line.at("slice").at("free"), (std::vector<std::string>{"phi"}));
  EXPECT_EQ(line.at("unit"), "rad");
  EXPECT_LE(line.at("working_modes").size(), 2U);
  EXPECT_TRUE(run_json({"map", "five_bar"}).at("slice").is_null());
}

TEST_F(Command, NeighboursAreToldWhereAsked) {
  const json map = run_json({"map", "five_bar", "--neighbours"});
  ASSERT_EQ(map.at("neighbours").size(), 18U);
  const json& first = map.at("neighbours").at(0);
  EXPECT_EQ(first.at("aspects"), (std::vector<int>{1, 2}));
  EXPECT_EQ(first.at("crossing"), "parallel");
  EXPECT_TRUE(first.at("leg").is_null());
  EXPECT_EQ(first.at("proved"), true);
  EXPECT_EQ(first.at("pose").size(), 2U);
  EXPECT_EQ(map.at("neighbours").at(1).at("leg"), "leg_1");
  EXPECT_EQ(run_json({"map", "five_bar"}).count("neighbours"), 0U);
  EXPECT_NE(run({"map", "five_bar", "--neighbours"}).output.find("B_jj = 0 of leg_1"), std::string::npos);
  EXPECT_EQ(run({"map", "stewart", "--neighbours"}).code, exit_code::bad_input);
}

TEST_F(Command, MapsWithTwoCoordinatesAreDrawn) {
  const std::string file = testing::TempDir() + "aspects_drawn.svg";
  std::filesystem::remove(file);
  ASSERT_EQ(run({"map", "three_rrr", "--slice", "phi=0", "--mode", "(+,+,+) (-,+,+)", "--resolution", "1",
                 "--picture", file.c_str()})
                .code,
            exit_code::ok);
  std::ifstream stream(file);
  const std::string svg{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_NE(svg.find(">(+,+,+)<"), std::string::npos);
  EXPECT_NE(svg.find(">(-,+,+)<"), std::string::npos);
  EXPECT_EQ(svg.find(">(+,-,+)<"), std::string::npos);
  EXPECT_NE(svg.find("slice phi = 0 rad"), std::string::npos);
  std::filesystem::remove(file);
  const Outcome refused = run({"map", "delta", "--picture", file.c_str()});
  EXPECT_EQ(refused.code, exit_code::bad_input);
  EXPECT_EQ(refused.messages,
            "--picture is of two coordinates, but the map has 3; give a slice that leaves two free.\n");
  EXPECT_EQ(run({"map", "five_bar", "--picture", "/no/such/folder/a.svg"}).code, exit_code::bad_input);
  EXPECT_EQ(run({"map", "stewart", "--picture", file.c_str()}).code, exit_code::bad_input);
}

TEST_F(Command, BadSlicesAreRefused) {
  const std::map<std::vector<const char*>, const char*> refused{
      {{"map", "delta", "--slice", "phi=0"},
       "A slice of T3 has no coordinate 'phi'; hold some of x, y and z.\n"},
      {{"map", "delta", "--slice", "z"},
       "--slice has 'z'; give what is held with its value, such as \"z=0.5\".\n"},
      {{"map", "delta", "--slice", "z=high"},
       "--slice has 'high', which is not a finite number; give one.\n"},
      {{"map", "delta", "--mode", "(+,-)"},
       "--mode is '(+,-)'; give the signs of B_jj of each leg, such as \"(-,+,+)\", for each working "
       "mode.\n"},
      {{"map", "stewart", "--mode", "(-,+,+,+,+,+)", "--slice", "z=1.3 roll=0 pitch=0 yaw=0"},
       "'stewart' has no working mode (-,+,+,+,+,+); its first is (+,+,+,+,+,+).\n"},
      {{"map", "stewart", "--mode", "(+,+,+,+,+,+)"},
       "--mode is for maps of boxes, which there is none of in SE3 without --slice; leave it out.\n"},
      {{"map", "hexa", "--slice", "z=-0.6 roll=0 pitch=0", "--samples", "10"},
       "--samples and --seed are for roadmaps, in SE3 without --slice; the map of 'hexa' is one of boxes, so "
       "give --resolution.\n"}};
  for (const auto& [arguments, message] : refused) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << message;
    EXPECT_EQ(outcome.messages, message);
    EXPECT_EQ(outcome.output, "");
  }
}

TEST_F(Command, MapsAreSavedAndLoaded) {
  std::string folder = (std::filesystem::temp_directory_path() / "command_XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::string file = folder + "/map";
  const auto map = [&](const char* option) {
    return run_json({"map", "five_bar", "--resolution", "0.5", option, file.c_str()});
  };
  json computed = map("--save");
  EXPECT_EQ(computed.at("loaded"), false);
  json loaded = map("--load");
  EXPECT_EQ(loaded.at("loaded"), true);
  computed.erase("loaded");
  loaded.erase("loaded");
  EXPECT_EQ(computed, loaded);

  const std::vector<const char*> other{"map",        "five_bar", "--resolution", "0.2",   "--load",
                                       file.c_str(), "--save",   file.c_str(),   "--json"};
  Outcome outcome = run(other);
  EXPECT_EQ(outcome.code, exit_code::ok);
  EXPECT_EQ(line_count(outcome.messages), 1U) << outcome.messages;
  EXPECT_NE(outcome.messages.find("resolution"), std::string::npos) << outcome.messages;
  EXPECT_EQ(json::parse(outcome.output).at("loaded"), false);
  outcome = run(other);
  EXPECT_EQ(outcome.messages, "");
  EXPECT_EQ(json::parse(outcome.output).at("loaded"), true);
  std::filesystem::remove_all(folder);
}

TEST_F(Command, FilesOfMapsThatCannotBeAreRefused) {
  Outcome outcome = run({"map", "five_bar", "--resolution", "0.5", "--save", "/no/such/folder/map"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(outcome.output, "");
  EXPECT_NE(outcome.messages.find("/no/such/folder/map"), std::string::npos) << outcome.messages;
  outcome = run({"map", "stewart", "--load", "/no/such"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_NE(outcome.messages.find("--load"), std::string::npos) << outcome.messages;
}

TEST_F(Command, InterruptedMapPrintsNothing) {
  const std::atomic<bool> interrupted{true};
  const Outcome outcome = run({"map", "five_bar"}, &interrupted);
  EXPECT_EQ(outcome.code, exit_code::interrupted);
  EXPECT_EQ(outcome.output, "");
}

TEST_F(Command, UnwritableOutputIsAnError) {
  std::ostringstream messages;
  std::ostream output(nullptr);
  const std::vector<const char*> arguments{"aspects", "describe", "five_bar"};
  EXPECT_EQ(run_command(3, arguments.data(), {output, messages, false, nullptr}), exit_code::bad_input);
  EXPECT_NE(messages.str(), "");
}

}  // namespace
}  // namespace parallel_aspects::tools
