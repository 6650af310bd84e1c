// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;

class UniquenessCommand : public test::CommandTest {};

TEST_F(UniquenessCommand, ListsCurvesOfCusps) {
  const Outcome outcome = run({"uniqueness", "three_rpr", "--cusps-over", "strut_1_joint=26:26.9", "--json"});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  const json found = json::parse(outcome.output);
  EXPECT_EQ(found["held_joint"], "strut_1_joint");
  EXPECT_EQ(found["lower"], 26.0);
  EXPECT_EQ(found["upper"], 26.9);
  EXPECT_EQ(found["cusp_curves_complete"], true);
  EXPECT_TRUE(found["undecided"].empty());
  std::vector<int> counts;
  for (const json& each : found["cusp_counts"]) counts.push_back(each["cusps"]);
  EXPECT_EQ(counts, (std::vector<int>{2, 4, 3}));
  std::size_t turns = 0;
  for (const json& curve : found["cusp_curves"])
    for (const json& event : curve["events"]) turns += event["kind"] == "turn" ? 1 : 0;
  EXPECT_EQ(turns, 1U);
  EXPECT_EQ(found["cusp_curves"][0]["points"][0]["actuated"].size(), 3U);
}

// Where a crank is as long as its rod, boxes that touch a serial singularity stay undecided.
TEST_F(UniquenessCommand, SaysWhatToAskWhereARangeIsNotDecided) {
  const Outcome outcome = run({"uniqueness", "three_rrr", "--cusps-over", "crank_1_joint=0.3:0.3000001"});
  EXPECT_TRUE(test::has(outcome.output, "\nnot decided: 0.3"));
  EXPECT_TRUE(
      test::has(outcome.output, "A shorter range is divided further; --slice crank_1_joint=0.3 lists"));
}

TEST_F(UniquenessCommand, RefusesRangesThatAreNone) {
  for (const char* range : {"strut_4_joint", "strut_1_joint=20:12", "strut_1_joint=5:12"}) {
    const Outcome outcome = run({"uniqueness", "three_rpr", "--cusps-over", range});
    EXPECT_EQ(outcome.code, exit_code::bad_input) << range;
    EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
    EXPECT_EQ(outcome.output, "");
  }
  const Outcome unlimited =
      run({"uniqueness", "three_rpr", "--no-constraint", "all", "--cusps-over", "strut_1_joint"});
  EXPECT_EQ(unlimited.code, exit_code::bad_input);
  const Outcome slice =
      run({"uniqueness", "three_rpr", "--cusps-over", "strut_1_joint", "--slice", "strut_1_joint=12"});
  EXPECT_TRUE(test::has(slice.messages, "leave --slice"));
}

/// The lines of a table that begins with this title, without its titles.
std::vector<std::string> rows_of(const std::string& output, const std::string& title) {
  std::istringstream lines(output);
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(lines, line) && line.rfind(title, 0) != 0) continue;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.empty()) rows.push_back(line);
  return rows;
}

/// Numbers, from 1, of these indices.
std::string numbers_of(const json& indices) {
  std::string text;
  for (const std::size_t index : indices) text += (text.empty() ? "" : ", ") + std::to_string(index + 1);
  return text;
}

TEST_F(UniquenessCommand, ListsOfASliceInTextWhatJsonHas) {
  const std::vector<const char*> question{"uniqueness",          "three_rpr",       "--slice",
                                          "strut_1_joint=14.98", "--no-constraint", "all"};
  std::vector<const char*> with_json = question;
  with_json.emplace_back("--json");
  const Outcome outcome = run(question);
  const json found = json::parse(run(with_json).output);
  const auto sets = rows_of(outcome.output, "connected sets"), regions = rows_of(outcome.output, "basic"),
             domains = rows_of(outcome.output, "uniqueness domains");
  ASSERT_EQ(regions.size(), found["basic_regions"].size());
  ASSERT_EQ(domains.size(), found["uniqueness_domains"].size());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const json& region = found["basic_regions"][i];
    int number = 0, component = 0;
    std::size_t over = 0;
    std::istringstream(regions[i]) >> number >> component >> over;
    EXPECT_EQ(component, region["component"]) << regions[i];
    EXPECT_EQ(over, region["basic_component"].get<std::size_t>() + 1) << regions[i];
    EXPECT_LT(over, sets.size()) << regions[i];
  }
  for (std::size_t i = 0; i < domains.size(); ++i) {
    const std::string indices = numbers_of(found["uniqueness_domains"][i]["basic_regions"]);
    EXPECT_TRUE(test::has(domains[i], " " + indices + " "));
  }
  const std::size_t left_out = found["basic_components"].size() - (sets.size() - 1);
  EXPECT_TRUE(test::begins(sets.back(), std::to_string(left_out) + " smaller sets left out"));
}

