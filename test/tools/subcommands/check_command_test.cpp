// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/palette.h"
#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command_run.h"
#include "support/texts.h"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;

class CheckCommand : public test::CommandTest {
 protected:
  void SetUp() override {
    test::CommandTest::SetUp();
    std::string pattern = (std::filesystem::temp_directory_path() / "check_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& text) {
    const std::string name = (folder_ / "path.csv").string();
    std::ofstream(name) << text;
    return name;
  }

  Outcome check_path(const std::string& text, std::vector<const char*> more = {}) {
    const std::string name = file(text);
    std::vector<const char*> arguments{"check", "five_bar", "--path", name.c_str(), "--mode", "(+,-)"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  std::filesystem::path folder_;
};

TEST_F(CheckCommand, SafePathIsProved) {
  const Outcome outcome = check_path("t,x,y\n0,4.5,8\n1,4.6,8\n2,4.6,8.2\n", {"--json"});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages << outcome.output;
  const json result = json::parse(outcome.output);
  EXPECT_EQ(result.at("answer"), "yes");
  EXPECT_EQ(result.at("proved"), true);
  EXPECT_EQ(result.at("free_until"), 2.0);
  EXPECT_TRUE(result.at("first_violation").is_null());
  EXPECT_TRUE(result.at("crossings").empty());
  EXPECT_GT(result.at("least_index").at("parallel").at("value").get<double>(), 0.0);
  EXPECT_GT(result.at("least_index").at("serial").at("value").get<double>(), 0.0);
  ASSERT_EQ(result.at("speeds").size(), 2U);
  EXPECT_GT(result.at("speeds")[0].at("fastest").get<double>(), 0.0);
}

TEST_F(CheckCommand, UnsafePathHasAnExitCodeAndTheTime) {
  const Outcome outcome = check_path("x,time,y\n4.5,0,8\n-30,2,8\n", {"--json"});
  ASSERT_EQ(outcome.code, exit_code::proved_no) << outcome.messages;
  const json result = json::parse(outcome.output);
  EXPECT_EQ(result.at("answer"), "no");
  const json& violation = result.at("first_violation");
  EXPECT_EQ(violation.at("kind"), "serial_singularity");
  EXPECT_TRUE(violation.at("leg").is_string());
  EXPECT_LE(violation.at("after").get<double>(), violation.at("before").get<double>());
  EXPECT_EQ(result.at("crossings").size(), 1U);
  const Outcome text = check_path("t,x,y\n0,4.5,8\n2,-30,8\n");
  EXPECT_EQ(text.code, exit_code::proved_no);
  EXPECT_TRUE(test::has(text.output, "safe: no"));
}

TEST_F(CheckCommand, AStartBeyondALimitIsNoBracket) {
  const std::string path =
      file("time,x,y\n7,1,1\n8,1,2\n");  // strut 1 is 1.41 m long, and its limits 2 and 6
  const Outcome outcome = run({"check", "bipod", "--path", path.c_str(), "--mode", "(+,+)", "--json"});
  ASSERT_EQ(outcome.code, exit_code::proved_no) << outcome.messages << outcome.output;
  const json violation = json::parse(outcome.output).at("first_violation");
  EXPECT_EQ(violation.at("after"), 7.0);
  EXPECT_EQ(violation.at("before"), 7.0);
}

TEST_F(CheckCommand, SamplesAreWrittenAsATableAndAPicture) {
  const std::string csv = (folder_ / "out.csv").string(), svg = (folder_ / "out.svg").string();
  const Outcome outcome =
      check_path("t,x,y\n0,4.5,8\n1,4.6,8\n",
                 {"--csv", csv.c_str(), "--picture", svg.c_str(), "--distances", "5", "--json"});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  const double least = json::parse(outcome.output).at("least_distance").at("parallel_distance").get<double>();
  EXPECT_GT(least, 0.1);
  std::ifstream table(csv), picture(svg);
  std::string line;
  std::getline(table, line);
  EXPECT_TRUE(test::begins(line, "time,x,y,"));
  int lines = 0, measured = 0;
  while (std::getline(table, line)) {
    ++lines;
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    ASSERT_EQ(row.size(), 12U) << line;
    measured += row[8] == "1" ? 1 : 0;
    EXPECT_GE(std::stod(row[9]), least) << line;
  }
  EXPECT_GE(lines, 200);
  EXPECT_EQ(measured, 5);
  std::getline(picture, line);
  EXPECT_TRUE(test::begins(line, "<svg"));
  const std::string drawn{std::istreambuf_iterator<char>(picture), {}};
  for (const BoundaryKind kind : {BoundaryKind::parallel, BoundaryKind::serial, BoundaryKind::limit})
    EXPECT_TRUE(test::has(drawn, "fill=\"" + color_text(boundary_color(kind)) + "\"/>"))
        << "what the colours mean";
  EXPECT_EQ(check_path("t,x,y\n0,4.5,8\n", {"--csv", "/no/such/folder/a.csv"}).code, exit_code::bad_input);
  EXPECT_EQ(check_path("t,x,y\n0,4.5,8\n", {"--distances", "few"}).code, exit_code::bad_input);
}

TEST_F(CheckCommand, MarginsAreChecked) {
  const std::string path = "t,x,y\n0,4.5,8\n1,4.5,30\n";
  const Outcome outcome = check_path(path, {"--margin", "parallel=0.5", "--json"});
  ASSERT_EQ(outcome.code, exit_code::proved_no) << outcome.messages;
  const json result = json::parse(outcome.output);
  EXPECT_EQ(result.at("first_violation").at("constraint"), "margins");
}

TEST_F(CheckCommand, BadFilesAreRefusedWithASentenceEach) {
  for (const char* text : {"", "t,x,y\n", "t,x\n0,1\n", "t,x,y,z\n0,4.5,8,1\n", "t,x,y\n0,4.5,8\n0,4.6,8\n",
                           "t,x,y\n1,4.5,8\n0,4.6,8\n", "t,x,y\n0,4.5\n", "t,x,y\n0,4.5,nan\n",
                           "t,x,y\n0,4.5,inf\n", "t,x,y\n0,4.5,eight\n", "t,x,y\n0,4.5,80\n"}) {
    const Outcome outcome = check_path(text);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << text;
    EXPECT_EQ(outcome.output, "") << text;
    EXPECT_EQ(test::line_count(outcome.messages), 1U) << text << outcome.messages;
  }
  EXPECT_EQ(run({"check", "five_bar", "--path", "/no/such/file", "--mode", "+-"}).code, exit_code::bad_input);
  EXPECT_EQ(check_path("t,x,y\n0,4.5,8\n", {"--constraint", "cones"}).code, exit_code::bad_input);
}

TEST_F(CheckCommand, JointsAreFollowedFromTheStart) {
  const json start = test::run_json({"ik", "five_bar", "--pose", "4.5 8"});
  const json end = test::run_json({"ik", "five_bar", "--pose", "4.6 8"});
  const auto row = [](const json& poses) {
    const json& q = poses.at("solutions")[0].at("joints");
    return q[0].dump() + "," + q[1].dump() + "\n";
  };
  const std::string joints = start.at("actuated_joints")[0].get<std::string>() + "," +
                             start.at("actuated_joints")[1].get<std::string>();
  const std::string name = file("t," + joints + "\n0," + row(start) + "2," + row(end));
  const std::vector<const char*> arguments{"check", "five_bar", "--trajectory", name.c_str(), "--json"};
  const Outcome ambiguous = run(arguments);
  EXPECT_EQ(ambiguous.code, exit_code::bad_input);
  EXPECT_EQ(test::line_count(ambiguous.messages), 1U);
  EXPECT_TRUE(test::has(ambiguous.messages, "2 assembly modes; state which."));
  std::vector<const char*> stated = arguments;
  for (const std::string option :
       {"--start-pose \"", "--start-sign "}) {  // as the sentence says, to the letter
    const std::size_t at = ambiguous.messages.find(option);
    ASSERT_NE(at, std::string::npos) << ambiguous.messages;
    const std::size_t from = at + option.size();
    const std::string value =
        ambiguous.messages.substr(from, ambiguous.messages.find_first_of("\")", from) - from);
    stated.insert(stated.end(), {option.substr(0, 12).c_str(), value.c_str()});
    const Outcome followed = run(stated);
    EXPECT_TRUE(followed.code == exit_code::ok || followed.code == exit_code::proved_no) << followed.messages;
    stated = arguments;
  }
  stated.insert(stated.end(), {"--start-pose", "4.5 8"});
  const Outcome safe = run(stated);
  EXPECT_EQ(safe.code, exit_code::ok) << safe.output << safe.messages;
  stated.back() = "4.9 8";
  EXPECT_EQ(run(stated).code, exit_code::bad_input);
  file("t,shoulder\n0,1\n");
  EXPECT_EQ(run(arguments).code, exit_code::bad_input);
}

TEST_F(CheckCommand, AStartBelowAMarginIsRefusedBeforeAnythingStarts) {
  const Outcome outcome = check_path("t,x,y\n0,4.5,8\n1,4.6,8\n", {"--margin", "parallel=0.99"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
  EXPECT_TRUE(test::has(outcome.messages, "does not keep the margins: the parallel index is 0."));
}

TEST_F(CheckCommand, MessagesAreReadAsRostopicPrintsThem) {
  const json solutions = test::run_json({"ik", "five_bar", "--pose", "4.5 8"});
  const json& q = solutions.at("solutions")[0].at("joints");
  const json& joints = solutions.at("actuated_joints");
  // The joints in another order than the legs.
  const std::string names = "header: \n  seq: 0\njoint_names: \n  - " + joints[1].get<std::string>() +
                            "\n  - " + joints[0].get<std::string>() + "\npoints: \n";
  const auto point = [&q](const std::string& nsecs, const std::string& more) {
    return "  - \n    positions: [" + q[1].dump() + ", " + q[0].dump() + "]\n    " + more +
           "effort: []\n    time_from_start: \n      secs: 1\n      nsecs: " + nsecs + "\n";
  };
  const std::string still = "velocities: [0.0, 0.0]\n    accelerations: []\n    ";
  const std::string name = file(names + point("0", still) + point("500000000", still) + "---\n");
  const std::vector<const char*> arguments{"check",        "five_bar", "--trajectory", name.c_str(),
                                           "--start-pose", "4.5 8",    "--json"};
  const Outcome outcome = run(arguments);
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages << outcome.output;
  EXPECT_EQ(json::parse(outcome.output).at("free_until"), 1.5);
  const std::vector<std::string> bad{names,
                                     names + point("0", "velocities: [0.0]\n    "),
                                     names + point("soon", still),
                                     names + point("0", still) + point("0", still),
                                     names + point("0", still) + "---\n" + names + point("0", still),
                                     "joint_names: [a, b]\npoints: []\n",
                                     "joint_names: [\n",
                                     "joint_names: 3\n"};
  for (const std::string& text : bad) {
    file(text);
    EXPECT_EQ(run(arguments).code, exit_code::bad_input) << text;
    EXPECT_EQ(run(arguments).output, "");
  }
}

TEST_F(CheckCommand, OptionsThatDoNotGoTogetherAreRefused) {
  EXPECT_EQ(run({"check", "five_bar"}).code, exit_code::bad_usage);
  EXPECT_EQ(run({"check", "five_bar", "--path", "a", "--trajectory", "b"}).code, exit_code::bad_input);
  EXPECT_EQ(run({"check", "five_bar", "--path", "a"}).code, exit_code::bad_usage);
  EXPECT_EQ(run({"check", "five_bar", "--trajectory", "a", "--mode", "+-"}).code, exit_code::bad_input);
  EXPECT_EQ(run({"check", "five_bar", "--trajectory", "a", "--start-sign", "up"}).code, exit_code::bad_input);
}

TEST_F(CheckCommand, IsListedInTheHelp) { EXPECT_TRUE(test::has(run({"--help"}).output, "  check ")); }

// The short way round is not what the file asks for.
TEST_F(CheckCommand, TurnsOfHalfATurnOrMoreNeedWaypointsInBetween) {
  for (const char* const phi : {"6.283185307179586", "-3.2", "3.1415926535897932"}) {
    const std::string name = file(std::string("time,x,y,phi\n0,-1,-3,0\n1,-1,-3,") + phi + "\n");
    const Outcome outcome = run({"check", "three_rrr", "--path", name.c_str(), "--mode", "(-,+,-)"});
    EXPECT_EQ(outcome.code, exit_code::bad_input) << phi;
    EXPECT_TRUE(test::has(outcome.messages, "waypoint 2, turns phi"));
  }
}

TEST_F(CheckCommand, ATrajectoryThatIsTooFastIsNotSafe) {
  const Outcome outcome = check_path("t,x,y\n0,4.5,8\n0.001,4.6,8\n");
  EXPECT_EQ(outcome.code, exit_code::proved_no);
  EXPECT_TRUE(test::has(outcome.output, "Too fast: joint '"));
  EXPECT_TRUE(test::has(outcome.output, "safe: yes, but too fast\n"));
}

// As spreadsheets write it.
TEST_F(CheckCommand, AByteOrderMarkIsNoPartOfAName) {
  EXPECT_EQ(check_path("\xEF\xBB\xBFtime,x,y\n0,4.5,8\n1,4.6,8\n").code, exit_code::ok);
}

// Each would be another motion than the file means.
TEST_F(CheckCommand, KeysOfAMessageThatAreNotUnderstoodAreRefusedByName) {
  const json solutions = test::run_json({"ik", "five_bar", "--pose", "4.5 8"});
  const json& joints = solutions.at("actuated_joints");
  const std::string positions = "  - positions: " + solutions.at("solutions")[0].at("joints").dump() + "\n";
  const std::string names = "joint_names: " + joints.dump() + "\n", time = "    time_from_start: {secs: 1}\n";
  const std::string name = file(names + "points:\n" + positions + time);
  const std::vector<const char*> arguments{"check",      "five_bar",     "--trajectory",
                                           name.c_str(), "--start-pose", "4.5 8"};
  ASSERT_EQ(run(arguments).code, exit_code::ok) << run(arguments).messages;
  const std::string velocities = "    velocities: [0, 0]\n";
  const std::vector<std::pair<std::string, std::string>> bad{
      {names + "point: []\npoints:\n" + positions + time, "unknown key 'point' under the message"},
      {names + "points: []\npoints:\n" + positions + time, "key 'points' twice under the message"},
      {names + "points:\n" + positions + "    velocites: [0, 0]\n" + time,
       "unknown key 'velocites' under points[0]; did you mean 'velocities'?"},
      {names + "points:\n" + positions + velocities + velocities + time,
       "key 'velocities' twice under points[0]"},
      {names + "points:\n" + positions + "    time_from_start: {sec: 1}\n",
       "unknown key 'sec' under points[0].time_from_start; did you mean 'secs'?"},
      {names + "points:\n" + positions + "    time_from_start: {secs: 1, nanosec: 5}\n",
       "unknown key 'nanosec' under points[0].time_from_start"},
      {names + "points:\n" + positions + "    time_from_start: {secs: 1, nsec: 5}\n",
       "did you mean 'nsecs'?"},
      {names + "points:\n" + positions + "    time_from_start: {secs: 0.5}\n",
       "points[0].time_from_start.secs that is not a whole number"},
      {names + "points:\n" + positions + "    time_from_start: {secs: 1, nsecs: -5}\n",
       "points[0].time_from_start.nsecs that is not a whole number from 0 to 999999999"},
      {names + "points:\n" + positions + "    time_from_start: {secs: 1, nsecs: 1000000000}\n",
       "points[0].time_from_start.nsecs that is not a whole number from 0 to 999999999"},
      {names + "points:\n" + positions + "    time_from_start: {secs: 1, secs: 2}\n",
       "key 'secs' twice under points[0].time_from_start"}};
  for (const auto& [text, part] : bad) {
    file(text);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << text;
    EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
    EXPECT_TRUE(test::has(outcome.messages, part)) << text << outcome.messages;
  }
}

// Left out, it would shift the columns behind it.
TEST_F(CheckCommand, AnEmptyCellIsRefusedByLineAndColumn) {
  const std::vector<std::pair<std::string, std::string>> bad{
      {"t,x,y\n0,4.5,8\n1,,4.6,8\n", "line 3, has an empty cell in column 2"},
      {"t,x,y\n0,4.5,8\n,1,4.6,8\n", "line 3, has an empty cell in column 1"},
      {"t,x,y\n0,4.5, \t,8\n", "line 2, has an empty cell in column 3"},
      {"t,,x,y\n0,4.5,8\n", "line 1, has an empty cell in column 2"}};
  for (const auto& [text, part] : bad) {
    const Outcome outcome = check_path(text);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << text;
    EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
    EXPECT_TRUE(test::has(outcome.messages, part)) << text << outcome.messages;
  }
  // Behind all columns, as spreadsheets write them, and blank lines shift nothing.
  EXPECT_EQ(check_path("t,x,y,\r\n0, 4.5 ,8,\r\n,,,\r\n1 4.6 8,,\r\n").code, exit_code::ok);
}

TEST_F(CheckCommand, OutputsOverwriteNeitherInputsNorOneAnother) {
  const std::string text = "t,x,y\n0,4.5,8\n1,4.6,8\n", out = (folder_ / "out").string();
  const std::string input = file(text), other_name = (folder_ / "." / "path.csv").string();
  const std::string link = (folder_ / "link").string(), out_again = (folder_ / "." / "out").string();
  std::filesystem::create_hard_link(input, link);
  const std::vector<std::vector<const char*>> bad{{"--csv", input.c_str()},
                                                  {"--picture", other_name.c_str()},
                                                  {"--csv", link.c_str()},
                                                  {"--csv", out.c_str(), "--picture", out_again.c_str()}};
  for (const std::vector<const char*>& options : bad) {
    const Outcome outcome = check_path(text, options);
    EXPECT_EQ(outcome.code, exit_code::bad_input) << options[1];
    EXPECT_EQ(test::line_count(outcome.messages), 1U) << outcome.messages;
    EXPECT_TRUE(test::has(outcome.messages, "would be overwritten"));
    std::ifstream stream(input);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), text);
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(CheckCommand, ALateFirstWaypointIsWhereTheCheckBegins) {
  const std::string said = "From 5 s on: how the robot gets to the first waypoint is not checked.";
  const std::string late = "t,x,y\n5,4.5,8\n6,4.6,8\n", now = "t,x,y\n0,4.5,8\n1,4.6,8\n";
  EXPECT_TRUE(test::has(check_path(late).output, said));
  EXPECT_EQ(json::parse(check_path(late, {"--json"}).output).at("checked_from"), 5.0);
  EXPECT_FALSE(test::has(check_path(now).output, "is not checked"));
  EXPECT_EQ(json::parse(check_path(now, {"--json"}).output).at("checked_from"), 0.0);
}

TEST_F(CheckCommand, AFileWithoutEndIsRefused) {
  const Outcome outcome = run({"check", "five_bar", "--path", "/dev/zero", "--mode", "(+,-)"});
  EXPECT_EQ(outcome.code, exit_code::bad_input);
  EXPECT_EQ(outcome.messages, "File '/dev/zero' has more than 100 MB; give a smaller one.\n");
}

}  // namespace
}  // namespace parallel_aspects::tools
