// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
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

using MapCommand = test::CommandTest;

TEST_F(MapCommand, MapHasTheTenAspectsOfThePaper) {
  const json map = run_json({"map", "five_bar"});
  EXPECT_EQ(map.at("proved_count"), 10);
  EXPECT_EQ(map.at("inside_components"), 10);
  EXPECT_EQ(map.at("unresolved"), json::array());
  std::map<std::string, int> count;
  for (const json& aspect : map.at("aspects"))
    ++count[aspect.at("working_mode").dump() + (aspect.at("determinant_sign").get<int>() > 0 ? "+" : "-")];
  const std::map<std::string, int> expected{{"[1,1]+", 1},  {"[1,1]-", 1},  {"[-1,-1]+", 1}, {"[-1,-1]-", 1},
                                            {"[1,-1]+", 2}, {"[1,-1]-", 1}, {"[-1,1]+", 1},  {"[-1,1]-", 2}};
  EXPECT_EQ(count, expected);
}

TEST_F(MapCommand, MapHasTheDocumentedFields) {
  const json map = run_json({"map", "five_bar", "--resolution", "0.5", "--threads", "1"});
  for (const char* field :
       {"mechanism", "task_space", "resolution", "seconds", "loaded", "working_modes", "aspects",
        "proved_count", "inside_components", "unresolved", "measure_undecided"})
    EXPECT_TRUE(map.contains(field)) << field;
  for (const json& aspect : map.at("aspects"))
    for (const char* field : {"id", "working_mode", "determinant_sign", "measure", "unit", "inside_leaves",
                              "bounding_box", "deepest_pose", "color"})
      EXPECT_TRUE(aspect.contains(field)) << field;
  EXPECT_LE(map.at("resolution").get<double>(), 0.5);
}

TEST_F(MapCommand, CountsClaimNoMoreThanIsProved) {
  const std::string proved = run({"map", "five_bar", "--resolution", "0.5"}).output;
  EXPECT_EQ(proved.substr(0, proved.find('\n')), "five_bar: exactly 10 aspects (proved); 4 working modes");
  EXPECT_FALSE(test::has(proved, "may hide"));
  const std::string apart = run({"map", "three_prr", "--resolution", "0.2"}).output;
  EXPECT_EQ(apart.substr(0, apart.find('\n')),
            "three_prr: at least 16 aspects (16 components; all proved distinct); 8 working modes");
  EXPECT_TRUE(test::has(apart, "; smaller aspects may hide there, which --complete searches\n"));
}

