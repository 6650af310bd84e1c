// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <atomic>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using test::run_json;

class RoadmapCommand : public test::CommandTest {
 protected:
  static std::map<std::string, std::string> answers(const json& connection) {
    std::map<std::string, std::string> result;
    for (const json& answer : connection.at("answers"))
      result[answer.at("working_mode").dump()] = answer.at("same_aspect").get<std::string>();
    return result;
  }
};

// With six degrees of freedom `map` gives a roadmap.
TEST_F(RoadmapCommand, MapOfAStewartPlatformIsARoadmap) {
  const json map = run_json({"map", "stewart", "--samples", "200", "--seed", "7", "--threads", "1"});
  EXPECT_EQ(map.at("mechanism"), "stewart");
  EXPECT_EQ(map.at("task_space"), "SE3");
  EXPECT_EQ(map.at("samples"), 200);
  EXPECT_EQ(map.at("seed"), 7);
  EXPECT_EQ(map.at("proved_count"), 2);
  EXPECT_GE(map.at("seconds").get<double>(), 0.0);
  ASSERT_EQ(map.at("sides").size(), 2U);
  std::size_t samples = 0, components = 0;
  for (const json& side : map.at("sides")) {
    EXPECT_EQ(side.at("working_mode"), json::parse("[1, 1, 1, 1, 1, 1]"));
    std::size_t sum = 0;
    for (const json& size : side.at("component_sizes")) sum += size.get<std::size_t>();
    EXPECT_EQ(side.at("samples"), sum);
    EXPECT_NEAR(side.at("largest_share").get<double>() * static_cast<double>(sum),
                side.at("component_sizes")[0].get<double>(), 1e-9);
    ASSERT_EQ(side.at("largest_indices").size(), side.at("component_sizes").size());
    for (const json& index : side.at("largest_indices")) EXPECT_TRUE(index > 0.0 && index <= 1.0) << index;
    samples += sum;
    components += side.at("component_sizes").size();
  }
  EXPECT_EQ(map.at("sides")[0].at("determinant_sign"), 1);
  EXPECT_EQ(map.at("sides")[1].at("determinant_sign"), -1);
  EXPECT_LE(samples, 200U);
  EXPECT_EQ(map.at("components_at_most"), components);
  EXPECT_EQ(map.at("constraints"), json::parse(R"(["actuated_limits"])"));
}

TEST_F(RoadmapCommand, TextSaysWhatIsProvedAndWhatIsNot) {
  const std::string text = run({"map", "stewart", "--samples", "100"}).output;
  EXPECT_TRUE(test::begins(text, "stewart: at least 2 aspects in 1 working mode, proved"));
  EXPECT_TRUE(test::has(text, "at most"));
  EXPECT_TRUE(test::has(text, "no sample meets"));
}

