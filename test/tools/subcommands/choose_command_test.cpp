// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;

class ChooseCommand : public test::CommandTest {
 protected:
  void SetUp() override {
    test::CommandTest::SetUp();
    std::string pattern = (std::filesystem::temp_directory_path() / "choose_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Outcome choose(const std::string& path, std::vector<const char*> more = {}) {
    const std::string name = (folder_ / "path.csv").string();
    std::ofstream(name) << path;
    std::vector<const char*> arguments{"choose", "five_bar", "--path", name.c_str()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  void expect_refused(const Outcome& outcome, const std::string& word) {
    EXPECT_EQ(outcome.code, exit_code::bad_input) << outcome.output;
    EXPECT_TRUE(test::has(outcome.messages, word));
    EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
    EXPECT_EQ(outcome.output, "");
  }

  std::filesystem::path folder_;
};

constexpr const char* good_path = "time,x,y\n0,3,6\n1,5,7\n2,6,5\n";
constexpr const char* long_path = "time,x,y\n0,2,-7\n1,8.4,8.8\n";

TEST_F(ChooseCommand, TheBestWorkingModeComesFirst) {
  const Outcome outcome = choose(good_path, {"--json"});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  const json result = json::parse(outcome.output);
  EXPECT_EQ(result.at("answer"), "yes");
  EXPECT_EQ(result.at("prefer"), "clear");
  ASSERT_EQ(result.at("modes").size(), 4U);
  const json& best = result.at("modes")[0];
  EXPECT_EQ(best.at("answer"), "yes");
  EXPECT_GT(best.at("aspect").get<int>(), 0);
  EXPECT_GT(best.at("clearance").at("proved").get<double>(), 0.0);
  EXPECT_LE(best.at("clearance").at("proved").get<double>(),
            best.at("clearance").at("measured").get<double>());
  EXPECT_EQ(best.at("travel").size(), 2U);
  EXPECT_TRUE(best.at("first_violation").is_null());
  const json& worst = result.at("modes")[3];
  EXPECT_EQ(worst.at("answer"), "no");
  EXPECT_EQ(worst.at("first_violation").at("kind"), "parallel_singularity");
  EXPECT_TRUE(worst.at("clearance").is_null());
  const json travel = json::parse(choose(good_path, {"--prefer", "travel", "--json"}).output);
  EXPECT_LE(travel.at("modes")[0].at("total_travel").get<double>(), best.at("total_travel").get<double>());
}

TEST_F(ChooseCommand, ChangesOfPostureAreReportedWithTheirPlace) {
  EXPECT_EQ(choose(long_path).code, exit_code::proved_no);
  const Outcome outcome = choose(long_path, {"--changes", "--json"});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  const json result = json::parse(outcome.output);
  EXPECT_EQ(result.at("answer"), "no");
  const json& changed = result.at("with_changes");
  EXPECT_EQ(changed.at("answer"), "yes");
  EXPECT_EQ(changed.at("pieces").size(), 2U);
  ASSERT_EQ(changed.at("changes").size(), 1U);
  EXPECT_EQ(changed.at("changes")[0].at("leg"), "leg_1");
  EXPECT_EQ(changed.at("changes")[0].at("time"), changed.at("pieces")[0].at("end"));
  EXPECT_TRUE(test::has(choose(long_path, {"--changes"}).output, "leave the path at x 4."));
}

TEST_F(ChooseCommand, APathOutOfReachIsNo) {
  const Outcome outcome = choose("time,x,y\n0,3,60\n1,5,7\n", {"--changes"});
  EXPECT_EQ(outcome.code, exit_code::proved_no);
  EXPECT_TRUE(test::has(outcome.output, "with changes of posture: no"));
}

TEST_F(ChooseCommand, RegionsAreTConnectedOrNot) {
  const json yes = test::run_json({"choose", "five_bar", "--region", "x=3:6 y=5:8"});
  EXPECT_EQ(yes.at("answer"), "yes");
  EXPECT_GT(yes.at("modes")[0].at("least_index").at("lower").get<double>(), 0.0);
  EXPECT_EQ(yes.at("region").at("lower").at("x"), 3.0);
  const Outcome no = run({"choose", "five_bar", "--region", "x=-3:12 y=-10:10", "--json"});
  EXPECT_EQ(no.code, exit_code::proved_no);
  EXPECT_EQ(json::parse(no.output).at("apart").size(), 2U);
  const json line = test::run_json({"choose", "five_bar", "--region", "x=3:6", "--slice", "y=7"});
  EXPECT_EQ(line.at("answer"), "yes");
  const json turning =
      test::run_json({"choose", "three_rrr", "--region", "x=-.05:.05 y=-.05:.05 phi=-.2:.2"});
  EXPECT_EQ(turning.at("answer"), "yes");
}

TEST_F(ChooseCommand, BadQuestionsAreRefusedInOneSentence) {
  EXPECT_EQ(run({"choose", "five_bar"}).code, exit_code::bad_usage);
  expect_refused(choose(good_path, {"--region", "x=0:1 y=0:1"}), "Give one of");
  expect_refused(choose(good_path, {"--prefer", "best"}), "clear, travel or fast");
  expect_refused(choose(good_path, {"--slice", "y=7"}), "--slice is of --region");
  expect_refused(choose("time,x,y\n"), "no waypoint");
  expect_refused(choose("time,x,y\n1,3,6\n0,5,7\n"), "rise");
  expect_refused(run({"choose", "five_bar", "--region", "x=3:6"}), "y");
  expect_refused(run({"choose", "five_bar", "--region", "x=6:3 y=0:1"}), "below the upper");
  expect_refused(run({"choose", "five_bar", "--region", "x=3:6 y=0:1", "--prefer", "fast"}), "--prefer");
  expect_refused(run({"choose", "five_bar", "--region", "x=3:6 y=0:1", "--changes"}), "--changes");
  expect_refused(run({"choose", "three_rrr", "--region", "x=0:1 y=0:1 phi=-3:4"}), "longer than a turn");
  expect_refused(run({"choose", "three_rrr", "--region", "x=0:1 y=0:1"}), "in m and rad");
  expect_refused(run({"choose", "hexa", "--region", "x=0:1 y=0:1 z=0:1"}), "roll=0");
  expect_refused(run({"choose", "agile_eye", "--region", "roll=0:1"}), "Orientations");
}

}  // namespace
}  // namespace parallel_aspects::tools
