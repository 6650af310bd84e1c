// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using test::run_json;

class PlanCommand : public test::CommandTest {};
class GraphCommand : public test::CommandTest {};

TEST_F(GraphCommand, HasTheTwoSetsOfTheFiveBar) {
  const json graph = run_json({"graph", "five_bar"});
  EXPECT_EQ(graph.at("aspects").size(), 10U);
  EXPECT_EQ(graph.at("proved_set_count"), 2);
  ASSERT_EQ(graph.at("sets").size(), 2U);
  for (const json& set : graph.at("sets")) {
    EXPECT_EQ(set.at("aspects").size(), 5U);
    EXPECT_TRUE(set.at("not_proved_apart_from").empty());
    for (const json& id : set.at("aspects"))
      EXPECT_EQ(graph.at("aspects")[id.get<std::size_t>() - 1].at("set"), set.at("set"));
  }
  for (const json& gate : graph.at("gates")) {
    EXPECT_EQ(gate.at("leg").is_null(), gate.at("crossing") == "parallel");
    EXPECT_EQ(gate.at("proved").get<bool>(), !gate.at("crossings").empty());
    double before = 1.0;
    for (const json& crossing : gate.at("crossings")) {
      EXPECT_GE(crossing.at("segment").size(), 2U);
      EXPECT_LE(crossing.at("index").get<double>(), before);
      before = crossing.at("index");
    }
  }
}

TEST_F(GraphCommand, SaysWhyNothingIsJoined) {
  const Outcome empty = run({"graph", "three_rpr", "--slice", "x=100"});
  EXPECT_EQ(empty.code, exit_code::ok);
  EXPECT_TRUE(test::has(empty.output, "holds no part of an aspect"));
  const json bipod = run_json({"graph", "bipod"});
  EXPECT_EQ(bipod.at("reason"),
            "2 aspects in 2 sets, each one aspect: with one working mode there are no serial gates; proved "
            "to be different");
}

// The gate of the bipod lies on y = 0, where faces between leaves do.
TEST_F(GraphCommand, HasCrossingsSpreadOverAGateOnFaces) {
  const json gates = run_json({"graph", "bipod"}).at("gates");
  ASSERT_EQ(gates.size(), 1U);
  double least = 10.0, most = -10.0;
  for (const json& crossing : gates[0].at("crossings")) {
    EXPECT_NEAR(crossing.at("pose").at("y").get<double>(), 0.0, 0.1);
    least = std::min(least, crossing.at("pose").at("x").get<double>());
    most = std::max(most, crossing.at("pose").at("x").get<double>());
  }
  EXPECT_GT(most - least, 0.3);
  EXPECT_GT(gates[0].at("crossings")[0].at("index").get<double>(), 0.3);
}

TEST_F(GraphCommand, GoesOverARoadmapWithSixDegreesOfFreedom) {
  const json stewart = run_json({"graph", "stewart", "--samples", "60"});
  EXPECT_EQ(stewart.at("proved_set_count"), 2);
  EXPECT_TRUE(stewart.at("gates").empty());
  EXPECT_EQ(stewart.at("sets").size(), stewart.at("aspects").size());
  const json joined = run_json({"graph", "six_pus", "--samples", "60"});
  EXPECT_GT(joined.at("gates").size(), 0U);
  EXPECT_LT(joined.at("sets").size(), joined.at("aspects").size());
  EXPECT_TRUE(joined.at("sets")[0].at("workspace_lower").is_null());
  for (const json& gate : joined.at("gates"))
    for (const char* key : {"aspects", "crossing", "leg", "proved", "pose", "crossings"})
      EXPECT_TRUE(gate.contains(key)) << key;
  const Outcome picture = run({"graph", "stewart", "--picture", "graph.svg"});
  EXPECT_EQ(picture.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(picture.messages, "--dot"));
  EXPECT_EQ(run({"graph", "five_bar", "--samples", "60"}).code, exit_code::bad_input);
}

TEST_F(GraphCommand, IsDrawnByGraphviz) {
  const Outcome outcome = run({"graph", "five_bar", "--dot"});
  EXPECT_EQ(outcome.code, exit_code::ok);
  EXPECT_TRUE(test::begins(outcome.output, "graph aspects {"));
  EXPECT_TRUE(test::has(outcome.output, "cluster_2"));
  EXPECT_TRUE(test::has(outcome.output, "label=\"leg 1\""));
}

