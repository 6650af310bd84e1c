// SPDX-License-Identifier: BSD-3-Clause
#include "tools/paths/trajectory_file.h"
#include "tools/paths/trajectory_text.h"

#include <gtest/gtest.h>

#include "support/command_run.h"
#include "support/robots/robots.h"
#include "support/texts.h"
#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using test::run_json;

std::string file_named(const std::string& name) { return testing::TempDir() + "path_timing_" + name; }

void write(const std::string& file, const std::string& text) { std::ofstream(file) << text; }

std::vector<JointWaypoint> random_waypoints(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-10.0, 10.0);
  std::vector<JointWaypoint> waypoints;
  for (int i = 0; i < 50; ++i) {
    const double nanoseconds = std::floor(1e9 / 7.0 * i) + static_cast<double>(random() % 1000);
    JointVector q(2), velocity(2);
    q << any(random), any(random) * 1e-9;
    velocity << any(random), 0.0;
    waypoints.push_back({nanoseconds / 1e9, q, velocity, {}});
  }
  return waypoints;
}

// To the last bit, in both forms.
TEST(TrajectoryText, IsReadBack) {
  const auto robot = test::five_bar();
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto waypoints = random_waypoints(seed);
    const std::string csv = file_named("any.csv"), yaml = file_named("any.yaml");
    write(csv, trajectory_csv(*robot, waypoints));
    write(yaml, trajectory_yaml(*robot, waypoints));
    for (const std::string& file : {csv, yaml}) {
      const auto back = read_joint_waypoints(*robot, file);
      ASSERT_EQ(back.size(), waypoints.size()) << file;
      for (std::size_t i = 0; i < back.size(); ++i) {
        EXPECT_NEAR(back[i].time, waypoints[i].time, 1e-15 * 50.0) << file << ", seed " << seed;
        EXPECT_EQ(back[i].q, waypoints[i].q) << file << ", seed " << seed;
        EXPECT_EQ(back[i].velocity, waypoints[i].velocity) << file << ", seed " << seed;
        EXPECT_EQ(back[i].acceleration.size(), 0);
      }
    }
  }
}

class PlannedTrajectory : public test::CommandTest {};

// Through a serial gate, to be read back, and to be safe where such gates may be passed.
TEST_F(PlannedTrajectory, IsSafeWhereItIsCheckedAgain) {
  for (const char* name : {"gate.csv", "gate.yaml"}) {
    const std::string file = file_named(name);
    const json plan =
        run_json({"plan", "five_bar", "--from", "4.5 8", "--from-mode", "(+,+)", "--to", "4.5 -8",
                  "--to-mode", "(-,+)", "--policy", "serial", "--trajectory", file.c_str()});
    EXPECT_EQ(plan.at("answer"), "yes");
    const double seconds = plan.at("seconds");
    EXPECT_GT(seconds, 0.5);
    std::vector<const char*> check{"check",        "five_bar", "--trajectory", file.c_str(),
                                   "--start-pose", "4.5 8",    "--json"};
    const Outcome refused = run(check);
    EXPECT_EQ(refused.code, exit_code::proved_no) << refused.messages;
    check.insert(check.end() - 1, {"--policy", "serial"});
    const Outcome outcome = run(check);
    EXPECT_EQ(outcome.code, exit_code::ok) << outcome.messages << outcome.output;
    const json checked = json::parse(outcome.output);
    EXPECT_EQ(checked.at("answer"), "yes");
    ASSERT_EQ(checked.at("crossings").size(), plan.at("crossings").size());
    EXPECT_EQ(checked.at("crossings")[0].at("leg"), plan.at("crossings")[0].at("leg"));
    EXPECT_NEAR(checked.at("free_until"), seconds, 1e-9);
  }
}

TEST_F(PlannedTrajectory, IsTimedByTheLimitsThatAreAskedFor) {
  const std::string file = file_named("slow.csv");
  std::vector<const char*> question{"plan", "five_bar",     "--from",     "4.5 8",          "--to",
                                    "4 6",  "--trajectory", file.c_str(), "--acceleration", "1 1"};
  const double slow = run_json(question).at("seconds");
  question.back() = "100 100";
  const double fast = run_json(question).at("seconds");
  EXPECT_LT(2.0 * fast, slow);
  question[6] = "--acceleration";
  question[7] = "100 100";
  question.resize(8);
  EXPECT_EQ(run_json(question).at("seconds"), fast);
  question.resize(6);
  const double configured = run_json(question).at("seconds");
  EXPECT_LT(configured, slow);
  EXPECT_GT(configured, fast);
}

struct Bad {
  std::vector<const char*> options;
  const char* message;
};

TEST_F(PlannedTrajectory, SaysWhatIsWrongBeforeAnythingStarts) {
  const std::string good = file_named("bad.csv"), none = testing::TempDir() + "no_such_folder/x.csv";
  const std::vector<Bad> all{
      {{"--acceleration", "1"}, "--acceleration"},
      {{"--acceleration", "1 1 1 1 1 1 1 1 1 1 1 1 1 1"}, "has 14 numbers, but needs 2"},
      {{"--trajectory", "x.bag"}, "ends in .csv or .yaml"},
      {{"--trajectory", none.c_str()}, "no_such_folder"},
      {{"--trajectory", good.c_str(), "--acceleration", "1"}, "--acceleration"},
      {{"--trajectory", good.c_str(), "--acceleration", "1 0"}, "positive numbers"},
      {{"--trajectory", good.c_str(), "--acceleration", "1 inf"}, "--acceleration"}};
  for (const Bad& bad : all) {
    std::vector<const char*> question{"plan", "five_bar", "--from", "4.5 8", "--to", "4 6"};
    question.insert(question.end(), bad.options.begin(), bad.options.end());
    const Outcome outcome = run(question);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << bad.message;
    EXPECT_TRUE(test::has(outcome.messages, bad.message));
    EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
  }
}

std::string text_of(const std::string& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string without(std::string text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  EXPECT_NE(from, std::string::npos);
  const std::size_t to = text.find(end, from + begin.size());
  return text.erase(from, to - from + end.size());
}

TEST_F(PlannedTrajectory, NeedsLimitsOfTheRobot) {
  const std::string source = PARALLEL_ASPECTS_SOURCE_DIR, urdf = file_named("robot.urdf"),
                    config = file_named("robot.yaml"), file = file_named("robot.csv");
  const std::string yaml = text_of(source + "/config/robots/five_bar.yaml"),
                    model = text_of(source + "/urdf/five_bar.urdf");
  std::vector<const char*> question{"plan",  "--urdf", urdf.c_str(), "--config",     config.c_str(), "--from",
                                    "4.5 8", "--to",   "4 6",        "--trajectory", file.c_str()};
  write(urdf, model);
  write(config, without(yaml, "motion:", "]\n"));
  EXPECT_TRUE(test::has(run(question).messages, "write motion.acceleration into " + config));
  write(config, yaml);
  write(urdf, without(model, " velocity=\"2", "\""));
  EXPECT_TRUE(test::has(run(question).messages, "has no velocity limit"));
  question.resize(question.size() - 2);  // without a trajectory it is planned all the same
  EXPECT_TRUE(run_json(question).at("seconds").is_null());
}

}  // namespace
}  // namespace parallel_aspects::tools