TEST_F(RoadmapCommand, OptionsOfTheOtherKindOfMapAreRefused) {
  for (const auto& arguments :
       std::vector<std::vector<const char*>>{{"map", "stewart", "--resolution", "0.1"},
                                             {"map", "stewart", "--samples", "0"},
                                             {"map", "stewart", "--samples", "many"},
                                             {"map", "stewart", "--seed", "-1"},
                                             {"map", "five_bar", "--samples", "100"},
                                             {"map", "five_bar", "--seed", "3"},
                                             {"connect", "stewart", "--from", "0 0 1.3 0 0 0 1", "--to",
                                              "0 0 1.2 0 0 0 1", "--resolution", "1"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << arguments[2];
    EXPECT_EQ(outcome.output, "");
    EXPECT_NE(outcome.messages, "");
  }
}

TEST_F(RoadmapCommand, ConnectsPosesOfAStewartPlatform) {
  const json near =
      run_json({"connect", "stewart", "--from", "0 0 1.3 0 0 0 1", "--to", "0.2 0.3 1.2 0.1 0 0 1"});
  ASSERT_EQ(near.at("answers").size(), 1U);
  EXPECT_EQ(near.at("answers")[0].at("same_aspect"), "yes");
  EXPECT_EQ(near.at("answers")[0].at("path").size(), 2U);
  EXPECT_EQ(near.at("answers")[0].at("path")[0], near.at("from"));
  EXPECT_EQ(near.at("answers")[0].at("path")[1], near.at("to"));
  const json below =
      run_json({"connect", "stewart", "--from", "0 0 1.3 0 0 0 1", "--to", "0 0 -1.3 0 0 0 1"});
  EXPECT_EQ(below.at("answers")[0].at("same_aspect"), "no");
  EXPECT_EQ(below.at("answers")[0].at("path"), json::array());
  EXPECT_EQ(near.at("constraints"), json::parse(R"(["actuated_limits"])"));
  EXPECT_TRUE(near.at("answers")[0].at("failing_constraint").is_null());
  const json high = run_json({"connect", "stewart", "--from", "0 0 1.3 0 0 0 1", "--to", "0 0 2 0 0 0 1"});
  EXPECT_EQ(high.at("answers")[0].at("same_aspect"), "no");
  EXPECT_EQ(high.at("answers")[0].at("failing_constraint"), "actuated_limits");
  const json away = run_json({"connect", "stewart", "--from", "0 0 1.3 0 0 0 1", "--to", "0 0 9 0 0 0 1"});
  EXPECT_EQ(away.at("answers")[0].at("same_aspect"), "no");
}

// The 47.85 and the 3.70 m^2 aspect of the paper's five-bar share their signs: only the map tells them apart.
TEST_F(RoadmapCommand, DistinguishesTheAspectsOfTheFiveBar) {
  const auto found = answers(
      run_json({"connect", "five_bar", "--from", "4.5 3.55", "--to", "4.5 -11.71", "--samples", "200"}));
  const std::map<std::string, std::string> expected{
      {"[1,1]", "no"}, {"[-1,1]", "no"}, {"[1,-1]", "yes"}, {"[-1,-1]", "no"}};
  EXPECT_EQ(found, expected);
}

TEST_F(RoadmapCommand, BottlenecksAreReportedWhereThereIsAMap) {
  const auto bottleneck = [&](const char* to, const char* index) {
    return run_json(
               {"connect", "five_bar", "--from", "4.5 8", "--to", to, "--mode", "(+,-)", "--index", index})
        .at("answers")[0]
        .at("bottleneck");
  };
  const json around = bottleneck("4.5 -8", "parallel");
  EXPECT_EQ(around["index"], "parallel");
  EXPECT_GT(around["lower"], 0.4);
  EXPECT_LT(around["upper"], 0.5);
  EXPECT_GT(bottleneck("4.5 -8", "det_a")["lower"], 1.0);
  EXPECT_EQ(bottleneck("4.69 11.63", "parallel"), nullptr);  // another aspect
  EXPECT_EQ(bottleneck("40 0", "parallel"), nullptr);
}

// Two solutions of one value of the actuated joints, and one of another component.
TEST_F(RoadmapCommand, ConnectsWithinSlices) {
  const char *from = "14.67394366 -3.01260312 2.13290437", *to = "-5.49566082 -13.93549828 -0.04733137",
             *other = "-8.72659533 12.17566975 -0.98697424";
  const auto ask = [&](const char* goal, const char* slice) {
    return run_json(
        {"connect", "three_rpr", "--from", from, "--to", goal, "--slice", slice, "--index", "det_a"});
  };
  const json same = ask(to, "strut_1_joint=14.98");
  EXPECT_EQ(same.at("slice").at("held").at("strut_1_joint"), 14.98);
  EXPECT_EQ(same.at("slice").at("free"), (std::vector<std::string>{"direction", "phi"}));
  EXPECT_GT(same.at("moved_onto_slice"), 0.0);
  EXPECT_LT(same.at("moved_onto_slice"), 1e-6);
  EXPECT_EQ(same.at("answers")[0].at("same_aspect"), "yes");
  EXPECT_GT(same.at("answers")[0].at("bottleneck").at("lower"), 3000.0);
  EXPECT_EQ(ask(other, "strut_1_joint=14.98").at("answers")[0].at("same_aspect"), "no");
  const Outcome beside =
      run({"connect", "three_rpr", "--from", from, "--to", to, "--slice", "strut_1_joint=15"});
  EXPECT_EQ(beside.code, exit_code::bad_input);
  EXPECT_TRUE(
      test::has(beside.messages,
                "--from lies 0.02 m from the slice strut_1_joint = 15 m; give a pose within 0.0004209 m of "
                "it. The nearest in the task frame is \"14.69353504 -3.016625286 2.13290437\"."));
  EXPECT_EQ(answers(run_json({"connect", "delta", "--from", "0 0 -0.6", "--to", "0.1 0 -0.6", "--slice",
                              "z=-0.6", "--mode", "+++"})),
            (std::map<std::string, std::string>{{"[1,1,1]", "yes"}}));
}

TEST_F(RoadmapCommand, OneModeCanBeAskedFor) {
  for (const char* mode : {"(+,-)", "+-", "+ -"}) {
    const json connection =
        run_json({"connect", "five_bar", "--from", "4.5 8", "--to", "4.5 7", "--mode", mode});
    ASSERT_EQ(connection.at("answers").size(), 1U);
    EXPECT_EQ(connection.at("answers")[0].at("working_mode"), json::parse("[1, -1]"));
  }
  for (const char* mode : {"(+,-,+)", "left", "+", "1 -1"}) {
    const Outcome outcome = run({"connect", "five_bar", "--from", "4.5 8", "--to", "4.5 7", "--mode", mode});
    EXPECT_EQ(outcome.code, exit_code::bad_input) << mode;
    EXPECT_TRUE(test::has(outcome.messages, "--mode"));
  }
}

TEST_F(RoadmapCommand, EveryTaskSpaceIsAnswered) {
  const std::vector<std::vector<const char*>> questions{
      {"bipod", "2.5 3.5", "2 4"},
      {"three_rpr", "-8.7 12.2 -1", "-8.5 12 -1.1"},
      {"delta", "0 0 -0.7", "0.1 0 -0.7"},
      {"agile_eye", "0 0 0 1", "0.1 0 0 1"},
      {"hexa", "0 0 -0.6 0 0 0 1", "0.05 0 -0.6 0 0 0.1 1"}};
  for (const auto& question : questions) {
    const auto found = answers(
        run_json({"connect", question[0], "--from", question[1], "--to", question[2], "--samples", "50"}));
    EXPECT_FALSE(found.empty());
    std::size_t same = 0;
    for (const auto& answer : found) same += answer.second == "yes";
    EXPECT_GT(same, 0U) << question[0];
  }
}

TEST_F(RoadmapCommand, InterruptedCommandsSayNothing) {
  const std::atomic<bool> interrupted{true};
  const Outcome outcome = run({"map", "hexa"}, &interrupted);
  EXPECT_EQ(outcome.code, exit_code::interrupted);
  EXPECT_EQ(outcome.output, "");
}

// With a joint held, few digits would put it beside the slice.
TEST_F(RoadmapCommand, TakesAPoseThatTheMapOfASlicePrinted) {
  const std::string printed = run({"map", "three_rpr", "--slice", "strut_1_joint=14.98"}).output;
  EXPECT_TRUE(test::has(printed, "bounds of direction and phi"));
  std::smatch found;
  ASSERT_TRUE(std::regex_search(printed, found, std::regex("\\((-?[0-9.e-]+, -?[0-9.e-]+, -?[0-9.e-]+)\\)")))
      << printed;
  const std::string pose = found[1];
  const json answer = run_json({"connect", "three_rpr", "--slice", "strut_1_joint=14.98", "--from",
                                pose.c_str(), "--to", pose.c_str()});
  EXPECT_EQ(answer.at("answers")[0].at("same_aspect"), "yes");
}

TEST_F(RoadmapCommand, NamesMarginAndToleranceWhereNoPoseKeepsThem) {
  const std::string messages =
      run({"map", "stewart", "--margin", "parallel=0.99", "--samples", "20"}).messages;
  EXPECT_TRUE(test::has(messages, "smaller margins"));
}

}  // namespace
}  // namespace parallel_aspects::tools
