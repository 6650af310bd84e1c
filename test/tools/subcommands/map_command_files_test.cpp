// SPDX-License-Identifier: BSD-3-Clause
// Maps that are saved and loaded, and what the YAML of a robot or an option says of the region.
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::line_count;
using test::Outcome;
using test::run;
using test::run_json;

using MapCommandFiles = test::CommandTest;

std::string text_of(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(MapCommandFiles, MapsAreSavedAndLoaded) {
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
  EXPECT_TRUE(loaded.at("symmetry").is_null());
  for (const char* field : {"loaded", "symmetry"}) {
    computed.erase(field);
    loaded.erase(field);
  }
  EXPECT_EQ(computed, loaded);

  const std::vector<const char*> other{"map",        "five_bar", "--resolution", "0.2",   "--load",
                                       file.c_str(), "--save",   file.c_str(),   "--json"};
  Outcome outcome = run(other);
  EXPECT_EQ(outcome.code, exit_code::ok);
  EXPECT_EQ(line_count(outcome.messages), 1U) << outcome.messages;
  EXPECT_TRUE(test::has(outcome.messages, "resolution"));
  EXPECT_EQ(json::parse(outcome.output).at("loaded"), false);
  outcome = run(other);
  EXPECT_EQ(outcome.messages, "");
  EXPECT_EQ(json::parse(outcome.output).at("loaded"), true);
  std::filesystem::remove_all(folder);
}

// A script may name one file for both from its first run on.
TEST_F(MapCommandFiles, AFileForBothMayBeMissingTheFirstTime) {
  for (const std::vector<const char*>& question :
       {std::vector<const char*>{"map", "five_bar", "--resolution", "0.5"},
        std::vector<const char*>{"plan", "five_bar", "--resolution", "0.5", "--from", "4.5 8", "--to",
                                 "4 6"}}) {
    const std::string file = testing::TempDir() + "map_command_for_both.map";
    std::filesystem::remove(file);
    std::vector<const char*> all = question;
    all.insert(all.end(), {"--load", file.c_str(), "--save", file.c_str(), "--json"});
    for (const bool loaded : {false, true}) {
      const Outcome outcome = run(all);
      EXPECT_EQ(outcome.messages, "");
      EXPECT_EQ(json::parse(outcome.output).at("loaded"), loaded);
    }
    std::filesystem::remove(file);
  }
}

TEST_F(MapCommandFiles, FilesOfMapsThatCannotBeAreRefused) {
  Outcome outcome = run({"map", "five_bar", "--resolution", "0.5", "--save", "/no/such/folder/map"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(outcome.output, "");
  EXPECT_TRUE(test::has(outcome.messages, "/no/such/folder/map"));
  outcome = run({"map", "stewart", "--load", "/no/such"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(outcome.messages, "--load"));
}

/// A shipped robot whose YAML has another section `map`, in a file that goes with it.
class RobotWithSection {
 public:
  RobotWithSection(const std::string& robot, const std::string& section)
      : urdf_(std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/urdf/" + robot + ".urdf"),
        config_(testing::TempDir() + "map_command_" + robot + ".yaml") {
    std::ifstream shipped(std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/config/robots/" + robot + ".yaml");
    std::string text{std::istreambuf_iterator<char>(shipped), std::istreambuf_iterator<char>()};
    const std::string empty = "map: {}";
    text.replace(text.find(empty), empty.size(), "map: " + section);
    std::ofstream(config_) << text;
  }
  ~RobotWithSection() { std::filesystem::remove(config_); }

  std::vector<const char*> map(std::vector<const char*> options = {}) const {
    options.insert(options.begin(), {"map", "--urdf", urdf_.c_str(), "--config", config_.c_str()});
    return options;
  }

  const std::string& config() const { return config_; }

 private:
  std::string urdf_, config_;
};

TEST_F(MapCommandFiles, RegionsAreSearched) {
  const json part = run_json({"map", "five_bar", "--region", "x=1:8 y=2:9", "--resolution", "0.5"});
  EXPECT_EQ(part.at("region").at("lower").at("x"), 1.0);
  EXPECT_EQ(part.at("region").at("upper").at("y"), 9.0);
  EXPECT_LT(part.at("aspects").size(), 10U);
  const json plane = run_json(
      {"map", "delta", "--slice", "z=-0.6", "--region", "x=-0.25:0.125, y=0:0.125", "--mode", "+++"});
  EXPECT_EQ(plane.at("region").at("upper").at("x"), 0.125);
  EXPECT_EQ(plane.at("region").at("lower").at("y"), 0.0);
}

// The actuated joints of the bipod bound its workspace; without them a region does.
TEST_F(MapCommandFiles, RegionsBoundWhatNothingElseDoes) {
  EXPECT_EQ(run({"map", "bipod", "--no-constraint", "all"}).code, exit_code::bad_input);
  const json map = run_json({"map", "bipod", "--no-constraint", "all", "--region", "x=-5:5 y=-5:5"});
  EXPECT_EQ(map.at("proved_count"), 2);
}

TEST_F(MapCommandFiles, BadRegionsAreRefused) {
  const std::vector<std::pair<std::vector<const char*>, std::string>> cases{
      {{"map", "five_bar", "--region", "x=0:1"},
       "--region does not say where y may be; give \"x=-1:1 y=-1:1\", in m.\n"},
      {{"map", "five_bar", "--region", "x=0:1 y=0:1 z=0:1"},
       "--region has 'z=0:1'; give \"x=-1:1 y=-1:1\", in m.\n"},
      {{"map", "five_bar", "--region", "x=0 y=0:1"}, "--region has 'x=0'; give \"x=-1:1 y=-1:1\", in m.\n"},
      {{"map", "five_bar", "--region", "x=0:1 x=0:1 y=0:1"}, "--region names x twice; give one range.\n"},
      {{"map", "five_bar", "--region", "x=1:0 y=0:1"},
       "--region has 'x=1:0', whose lower end is not below the upper; give \"x=-1:1 y=-1:1\", in m.\n"},
      {{"map", "five_bar", "--region", "x=0:inf y=0:1"},
       "--region has 'inf', which is not a finite number; give one.\n"},
      {{"map", "three_rrr", "--slice", "y=0", "--region", "y=0:1"},
       "--region has 'y=0:1'; give \"x=-1:1\", in m.\n"
       "--region does not say where x may be; give \"x=-1:1\", in m.\n"},
      {{"map", "agile_eye", "--region", "x=0:1"},
       "--region is of positions, but here every orientation is searched and no more; leave it out.\n"}};
  for (const auto& [arguments, message] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << message;
    EXPECT_EQ(outcome.messages, message);
  }
}

TEST_F(MapCommandFiles, TheSectionOfTheRobotsFileIsRead) {
  const RobotWithSection robot("five_bar",
                               "{resolution: 0.75, threads: 1, extra_levels: 2, file: /nowhere/map, region: "
                               "{lower: [1, 2], upper: [8, 9]}}");
  const json map = run_json(robot.map());
  EXPECT_LE(map.at("resolution"), 0.75);
  EXPECT_GT(map.at("resolution"), 0.3);
  EXPECT_EQ(map.at("region").at("lower").at("y"), 2.0);
  const json over = run_json(robot.map({"--resolution", "0.25", "--region", "x=0:8 y=0:9"}));
  EXPECT_LE(over.at("resolution"), 0.25);
  EXPECT_EQ(over.at("region").at("lower").at("y"), 0.0);
  const json line = run_json(robot.map({"--slice", "y=5"}));
  EXPECT_EQ(line.at("region").at("lower").at("x"), 1.0);
  const Outcome beyond = run(robot.map({"--slice", "y=10"}));
  EXPECT_EQ(beyond.messages, "--slice holds position 2 at 10 m, outside of the map.region of " +
                                 robot.config() + "; hold it inside, or give --region.\n");
}

TEST_F(MapCommandFiles, TheSectionBoundsARoadmap) {
  const RobotWithSection robot("stewart", "{region: {lower: [0, 0, 1.2], upper: [0.1, 0.1, 1.3]}}");
  EXPECT_EQ(run_json(robot.map({"--samples", "20"})).at("samples"), 20);
}

TEST_F(MapCommandFiles, BadSectionsAreRefusedAtOnce) {
  const RobotWithSection robot(
      "five_bar", "{resolution: -1, threads: 1.5, extra_levels: 21, regoin: {}, region: {lower: [0]}}");
  const Outcome outcome = run(robot.map({"--threads", "many"}));
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  const std::string file = robot.config();
  EXPECT_EQ(outcome.messages,
            file + " has an unknown key 'regoin' under map; remove it, as 'region' is there.\n" + file +
                " has a map.resolution that is not positive; give one in m or rad, or leave it out.\n" +
                file + " has a map.threads that is no whole number from 0 to 1024; give one.\n" + file +
                " has a map.extra_levels that is no whole number from 0 to 20; give one.\n" + file +
                " does not say map.region.upper; give the corner in m.\n"
                "--threads is 'many'; give a whole number from 0 to 1024.\n");
  const RobotWithSection wrong("five_bar", "{region: {lower: [0, 0, 0], upper: [1, 1, 1]}}");
  EXPECT_EQ(run(wrong.map()).messages, wrong.config() +
                                           " has a map.region with 3 and 3 numbers; give 2 in lower and in "
                                           "upper, one a direction that the platform moves in.\n");
}

// Cones leave one of eight working modes, and limits of the motors bound it.
TEST_F(MapCommandFiles, CountsWithoutLimitsAreLeftOutWhereTheyWouldTakeLonger) {
  const std::string chains = PARALLEL_ASPECTS_SOURCE_DIR "/test/data/chains/delta_on_slides.";
  std::string urdf = text_of(chains + "urdf"),
              config = text_of(chains + "yaml") + "\nconstraints:\n  cones:\n";
  urdf = std::regex_replace(urdf, std::regex("<limit effort"), "<limit lower=\"-0.6\" upper=\"1.6\" effort");
  urdf =
      std::regex_replace(urdf, std::regex("(name=\"crank_._joint\" type=)\"continuous\""), "$1\"revolute\"");
  for (const char* leg : {"1", "2", "3"})
    config += std::string("    - {leg: ") + leg + ", end: base, axis: [0, 1, 0], angle: 1.2}\n";
  const std::string urdf_file = testing::TempDir() + "limited.urdf",
                    config_file = testing::TempDir() + "limited.yaml";
  std::ofstream(urdf_file) << urdf;
  std::ofstream(config_file) << config;
  const auto counts = [&](const char* resolution) {
    return run_json({"map", "--urdf", urdf_file.c_str(), "--config", config_file.c_str(), "--resolution",
                     resolution})
        .contains("without_limits");
  };
  EXPECT_TRUE(counts("0.1"));
  EXPECT_FALSE(counts("0.03"));
}

}  // namespace
}  // namespace parallel_aspects::tools