TEST_F(MapCommand, CountsSayWhereTheyAreOfLessThanTheRobot) {
  const auto headline = [this](const std::vector<const char*>& arguments) {
    const std::string text = run(arguments).output;
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(headline({"map", "five_bar", "--region", "x=4:5 y=-13:13"}),
            "five_bar: exactly 12 aspects in the region (proved); 4 working modes");
  EXPECT_EQ(headline({"map", "five_bar", "--mode", "(+,+)"}),
            "five_bar: exactly 2 aspects (proved); 1 of 4 working modes");
  EXPECT_TRUE(run_json({"map", "five_bar", "--region", "x=4:5 y=-13:13"}).at("cut_by_region"));
  for (const char* robot : {"five_bar", "bipod", "three_rpr", "agile_eye"})
    EXPECT_FALSE(run_json({"map", robot, "--resolution", "1"}).at("cut_by_region")) << robot;
}

TEST_F(MapCommand, SmallAspectsAreOneLineUnlessAskedFor) {
  const std::vector<const char*> question{"map", "five_bar", "--region", "x=0:9 y=-9.5:9.5"};
  const std::string text = run(question).output;
  EXPECT_TRUE(test::has(text, "\nand 2 more, each below 1 % of the largest, together 0.1304"));
  EXPECT_FALSE(test::has(text, "\n 7  "));
  std::vector<const char*> all = question;
  all.push_back("--all");
  const std::string whole = run(all).output;
  EXPECT_FALSE(test::has(whole, " more, each below"));
  EXPECT_TRUE(test::has(whole, "\n 7  "));
}

TEST_F(MapCommand, EmptyRegionsAreNotPrinted) {
  const std::string text = run({"map", "agile_eye", "--resolution", "0.5"}).output;
  EXPECT_FALSE(test::has(text, "region"));
  EXPECT_FALSE(test::has(text, "bounds"));
}

TEST_F(MapCommand, ReportsWhichSymmetriesItUsed) {
  const json map = run_json({"map", "five_bar", "--resolution", "0.5"});
  EXPECT_EQ(map["symmetry"]["motions"], json::array({"(x, -y)"}));
  EXPECT_EQ(map["symmetry"]["computed_modes"], 2);
  const json without = run_json({"map", "five_bar", "--resolution", "0.5", "--no-symmetry"});
  EXPECT_TRUE(without["symmetry"]["motions"].empty());
  EXPECT_EQ(without["symmetry"]["computed_modes"], 4);
  EXPECT_EQ(without["proved_count"], map["proved_count"]);
}

TEST_F(MapCommand, ConstraintsAreChosen) {
  const json whole = run_json({"map", "five_bar", "--resolution", "0.5"});
  EXPECT_TRUE(whole["constraints"].empty());
  const json bounded = run_json({"map", "five_bar", "--resolution", "0.5", "--constraint", "self_collision"});
  ASSERT_EQ(bounded["constraints"].size(), 1U);
  EXPECT_EQ(bounded["constraints"][0]["name"], "self_collision");
  EXPECT_GT(bounded["constraints"][0]["undecided_leaves"], 10);
  EXPECT_EQ(bounded["proved_count"], 10);
  EXPECT_EQ(run_json({"map", "bipod"})["constraints"][0]["name"], "actuated_limits");
  EXPECT_TRUE(bounded["empty_working_modes"].empty());
}

TEST_F(MapCommand, ConesAreNamedAndCanBeLeftOut) {
  const std::string source = PARALLEL_ASPECTS_SOURCE_DIR;
  const std::string urdf = source + "/urdf/delta.urdf", config = source + "/test/data/delta_with_cones.yaml";
  const json robot = run_json({"describe", "--urdf", urdf.c_str(), "--config", config.c_str()});
  ASSERT_EQ(robot["cones"].size(), 9U);
  EXPECT_EQ(robot["cones"][1], json::parse(R"({"leg": "leg_1", "end": "base", "fixed_in": "crank",
                                               "axis": [0.0, 0.0, -1.0], "angle": 2.27, "joint": null})"));
  EXPECT_EQ(robot["cones"][6]["fixed_in"], "platform");
  const auto line = [&](const char* option, const char* list) {
    return run_json({"map", "--urdf", urdf.c_str(), "--config", config.c_str(), "--slice", "x=0 y=0.1",
                     "--resolution", "0.02", option, list});
  };
  const json bounded = line("--constraint", "all");
  ASSERT_EQ(bounded["constraints"].size(), 1U);
  EXPECT_EQ(bounded["constraints"][0]["name"], "cones");
  const json free = line("--no-constraint", "cones");
  EXPECT_TRUE(free["constraints"].empty());
  EXPECT_LT(bounded["aspects"].size(), free["aspects"].size());
}

TEST_F(MapCommand, ProvesForRobotsWithinATolerance) {
  const auto with = [](const char* share) {
    return run({"map", "five_bar", "--resolution", "0.5", "--tolerance", share});
  };
  EXPECT_TRUE(test::has(with("0.001").output, "for every robot whose points and lengths are within 0.022 m"));
  EXPECT_FALSE(test::has(with("0").output, "for every robot"));
  for (const char* wrong : {"0.2", "-0.1", "nan", "small"}) EXPECT_NE(with(wrong).code, 0) << wrong;
}

// A larger margin leaves less, and the small components of the Delta go first.
TEST_F(MapCommand, MarginsLeaveWhatIsDeep) {
  const auto five_bar = [&](const char* margin) {
    return run_json({"map", "five_bar", "--resolution", "0.5", "--margin", margin});
  };
  const json plain = run_json({"map", "five_bar", "--resolution", "0.5"}),
             some = five_bar("parallel=0.2,serial=0.1"), most = five_bar("parallel=0.6");
  EXPECT_TRUE(plain["margins"].empty());
  EXPECT_EQ(some["margins"], json::parse(R"({"parallel": 0.2, "serial": 0.1})"));
  EXPECT_EQ(some["constraints"][0]["name"], "margins");
  EXPECT_EQ(plain["aspects"].size(), 10U);
  for (const json& aspect : most["aspects"]) EXPECT_GE(aspect["deepest_index"]["upper"], 0.6);
  for (const json& aspect : plain["aspects"]) {
    EXPECT_LE(aspect["deepest_index"]["lower"], aspect["deepest_index"]["upper"]);
    EXPECT_GT(aspect["deepest_index"]["lower"], 0.3);
  }
}

TEST_F(MapCommand, MarginsAndIndicesThatAreNoneAreRefused) {
  const std::vector<std::vector<const char*>> questions{
      {"--margin", "paralel=0.1"}, {"--margin", "parallel=1.1"}, {"--margin", "0.1"}, {"--index", "sine"}};
  for (const auto& question : questions) {
    const Outcome outcome = run({"map", "five_bar", question[0], question[1]});
    EXPECT_EQ(outcome.code, exit_code::bad_input) << question[1];
    EXPECT_TRUE(test::has(outcome.messages, "parallel"));
  }
  const auto message = [](std::vector<const char*> options) {
    options.insert(options.begin(), {"map", "five_bar", "--resolution", "1"});
    return run(options).messages;
  };
  EXPECT_EQ(message({"--margin", "parallel=0.1 serial=0.1 parallel=0.2"}),
            "--margin names parallel twice; give one value for it.\n");
  EXPECT_EQ(message({"--margin", "parallel=0.1", "--no-constraint", "margins"}),
            "--margin sets margins and --no-constraint leaves them out; give one of the two.\n");
  EXPECT_EQ(message({"--margin", "parallel=0.1", "--constraint", "margins"}), "");
  EXPECT_NE(message({"--constraint", "margins"}), "");
  const Outcome roadmap = run({"map", "stewart", "--persistence"});
  EXPECT_EQ(roadmap.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(roadmap.messages, "--persistence is for maps of boxes"));
}

// A margin of the option takes the place of the YAML's of that name; those that it does not name hold.
TEST_F(MapCommand, MarginsOfTheOptionAreOverThoseOfTheYaml) {
  const std::string root = PARALLEL_ASPECTS_SOURCE_DIR, urdf = root + "/urdf/five_bar.urdf",
                    config = testing::TempDir() + "map_command_margins.yaml";
  std::ifstream shipped(root + "/config/robots/five_bar.yaml");
  const std::string text{std::istreambuf_iterator<char>(shipped), {}};
  std::ofstream(config) << text << "\nconstraints: {margins: {parallel: 0.9, serial: 0.1}}\n";
  const auto margins = [&](std::vector<const char*> options) {
    options.insert(options.begin(), {"map", "--urdf", urdf.c_str(), "--config", config.c_str(),
                                     "--resolution", "1", "--mode", "(+,-)"});
    return run_json(options).at("margins");
  };
  EXPECT_EQ(margins({}), json::parse(R"({"parallel": 0.9, "serial": 0.1})"));
  EXPECT_EQ(margins({"--margin", "parallel=0.2"}), json::parse(R"({"parallel": 0.2, "serial": 0.1})"));
  EXPECT_EQ(margins({"--margin", "parallel=0"}), json::parse(R"({"serial": 0.1})"));
  EXPECT_EQ(margins({"--margin", "parallel=0.2", "--no-constraint", "all"}),
            json::parse(R"({"parallel": 0.2})"));
  EXPECT_EQ(margins({"--no-constraint", "margins"}), json::object());
  // They are told wherever poses are asked about, with what a pose lacks of them.
  const auto told = [&](const std::vector<const char*>& question) {
    std::vector<const char*> words = question;
    words.insert(words.end(), {"--urdf", urdf.c_str(), "--config", config.c_str()});
    return run(words).output;
  };
  EXPECT_TRUE(test::has(told({"describe"}), "\nmargins from singularities: parallel 0.9, serial 0.1"));
  EXPECT_TRUE(
      test::has(told({"map", "--resolution", "1"}), "\nconstraints: margins (parallel 0.9, serial 0.1)"));
  for (const char* command : {"ik", "distance"}) {
    const std::string answer = told({command, "--pose", "4.5 2"});
    EXPECT_TRUE(test::has(answer, "the parallel index is 0."));
    EXPECT_TRUE(test::has(answer, ", below the margin 0.9"));
  }
}

TEST_F(MapCommand, PersistenceListsBasins) {
  const json map = run_json({"map", "five_bar", "--persistence"});
  const json& basins = map.at("basins");
  ASSERT_GE(basins.size(), 10U);
  EXPECT_EQ(basins[0]["deeper"], nullptr);
  std::size_t joined = 0;
  for (const json& basin : basins) {
    if (basin["deeper"].is_null()) continue;
    ++joined;
    EXPECT_LT(basin["saddle"]["upper"], basin["deepest_index"]["lower"]);
    EXPECT_EQ(basins[basin["deeper"].get<std::size_t>()]["aspect"], basin["aspect"]);
  }
  EXPECT_EQ(joined, basins.size() - 10);
  const std::string file = testing::TempDir() + "basins_drawn.svg";
  const std::string text =
      run({"map", "five_bar", "--persistence", "--persistence-picture", file.c_str()}).output;
  std::ifstream stream(file);
  const std::string svg{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_TRUE(test::has(svg, "five_bar: basins of its aspects"));
  EXPECT_TRUE(test::has(svg, "aspect 10 (-,-)"));
  EXPECT_TRUE(test::has(svg, ">det A &gt; 0</text>")) << "what the colours mean";
  std::size_t bars = 0;
  for (std::size_t at = svg.find("<rect x"); at != std::string::npos; at = svg.find("<rect x", at + 1))
    ++bars;
  EXPECT_GE(bars, 20U) << "two for each aspect, dark and light";
  EXPECT_TRUE(test::has(
      text,
      "\nbasins: parts of aspects that a larger margin separates, and the index at which they merge\n"));
}

// Where the limits cut nothing, or are nearly a full turn, the counts are the same.
TEST_F(MapCommand, CountsWithoutLimitsAreReported) {
  const json bipod = run_json({"map", "bipod", "--resolution", "0.2"});
  EXPECT_EQ(bipod.at("without_limits").at("components"), 2);
  EXPECT_EQ(bipod.at("without_limits").at("left_out"), json::array({"actuated_limits"}));
  const std::string told = "without limits of joints there are ";
  EXPECT_FALSE(test::has(run({"map", "bipod", "--resolution", "0.2"}).output, told)) << "the same";
  const std::string data = PARALLEL_ASPECTS_SOURCE_DIR "/test/data/";
  const std::string urdf = data + "nearly_a_turn.urdf", config = data + "strict_limits.yaml";
  const Outcome strict = run({"map", "--urdf", urdf.c_str(), "--config", config.c_str()});
  EXPECT_TRUE(test::has(
      strict.output,
      told + "10 in place of 20 components here; --no-constraint actuated_limits,passive_limits leaves them "
             "out, and so does constraints: {actuated_limits: false, passive_limits: false} in the YAML"));
  const std::string lenient = data + "nearly_a_turn.yaml";
  const Outcome whole = run({"map", "--urdf", urdf.c_str(), "--config", lenient.c_str()});
  EXPECT_FALSE(test::has(whole.output, told));
  EXPECT_TRUE(test::has(whole.output, "which bounds no aspect: 'crank_1_joint'"));
  EXPECT_FALSE(run_json({"map", "five_bar", "--resolution", "0.5"}).contains("without_limits"));
}

// It may take many times as long as the map, which is all that its time tells of.
TEST_F(MapCommand, WithManyBoxesCountsWithoutLimitsAreForThoseWhoAsk) {
  EXPECT_FALSE(run_json({"map", "bipod", "--resolution", "0.01"}).contains("without_limits"));
  const json asked = run_json({"map", "bipod", "--resolution", "0.01", "--without-limits"});
  EXPECT_EQ(asked.at("without_limits").at("components"), 2);
  EXPECT_FALSE(
      run_json({"map", "five_bar", "--resolution", "0.5", "--without-limits"}).contains("without_limits"))
      << "it has none";
}

TEST_F(MapCommand, BadConstraintsAreRefused) {
  const std::vector<std::pair<std::vector<const char*>, std::string>> cases{
      {{"map", "five_bar", "--constraint", "gravity"},
       "--constraint names 'gravity'; give some of actuated_limits, passive_limits, cones, self_collision, "
       "obstacles, workspace, margins, all or none.\n"},
      {{"map", "five_bar", "--no-constraint", "gravity"},
       "--no-constraint names 'gravity'; give some of actuated_limits, passive_limits, cones, "
       "self_collision, obstacles, workspace, margins, all or none.\n"},
      {{"map", "five_bar", "--constraint", "obstacles"},
       "--constraint names obstacles, but 'five_bar' has none; state them in the robot's YAML or URDF, or "
       "leave the name out.\n"},
      {{"map", "bipod", "--no-constraint", "actuated_limits"},
       "The legs of 'bipod' have no limits that bound the workspace; limit the actuated joints in the URDF, "
       "leave these limits in (actuated_limits), or give a region or a workspace.\n"}};
  for (const auto& [arguments, message] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    EXPECT_EQ(outcome.messages, message);
  }
}

TEST_F(MapCommand, SlicesAreMapped) {
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
  const json strut = run_json({"map", "three_rpr", "--slice", "strut_1_joint=14.98"});
  EXPECT_EQ(strut.at("slice").at("held").at("strut_1_joint"), 14.98);
  EXPECT_EQ(strut.at("slice").at("free"), (std::vector<std::string>{"direction", "phi"}));
  EXPECT_EQ(strut.at("unit"), "rad^2");
  EXPECT_TRUE(run_json({"map", "five_bar"}).at("slice").is_null());
}

TEST_F(MapCommand, NeighboursAreReportedWhereAsked) {
  const json map = run_json({"map", "five_bar", "--neighbours"});
  ASSERT_EQ(map.at("neighbours").size(), 18U);
  const json& first = map.at("neighbours").at(0);
  EXPECT_EQ(first.at("aspects"), (std::vector<int>{1, 2}));
  EXPECT_EQ(first.at("crossing"), "parallel");
  EXPECT_TRUE(first.at("leg").is_null());
  EXPECT_EQ(first.at("proved"), true);
  EXPECT_EQ(first.at("pose").size(), 2U);
  EXPECT_EQ(map.at("neighbours").at(1).at("leg"), "leg_1");
  EXPECT_TRUE(run_json({"map", "five_bar"}).at("neighbours").is_null());
  EXPECT_TRUE(test::has(run({"map", "five_bar", "--neighbours"}).output, "B_jj = 0 of leg_1"));
  EXPECT_EQ(run({"map", "stewart", "--neighbours"}).code, exit_code::bad_input);
}

TEST_F(MapCommand, MapsWithTwoCoordinatesAreDrawn) {
  const std::string file = testing::TempDir() + "aspects_drawn.svg";
  std::filesystem::remove(file);
  ASSERT_EQ(run({"map", "three_rrr", "--slice", "phi=0", "--mode", "(+,+,+) (-,+,+)", "--resolution", "1",
                 "--picture", file.c_str()})
                .code,
            exit_code::ok);
  std::ifstream stream(file);
  const std::string svg{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  EXPECT_TRUE(test::begins(svg, "<svg "));
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_TRUE(test::has(svg, ">working mode (+,+,+)<"));
  EXPECT_TRUE(test::has(svg, ">working mode (-,+,+)<"));
  EXPECT_FALSE(test::has(svg, ">working mode (+,-,+)<"));
  EXPECT_TRUE(test::has(svg, "slice phi = 0 rad"));
  std::filesystem::remove(file);
  EXPECT_EQ(run({"map", "five_bar", "--picture", "/no/such/folder/a.svg"}).code, exit_code::bad_input);
}

// Each remedy as it is typed again.
TEST_F(MapCommand, APictureOfMoreCoordinatesNamesASliceThatHasOne) {
  const std::string file = testing::TempDir() + "aspects_refused.svg";
  for (const char* robot :
       {"three_rrr", "three_rpr", "three_prr", "delta", "linear_delta", "stewart", "six_pus"}) {
    const Outcome refused = run({"map", robot, "--picture", file.c_str()});
    EXPECT_EQ(refused.code, exit_code::bad_input);
    EXPECT_EQ(test::line_count(refused.messages), 1U) << refused.messages;
    std::smatch slice;
    ASSERT_TRUE(std::regex_search(refused.messages, slice, std::regex("such as --slice \"([^\"]*)\"\\.\n")))
        << refused.messages;
    const std::string held = slice.str(1);
    const json map = run_json({"map", robot, "--slice", held.c_str(), "--picture", file.c_str()});
    EXPECT_FALSE(map.at("aspects").empty()) << robot << " at " << held;
    std::filesystem::remove(file);
  }
  EXPECT_EQ(run({"map", "agile_eye", "--picture", file.c_str()}).messages,
            "--picture is of two coordinates, but the map has 3; leave it out, and draw a section with "
            "`aspects plot`, such as --section \"torsion=0\".\n");
}

TEST_F(MapCommand, BadSlicesAreRefused) {
  const std::map<std::vector<const char*>, const char*> refused{
      {{"map", "delta", "--slice", "phi=0"},
       "A slice of T3 has no coordinate 'phi'; hold some of x, y and z.\n"},
      {{"map", "three_rpr", "--slice", "strut_4_joint=15"},
       "'three_rpr' has no pose coordinate or actuated joint 'strut_4_joint'; hold some of x, y and phi, or "
       "one of strut_1_joint, strut_2_joint or strut_3_joint.\n"},
      {{"map", "three_rpr", "--slice", "strut_1_joint=15", "--region", "x=0:1"},
       "--region is of positions, but here every direction and orientation is searched and no more; leave it "
       "out.\n"},
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
       "--mode is for maps of boxes, and in SE3 only slices have these; give --slice, or leave it out.\n"},
      {{"map", "hexa", "--slice", "z=-0.6 roll=0 pitch=0", "--samples", "10"},
       "--samples and --seed are for roadmaps, in SE3 without --slice; leave them out.\n"}};
  for (const auto& [arguments, message] : refused) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << message;
    EXPECT_EQ(outcome.messages, message);
    EXPECT_EQ(outcome.output, "");
  }
}

TEST_F(MapCommand, AMapWithoutAspectsSaysWhy) {
  const std::string text = run({"map", "five_bar", "--region", "x=50:60 y=0:3"}).output;
  EXPECT_TRUE(test::has(text, "exactly 0 aspects"));
  EXPECT_TRUE(test::has(text, "note: The region lies outside of what the legs can reach"));
  EXPECT_TRUE(run_json({"map", "five_bar", "--region", "x=50:60 y=0:3"})["no_aspect"].is_string());
  EXPECT_TRUE(run_json({"map", "five_bar"})["no_aspect"].is_null());
}

TEST_F(MapCommand, InterruptedMapPrintsNothing) {
  const std::atomic<bool> interrupted{true};
  const Outcome outcome = run({"map", "five_bar"}, &interrupted);
  EXPECT_EQ(outcome.code, exit_code::interrupted);
  EXPECT_EQ(outcome.output, "");
}

}  // namespace
}  // namespace parallel_aspects::tools