TEST_F(UniquenessCommand, ReportsTheComponentOfEachCusp) {
  const std::vector<const char*> question{"uniqueness",          "three_rpr",       "--slice",
                                          "strut_1_joint=14.98", "--no-constraint", "all"};
  std::vector<const char*> with_json = question;
  with_json.emplace_back("--json");
  std::vector<int> components, shown;
  const json found = json::parse(run(with_json).output);
  for (const json& cusp : found["cusps"]) components.push_back(cusp["component"]);
  EXPECT_EQ(components, (std::vector<int>{2, 2, 1, 2, 2, 1}));
  for (const std::string& row : rows_of(run(question).output, "6 cusps")) {
    std::array<double, 3> actuated{};
    int component = 0;
    std::istringstream(row) >> actuated[0] >> actuated[1] >> actuated[2] >> component;
    shown.push_back(component);
  }
  EXPECT_EQ(shown, components);
}

TEST_F(UniquenessCommand, ListsCuspsInSO3) {
  const Outcome outcome = run({"uniqueness", "spherical_3rrr", "--slice", "crank_1_joint=0.3", "--json"});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  const json found = json::parse(outcome.output);
  EXPECT_EQ(found["task_space"], "SO3");
  EXPECT_EQ(found["slice"]["held"]["crank_1_joint"], 0.3);
  EXPECT_EQ(found["cusps"].size(), 6U);
  EXPECT_EQ(found["cusps_complete"], true);
  EXPECT_EQ(found["undecided_curves"], false);
  for (const json& cusp : found["cusps"]) {
    EXPECT_EQ(cusp["actuated"][0], 0.3);
    EXPECT_EQ(cusp["component"], 0);
  }
  const Outcome eye = run({"uniqueness", "agile_eye", "--slice", "crank_1_joint=0.3"});
  EXPECT_TRUE(test::has(eye.output, "there may be more"));
  EXPECT_TRUE(test::has(eye.output, "Not decided are curves"));
}

TEST_F(UniquenessCommand, LooksAtARoadmapOfAHexapod) {
  const Outcome outcome =
      run({"uniqueness", "stewart", "--samples", "200", "--seed", "3", "--poses", "40", "--json"});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  const json found = json::parse(outcome.output);
  EXPECT_EQ(found["task_space"], "SE3");
  EXPECT_EQ(found["samples"], 200);
  EXPECT_EQ(found["seed"], 3);
  EXPECT_EQ(found["poses"], 40);
  std::size_t changes = 0, poses = 0;
  for (const json& component : found["components"]) {
    for (const json& each : component["solutions_in_aspect"]) poses += each["poses"].get<std::size_t>();
    const json& change = component["assembly_change"];
    if (change.is_null()) continue;
    ++changes;
    EXPECT_EQ(change["actuated"].size(), 6U);
    EXPECT_EQ(change["path"].front(), change["from"]["pose"]);
    EXPECT_EQ(change["path"].back(), change["to"]["pose"]);
    EXPECT_EQ(change["proved"], true);
  }
  EXPECT_EQ(poses, 40U);
  EXPECT_GT(changes, 0U);
  const Outcome text = run({"uniqueness", "stewart", "--samples", "200", "--seed", "3", "--poses", "40"});
  EXPECT_TRUE(test::has(text.output, "no, proved"));
  EXPECT_TRUE(test::has(text.output, "lower bounds"));
}

TEST_F(UniquenessCommand, RefusesWhatIsOfOtherTaskSpaces) {
  for (const std::vector<const char*>& arguments :
       {std::vector<const char*>{"uniqueness", "stewart", "--slice", "strut_1_joint=1"},
        {"uniqueness", "stewart", "--poses", "some"},
        {"uniqueness", "stewart", "--tolerance", "0.001"},
        {"uniqueness", "spherical_3rrr", "--slice", "roll=0.1"},
        {"uniqueness", "spherical_3rrr", "--slice", "crank_1_joint"},
        {"uniqueness", "spherical_3rrr", "--slice", "crank_1_joint=0.1,crank_2_joint=0"},
        {"uniqueness", "spherical_3rrr", "--slice", "crank_1_joint=0.1", "--poses", "10"},
        {"uniqueness", "spherical_3rrr", "--slice", "crank_1_joint=0.1", "--picture", "picture.svg"},
        {"uniqueness", "five_bar", "--poses", "10"},
        {"uniqueness", "three_prr", "--slice", "slider_1_joint=0.3", "--mode", "(-,-,-)"},
        {"uniqueness", "three_prr", "--slice", "slider_1_joint=0.3", "--mode", "(-,-)", "--picture", "a.svg"},
        {"uniqueness", "three_rpr", "--slice", "strut_1_joint=14.98", "--mode", "(+,+,-)", "--picture",
         "a.svg"},
        {"uniqueness", "three_rpr", "--cusps-over", "strut_1_joint=26:26.9", "--mode", "(+,+,+)"},
        {"uniqueness", "three_rpr", "--samples", "10", "--slice", "strut_1_joint=14.98"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << arguments[1] << ' ' << arguments[2];
    EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
    EXPECT_EQ(outcome.output, "");
  }
}

}  // namespace
}  // namespace parallel_aspects::tools