// A circle for each aspect and a line for each gate, beside those of the legend.
TEST_F(GraphCommand, IsDrawnAsSvg) {
  const std::string file = testing::TempDir() + "aspects_graph_test.svg";
  const json graph = run_json({"graph", "five_bar", "--picture", file.c_str()});
  std::ifstream stream(file);
  const std::string svg{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const auto count = [&svg](const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_TRUE(test::begins(svg, "<svg"));
  EXPECT_EQ(count("<circle"), graph.at("aspects").size());
  EXPECT_EQ(count("<path"), graph.at("gates").size());
  EXPECT_EQ(count("<line"), 4U);
  const Outcome nowhere = run({"graph", "five_bar", "--picture", "/nowhere/graph.svg"});
  EXPECT_EQ(nowhere.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(nowhere.messages, "--picture"));
}

TEST_F(PlanCommand, PassesAGateWhereThatIsAllowed) {
  const std::vector<const char*> question{"plan",  "five_bar", "--from", "4.5 8",     "--from-mode",
                                          "(+,+)", "--to",     "4.5 -8", "--to-mode", "(-,+)"};
  EXPECT_EQ(run(question).code, exit_code::proved_no);
  std::vector<const char*> serial = question;
  serial.insert(serial.end(), {"--policy", "serial"});
  const json path = run_json(serial);
  EXPECT_EQ(path.at("answer"), "yes");
  EXPECT_EQ(path.at("proved"), true);
  ASSERT_EQ(path.at("crossings").size(), 1U);
  const auto point = path.at("crossings")[0].at("after_point").get<std::size_t>();
  EXPECT_EQ(path.at("crossings")[0].at("leg"), "leg_1");
  EXPECT_EQ(path.at("path")[point].at("working_mode"), json::parse("[1, 1]"));
  EXPECT_EQ(path.at("path")[point + 1].at("working_mode"), json::parse("[-1, 1]"));
  EXPECT_EQ(path.at("path")[0].at("pose"), json::parse(R"({"x": 4.5, "y": 8.0})"));
  EXPECT_GT(path.at("length").get<double>(), 16.0);
}

TEST_F(PlanCommand, KeepsAMarginThatIsAskedFor) {
  const json path =
      run_json({"plan", "five_bar", "--from", "4.5 8", "--to", "4.5 6", "--margin", "parallel=0.2"});
  EXPECT_EQ(path.at("answer"), "yes");
  EXPECT_GE(path.at("least_index").get<double>(), 0.2);
}

TEST_F(PlanCommand, HoldsAnActuatedJoint) {
  const json path =
      run_json({"plan", "three_rpr", "--slice", "strut_1_joint=14.98", "--from",
                "14.67394366 -3.01260312 2.13290437", "--to", "-5.49566082 -13.93549828 -0.04733137"});
  EXPECT_EQ(path.at("answer"), "yes");
  for (const json& point : path.at("path")) EXPECT_NEAR(point.at("actuated")[0].get<double>(), 14.98, 1e-9);
  EXPECT_LT(path.at("moved_onto_slice").get<double>(), 1e-6);
}

TEST_F(PlanCommand, GoesOverARoadmapWithSixDegreesOfFreedom) {
  const json path = run_json(
      {"plan", "stewart", "--from", "0 0 1.3 0 0 0 1", "--to", "0.2 0.3 1.2 0.1 0 0 1", "--samples", "50"});
  EXPECT_EQ(path.at("answer"), "yes");
  EXPECT_GE(path.at("path").size(), 2U);
}

TEST_F(PlanCommand, NamesWhatIsWrong) {
  const auto refusal = [](const std::vector<const char*>& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    EXPECT_EQ(outcome.output, "");
    return outcome.messages;
  };
  EXPECT_TRUE(test::has(refusal({"plan", "five_bar", "--from", "4.5", "--to", "4.5 6"}), "--from"));
  EXPECT_TRUE(test::has(refusal({"plan", "five_bar", "--from", "4.5 8", "--to", "4.5 6", "--policy", "fly"}),
                        "'fly'"));
  EXPECT_TRUE(test::has(
      refusal({"plan", "five_bar", "--from", "4.5 8", "--to", "4.5 6", "--samples", "9", "--policy", "any"}),
      "leave --samples and --seed out"));
  EXPECT_TRUE(test::has(
      refusal({"plan", "stewart", "--from", "0 0 1.3 0 0 0 1", "--to", "0 0 1.2 0 0 0 1", "--policy", "any"}),
      "--policy any needs a map"));
  EXPECT_TRUE(test::has(refusal({"plan", "five_bar", "--from", "4.5 8", "--to", "4.5 6", "--prefer", "best"}),
                        "'best'"));
  EXPECT_TRUE(test::has(refusal({"plan", "five_bar", "--from", "4.5 8", "--to", "4.5 6", "--prefer", "fast",
                                 "--policy", "any"}),
                        "--prefer fast needs a platform that is under control"));
  EXPECT_TRUE(test::has(refusal({"plan", "five_bar", "--from", "4.5 8", "--to", "4.5 6", "--prefer", "fast",
                                 "--acceleration", "0 1"}),
                        "--acceleration has a number that is not positive"));
}

TEST_F(PlanCommand, TakesThePathThatIsPreferred) {
  const auto path = [](const char* prefer) {
    return run_json({"plan", "five_bar", "--from-aspect", "1", "--to-aspect", "3", "--policy", "serial",
                     "--prefer", prefer});
  };
  const json shortest = path("short"), clear = path("clear"), fast = path("fast");
  EXPECT_EQ(clear.at("prefer"), "clear");
  EXPECT_LE(shortest.at("length").get<double>(), clear.at("length").get<double>());
  EXPECT_GE(clear.at("least_index").get<double>(), shortest.at("least_index").get<double>());
  EXPECT_LE(fast.at("seconds").get<double>(), shortest.at("seconds").get<double>());
  EXPECT_LE(shortest.at("length").get<double>(), fast.at("length").get<double>());
  EXPECT_LE(shortest.at("length").get<double>(), path("quick").at("length").get<double>());
}

TEST_F(PlanCommand, NamesTheWorkingModeOfAPathThatStays) {
  const json path = run_json({"plan", "five_bar", "--from", "4.5 8", "--to", "4 6"});
  EXPECT_TRUE(test::has(path.at("reason").get<std::string>(), "in the working mode ("));
}

// An assembly mode of actuated values is told by a pose near it; an aspect by its number.
TEST_F(PlanCommand, TakesActuatedValuesAndAspects) {
  const json pose = run_json({"plan", "five_bar", "--from", "4.5 8", "--from-mode", "(+,+)", "--to", "4 6"});
  const json actuated = pose.at("path")[0].at("actuated");
  const std::string joints =
      std::to_string(actuated[0].get<double>()) + " " + std::to_string(actuated[1].get<double>());
  const json again =
      run_json({"plan", "five_bar", "--from-joints", joints.c_str(), "--from", "4.5 7", "--to", "4 6"});
  EXPECT_EQ(again.at("answer"), "yes");
  EXPECT_NEAR(again.at("path")[0].at("pose").at("y").get<double>(), 8.0, 1e-4);
  const Outcome several = run({"plan", "five_bar", "--from-joints", joints.c_str(), "--to", "4 6"});
  EXPECT_EQ(several.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(several.messages, "several poses"));
  const json aspects =
      run_json({"plan", "five_bar", "--from-aspect", "1", "--to-aspect", "3", "--policy", "serial"});
  EXPECT_EQ(aspects.at("answer"), "yes");
  const Outcome none = run({"plan", "five_bar", "--from-aspect", "11", "--to", "4 6"});
  EXPECT_EQ(none.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(none.messages, "the aspects 1 to 10"));
}

// By a whole turn as the robot stands, which a trajectory must begin with.
TEST_F(PlanCommand, BeginsInTheTurnThatIsGiven) {
  const auto first = [](const char* joints) {
    const json path =
        run_json({"plan", "five_bar", "--from-joints", joints, "--from", "4.5 8", "--to", "4 6"});
    return path.at("path")[0].at("actuated")[0].get<double>();
  };
  EXPECT_NEAR(first("0.48348 1.02791"), 0.48348, 1e-9);
  EXPECT_NEAR(first("6.7666653 1.02791"), 6.7666653, 1e-9);
  EXPECT_NEAR(first("-5.7997053 1.02791"), -5.7997053, 1e-9);
  const json goal = run_json({"plan", "five_bar", "--to-joints", "6.7666653 1.02791", "--to", "4.5 8",
                              "--from", "4 6", "--from-mode", "(+,+)"});
  EXPECT_TRUE(
      test::has(goal.at("reason").get<std::string>(), "'crank_1_joint' arrives at 0.48348, whole turns"))
      << goal.at("reason");
}

TEST_F(PlanCommand, RefusesNumbersThatProofsDoNotReach) {
  for (const char* joints : {"1e13 1", "-1e13 1"}) {
    const Outcome outcome =
        run({"plan", "five_bar", "--from-joints", joints, "--from", "4.5 8", "--to", "4 6"});
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    EXPECT_TRUE(test::has(outcome.messages, "--from-joints has"));
  }
  EXPECT_EQ(run({"plan", "five_bar", "--from", "4 6", "--to", "1e13 0"}).code, exit_code::bad_input);
}

// With cranks of 8 and rods of 5 the leg is folded at a distance of 3 and stretched at 13.
TEST_F(PlanCommand, NamesALegThatIsStretchedOrFolded) {
  for (const char* end : {"3 0", "13 0", "0 -3"}) {
    const Outcome outcome = run({"plan", "five_bar", "--from", end, "--to", "4 6"});
    EXPECT_EQ(outcome.code, exit_code::proved_no);
    EXPECT_TRUE(test::has(outcome.output, "leg 'leg_1' is stretched or folded there (B_jj = 0)"));
  }
  const Outcome beyond = run({"plan", "five_bar", "--from", "2.999 0", "--to", "4 6"});
  EXPECT_TRUE(test::has(beyond.output, "leg 'leg_1' cannot reach it"));
}

// Before a map is computed, which would take long at this resolution.
TEST_F(PlanCommand, RefusesEndsThatNoAspectHoldsBeforeTheMap) {
  const std::vector<const char*> question{"plan",         "delta", "--from", "0 0 -0.8",
                                          "--resolution", "0.002", "--to"};
  const auto to = [&](std::vector<const char*> rest) {
    rest.insert(rest.begin(), question.begin(), question.end());
    return run(rest);
  };
  const Outcome far = to({"5 5 5"});
  EXPECT_EQ(far.code, exit_code::proved_no);
  EXPECT_TRUE(test::has(far.output, "no aspect holds the goal: leg 'leg_1' cannot reach it."));
  const Outcome margin = to({"0 0 -0.9", "--margin", "parallel=0.9"});
  EXPECT_EQ(margin.code, exit_code::proved_no);
  EXPECT_TRUE(
      test::has(margin.output, "Proved: no aspect holds the start: in (-,-,-) the parallel index is"));
  const Outcome one_mode = to({"0 0 -0.9", "--margin", "parallel=0.9", "--from-mode", "(+,+,+)"});
  EXPECT_TRUE(test::has(one_mode.output, "holds the start: the parallel index is 0."));
}

TEST_F(PlanCommand, SavesTheMapAndSaysWhetherItIsUsed) {
  const std::string file = testing::TempDir() + "plan_command_test.map";
  std::remove(file.c_str());
  const std::vector<const char*> question{"plan", "five_bar", "--from", "4.5 8", "--to", "4 6"};
  const auto with = [&](const char* option) {
    std::vector<const char*> all = question;
    all.insert(all.end(), {option, file.c_str()});
    return all;
  };
  EXPECT_EQ(run_json(with("--save")).at("loaded"), false);
  EXPECT_EQ(run_json(with("--load")).at("loaded"), true);
  EXPECT_TRUE(test::has(run(with("--load")).output, "the map is that of " + file));
  const json graph = run_json({"graph", "five_bar", "--load", file.c_str()});
  EXPECT_EQ(graph.at("loaded"), true);
  const Outcome other = run({"plan", "bipod", "--from", "2 3", "--to", "1.8 3", "--load", file.c_str()});
  EXPECT_TRUE(test::has(other.output, "the map was computed, as " + file + " does not have it"))
      << other.output << other.messages;
  const Outcome nowhere =
      run({"plan", "five_bar", "--from", "4.5 8", "--to", "4 6", "--save", "/nowhere/map"});
  EXPECT_EQ(nowhere.code, exit_code::bad_input);
  std::remove(file.c_str());
}

TEST_F(PlanCommand, AsksForAnEndAndRefusesTwo) {
  const Outcome none = run({"plan", "five_bar", "--to", "4 6"});
  EXPECT_EQ(none.code, exit_code::bad_usage);
  EXPECT_TRUE(test::has(none.messages, "--from is required; give a pose"));
  const Outcome two = run({"plan", "five_bar", "--from-aspect", "1", "--from", "4 6", "--to", "4 6"});
  EXPECT_EQ(two.code, exit_code::bad_input);
}

TEST_F(PlanCommand, NamesTheNearestPoseOfTheSlice) {
  const Outcome outcome =
      run({"plan", "delta", "--slice", "z=-0.6", "--from", "0 0 -0.7", "--to", "0.1 0 -0.6"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(outcome.messages, "--from lies 0.1 m from the slice"));
  EXPECT_TRUE(test::has(outcome.messages, "The nearest in the task frame is \"0 0 -0.6\"."));
}

TEST_F(PlanCommand, BeginsOnTheSliceNextToAPoseOfATable) {
  const Outcome outcome = run({"plan", "three_rpr", "--slice", "strut_1_joint=15", "--no-constraint", "all",
                               "--from", "-14.916 1.58508 0.24531", "--around-cusp", "3"});
  EXPECT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  EXPECT_TRUE(test::has(outcome.output, "the start is moved onto the slice, by at most 1.55131e-05 m: "));
  EXPECT_TRUE(test::has(outcome.output, "from \"-14.91601543 1.585081639 0.24531\" to "));
}

/// What stands in quotes behind these words; empty where they are not there.
std::string quoted_behind(const std::string& words, const std::string& text) {
  const std::size_t at = text.find(words + " \"");
  if (at == std::string::npos) return "";
  const std::size_t begin = at + words.size() + 2;
  return text.substr(begin, text.find('"', begin) - begin);
}

TEST_F(PlanCommand, NamesAStartInTheComponentOfACusp) {
  const std::vector<const char*> question{"plan",          "three_rrr", "--slice", "crank_1_joint=0.3",
                                          "--around-cusp", "6"};
  std::vector<const char*> again = question, other = question;
  other.insert(other.end(), {"--from-aspect", "2"});
  const Outcome none = run(other);
  const std::string& text = none.output;
  EXPECT_EQ(none.code, exit_code::not_proved);
  EXPECT_TRUE(test::has(text, "found in component 2, which holds the start."));
  EXPECT_TRUE(test::has(text, "Cusp 6 belongs to component 3;"));
  const std::string pose = quoted_behind("--from", text), values = quoted_behind("values are", text);
  again.insert(again.end(), {"--from", pose.c_str()});
  EXPECT_EQ(run_json(again).at("answer"), "yes") << text;
  again.insert(again.end(), {"--from-joints", values.c_str()});
  EXPECT_EQ(run_json(again).at("answer"), "yes") << text;
}

TEST_F(PlanCommand, ReportsWhereControlIsLost) {
  const json path =
      run_json({"plan", "five_bar", "--from-aspect", "1", "--to-aspect", "2", "--policy", "any"});
  EXPECT_EQ(path.at("answer"), "yes");
  int lost = 0;
  for (const json& crossing : path.at("crossings")) {
    lost += crossing.at("control_lost").get<bool>();
    EXPECT_EQ(crossing.at("leg").is_null(), crossing.at("crossing") == "parallel");
  }
  EXPECT_EQ(lost, 1);
}

TEST_F(PlanCommand, SaysWhatNoiseAPathAroundACuspIsFollowedWith) {
  const std::vector<const char*> hold{
      "plan", "three_rpr", "--slice", "strut_1_joint=14.98", "--from", "-8.72659533 12.17566975 -0.98697424"};
  std::vector<const char*> around = hold, straight = hold;
  around.insert(around.end(), {"--around-cusp", "2"});
  straight.insert(straight.end(), {"--to", "-8.72659533 12.17566975 -0.98697424"});
  const json path = run_json(around);
  EXPECT_EQ(path.at("answer"), "yes");
  EXPECT_NE(path.at("turns_around_cusps").at(1), 0);
  EXPECT_GT(path.at("encoder_noise"), 3e-5);
  EXPECT_LT(path.at("encoder_noise"), 1e-3);
  EXPECT_TRUE(run_json(straight).at("encoder_noise").is_null());
}

TEST_F(PlanCommand, TakesAPoseAsSeveralWords) {
  const json quoted =
      run_json({"plan", "five_bar", "--from", "4.5 8", "--to", "4 6", "--from-mode", "(+,+)"});
  const json words =
      run_json({"plan", "five_bar", "--from", "4.5", "8", "--to", "4", "6", "--from-mode", "+", "+"});
  EXPECT_EQ(words, quoted);
}

}  // namespace
}  // namespace parallel_aspects::tools
