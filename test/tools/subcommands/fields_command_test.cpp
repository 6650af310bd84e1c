// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/command_run.h"
#include "support/texts.h"
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::run;
using test::run_json;

using FieldsCommand = test::CommandTest;

/// Names of the fields of a subcommand, of whichever of its tables.
std::set<std::string> documented(const char* subcommand) {
  const json printed = run_json({"fields", subcommand});
  std::set<std::string> names;
  for (const json& table : printed.at("tables"))
    for (const json& field : table.at("fields")) names.insert(field.at("name").get<std::string>());
  return names;
}

/// What every answer may have besides, and what `ik` adds of each joint: docs/reference/command.md.
const std::set<std::string> in_the_page{
    "mechanism",       "constraints",          "joints_not_limited",  "actuated_joints",
    "units",           "without_limits",       "empty_working_modes", "undecided_working_modes",
    "joint_positions", "joint_outside_limits", "trajectory_file",     "margins",
    "tolerance"};

void expect_documented(const json& object, const std::set<std::string>& names) {
  for (const auto& [name, value] : object.items())
    EXPECT_TRUE(names.count(name) == 1 || in_the_page.count(name) == 1) << name;
}

TEST_F(FieldsCommand, HasEveryFieldThatIsPrinted) {
  struct Asked {
    std::vector<const char*> arguments;
    const char* entries;  ///< a list of the answer whose entries have fields, too
  };
  const std::vector<Asked> all{{{"map", "five_bar"}, "aspects"},
                               {{"map", "five_bar", "--persistence"}, "basins"},
                               {{"map", "stewart", "--samples", "20"}, "sides"},
                               {{"locate", "five_bar", "--pose", "4.5 8"}, "configurations"},
                               {{"graph", "five_bar"}, "sets"},
                               {{"connect", "five_bar", "--from", "4.5 8", "--to", "5 7"}, "answers"},
                               {{"plan", "five_bar", "--from", "4.5 8", "--to", "5 7"}, ""},
                               {{"choose", "five_bar", "--region", "x=4:5 y=7:8"}, "modes"},
                               {{"workspace", "five_bar", "--shape", "disc"}, "workspaces"},
                               {{"uniqueness", "bipod"}, "components"},
                               {{"uniqueness", "three_rpr", "--slice", "strut_1_joint=14.98"}, "cusps"},
                               {{"uniqueness", "stewart", "--samples", "20"}, "components"},
                               {{"describe", "five_bar"}, ""},
                               {{"distance", "five_bar", "--pose", "4.5 8"}, "answers"},
                               {{"ik", "five_bar", "--pose", "4.5 8"}, "solutions"},
                               {{"fk", "five_bar", "--joints", "0.4835 3.1385"}, "assembly_modes"},
                               {{"jacobian", "five_bar", "--pose", "4.5 8"}, "configurations"}};
  for (const Asked& each : all) {
    const char* const subcommand = each.arguments.front();
    SCOPED_TRACE(subcommand);
    const std::set<std::string> names = documented(subcommand);
    const json answer = run_json(each.arguments);
    expect_documented(answer, names);
    if (*each.entries == '\0') continue;
    ASSERT_FALSE(answer.at(each.entries).empty());
    for (const json& entry : answer.at(each.entries)) expect_documented(entry, names);
  }
}

TEST_F(FieldsCommand, PrintsTablesAsMarkdown) {
  const std::string all = run({"fields"}).output;
  EXPECT_TRUE(test::begins(all, "## `map`\n\n| field | meaning |\n|---|---|\n| `task_space` | "));
  EXPECT_TRUE(test::has(all, "\n\nEach of `solutions`:\n\n| field | meaning |"));
  EXPECT_TRUE(test::has(all, " [m]"));
  const std::string one = run({"fields", "ik"}).output;
  EXPECT_TRUE(test::begins(one, "## `ik`\n"));
  EXPECT_TRUE(test::has(all, one));
}

TEST_F(FieldsCommand, NamesTheSubcommandsThatHaveFields) {
  const test::Outcome outcome = run({"fields", "robots"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_TRUE(test::begins(outcome.messages, "'robots' has no list of fields; name one of map, locate, "));
}

}  // namespace
}  // namespace parallel_aspects::tools
