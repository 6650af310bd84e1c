// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
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

TEST_F(GraphCommand, IsDrawnByGraphviz) {
  const Outcome outcome = run({"graph", "five_bar", "--dot"});
  EXPECT_EQ(outcome.code, exit_code::ok);
  EXPECT_EQ(outcome.output.rfind("graph aspects {", 0), 0U) << outcome.output;
  EXPECT_NE(outcome.output.find("cluster_2"), std::string::npos);
  EXPECT_NE(outcome.output.find("label=\"leg 1\""), std::string::npos);
}

TEST_F(PlanCommand, PassesAGateWhereThatIsAllowed) {
  const std::vector<const char*> question{"plan",  "five_bar", "--from", "4.5 8",     "--from-mode",
                                          "(+,+)", "--to",     "4.5 -8", "--to-mode", "(-,+)"};
  EXPECT_EQ(run(question).code, exit_code::unsafe);
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
      run_json({"plan", "three_rpr", "--hold", "strut_1_joint=14.98", "--from",
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
  EXPECT_NE(refusal({"plan", "five_bar", "--from", "4.5", "--to", "4.5 6"}).find("--from"),
            std::string::npos);
  EXPECT_NE(
      refusal({"plan", "five_bar", "--from", "4.5 8", "--to", "4.5 6", "--policy", "fly"}).find("'fly'"),
      std::string::npos);
  EXPECT_NE(
      refusal({"plan", "five_bar", "--from", "4.5 8", "--to", "4.5 6", "--samples", "9"}).find("--samples"),
      std::string::npos);
  EXPECT_NE(refusal({"plan", "stewart", "--from", "0 0 1.3 0 0 0 1", "--to", "0 0 1.2 0 0 0 1", "--policy",
                     "serial"})
                .find("--policy serial"),
            std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects::tools
