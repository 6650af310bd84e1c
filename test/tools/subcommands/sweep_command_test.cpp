// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"
#include "tools/sweep/sweep_chart.h"

#include <gtest/gtest.h>

#include "support/command_run.h"
#include "support/texts.h"
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <signal.h>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using test::Outcome;
using test::run;

void write(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

class SweepCommand : public test::CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    for (const std::string& each : {whole, part, merged}) std::remove(each.c_str());
    for (int i = 1; i <= 4; ++i) std::remove(shard_file(i).c_str());
  }

  static std::string shard_file(int i) { return testing::TempDir() + "sweep_" + std::to_string(i) + ".csv"; }

  /// A sweep of 28 five-bars, of which some cannot be.
  static Outcome sweep(const std::string& file, std::vector<const char*> more = {}) {
    std::vector<const char*> arguments{"sweep",        "five_bar",  "--vary",   "crank_1=-1:8:7 rod_2=3:8:4",
                                       "--resolution", "2",         "--report", "count,measures",
                                       "-o",           file.c_str()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  const std::string whole = testing::TempDir() + "sweep_whole.csv",
                    part = testing::TempDir() + "sweep_part.csv",
                    merged = testing::TempDir() + "sweep_merged.csv";
};

TEST_F(SweepCommand, ARowADesign) {
  const Outcome outcome = sweep(whole);
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  std::istringstream text(test::contents_of(whole));
  std::string line;
  std::getline(text, line);
  EXPECT_TRUE(test::begins(line, "# aspects sweep 1, fingerprint "));
  std::getline(text, line);
  EXPECT_EQ(line,
            "design,crank_1,rod_2,status,aspects_at_least,aspects_at_most,components,measure_lower,measure_"
            "undecided,largest_lower,largest_upper");
  const auto commas = std::count(line.begin(), line.end(), ',');
  int rows = 0, refused = 0;
  while (std::getline(text, line)) {
    ++rows;
    refused += line.find(",refused,") != std::string::npos;
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
  }
  EXPECT_EQ(rows, 28);
  EXPECT_EQ(refused, 4) << "a length of -1";
}

TEST_F(SweepCommand, GoesOnWhereItWasCutOff) {
  ASSERT_EQ(sweep(whole).code, exit_code::ok);
  const std::string text = test::contents_of(whole);
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{10}, text.size() / 3, text.size() / 2, text.size()}) {
    write(part, text.substr(0, length));
    EXPECT_EQ(sweep(part).code, exit_code::ok);
    EXPECT_EQ(test::contents_of(part), text) << "cut after " << length;
  }
}

// A process of its own is killed three times; what it wrote is gone on with.
TEST_F(SweepCommand, IsEqualAfterKills) {
  ASSERT_EQ(sweep(whole, {"--threads", "1"}).code, exit_code::ok);
  for (int kill_number = 0; kill_number < 3; ++kill_number) {
    const std::size_t before = test::contents_of(part).size();
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) _exit(sweep(part, {"--threads", "1"}).code);
    while (test::contents_of(part).size() < before + 200 && waitpid(child, nullptr, WNOHANG) == 0)
      usleep(200);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  EXPECT_EQ(sweep(part).code, exit_code::ok);
  EXPECT_EQ(test::contents_of(part), test::contents_of(whole));
}

TEST_F(SweepCommand, ShardsMergeToTheWhole) {
  ASSERT_EQ(sweep(whole).code, exit_code::ok);
  for (const int count : {2, 4}) {
    std::string parts;
    for (int i = count; i >= 1; --i) {
      std::remove(shard_file(i).c_str());
      const std::string shard = std::to_string(i) + "/" + std::to_string(count);
      ASSERT_EQ(sweep(shard_file(i), {"--shard", shard.c_str()}).code, exit_code::ok);
      parts += shard_file(i) + " ";
    }
    ASSERT_EQ(run({"merge", parts.c_str(), "-o", merged.c_str()}).code, exit_code::ok);
    EXPECT_EQ(test::contents_of(merged), test::contents_of(whole)) << count;
    if (count != 2) continue;
    ASSERT_EQ(run({"merge", shard_file(1).c_str(), shard_file(2).c_str(), "-o", part.c_str()}).code,
              exit_code::ok);
    EXPECT_EQ(test::contents_of(part), test::contents_of(whole));
  }
}

TEST_F(SweepCommand, PartsThatDoNotBelongTogetherAreRefused) {
  const auto refused = [&](const std::string& parts) {
    const Outcome outcome = run({"merge", parts.c_str(), "-o", merged.c_str()});
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    return outcome.messages;
  };
  const std::string one = shard_file(1), two = shard_file(2), other = shard_file(3);
  ASSERT_EQ(sweep(one, {"--shard", "1/2"}).code, exit_code::ok);
  ASSERT_EQ(sweep(two, {"--shard", "2/2"}).code, exit_code::ok);
  ASSERT_EQ(sweep(other, {"--shard", "2/2", "--mode", "(+,+)"}).code, exit_code::ok);
  EXPECT_EQ(refused(one), "Shard 2/2 is missing; give its file, too.\n");
  EXPECT_TRUE(test::has(refused(one + " " + other), "is of another sweep"));
  EXPECT_TRUE(test::has(refused(one + " " + two + " " + one), "are the same shard"));
  const std::string text = test::contents_of(two);
  write(two, text.substr(0, text.size() - 20));
  EXPECT_TRUE(test::has(refused(one + " " + two), "is damaged at its row"));
  for (const std::size_t at : {text.rfind("mapped"), text.size() - 2}) {
    std::string damaged = text;
    damaged[at] = 'x';
    write(two, damaged);
    EXPECT_TRUE(test::has(refused(one + " " + two), "is damaged at its row 14")) << damaged;
    const std::string said = sweep(two, {"--shard", "2/2"}).messages;
    EXPECT_TRUE(test::has(said, "has another row 14"));
    EXPECT_EQ(test::contents_of(two), damaged);
  }
  write(two, text.substr(0, text.rfind('\n', text.size() - 2) + 1));
  EXPECT_TRUE(test::has(refused(one + " " + two), "has 13 of its 14 rows"));
  write(two, "x\n");
  EXPECT_TRUE(test::has(refused(one + " " + two), "cannot be read as the file of a sweep"));
}

TEST_F(SweepCommand, FilesOfOtherSweepsStayAsTheyAre) {
  write(part, "time,x,y\n0,1,2\n");
  EXPECT_EQ(sweep(part).code, exit_code::bad_input);
  EXPECT_EQ(test::contents_of(part), "time,x,y\n0,1,2\n");
  ASSERT_EQ(sweep(whole).code, exit_code::ok);
  const std::string text = test::contents_of(whole);
  const Outcome other = sweep(whole, {"--margin", "parallel=0.1"});
  EXPECT_EQ(other.code, exit_code::bad_input);
  EXPECT_TRUE(test::has(other.messages, "is of another robot, command"));
  EXPECT_EQ(test::contents_of(whole), text);
}

TEST_F(SweepCommand, SobolFillsTheRanges) {
  const auto outcome =
      run({"sweep", "five_bar", "--vary", "crank_1=6:8 rod_2=7:9", "--sample", "sobol", "--designs", "8",
           "--resolution", "2", "--report", "workspace", "--shape", "disc", "-o", whole.c_str()});
  ASSERT_EQ(outcome.code, exit_code::ok) << outcome.messages;
  EXPECT_EQ(test::line_count(test::contents_of(whole)), 10U);
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST_F(SweepCommand, ChartsHaveACellADesignAndLinesWhereTheNumberOfAspectsChanges) {
  ASSERT_EQ(sweep(whole).code, exit_code::ok);
  const std::string picture = testing::TempDir() + "sweep.svg";
  const auto drawn = [&](std::vector<const char*> more) {
    std::vector<const char*> arguments{"chart",         whole.c_str(), "--column",
                                       "measure_lower", "-o",          picture.c_str()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const Outcome plane = drawn({});
  ASSERT_EQ(plane.code, exit_code::ok) << plane.messages;
  EXPECT_TRUE(test::has(plane.output, "measure_lower of 28 designs over crank_1 and rod_2"));
  EXPECT_EQ(occurrences(test::contents_of(picture), ">not known<"), 4U) << "a length of -1";
  EXPECT_EQ(occurrences(test::contents_of(picture), ", aspects: "), 24U);
  const Outcome line = drawn({"--at", "rod_2=3"});
  ASSERT_EQ(line.code, exit_code::ok) << line.messages;
  EXPECT_TRUE(test::has(line.output, "of 7 designs over crank_1"));
  EXPECT_EQ(drawn({"--over", "crank_1"}).code, exit_code::bad_input);
  EXPECT_TRUE(test::has(drawn({"--over", "crank_1"}).messages, "'rod_2' varies, too"));
  EXPECT_TRUE(test::has(drawn({"--at", "rod_2=1"}).messages, "No row has"));
  EXPECT_TRUE(test::has(drawn({"--at", "rod=1"}).messages, "--at names 'rod'"));
  EXPECT_TRUE(test::has(run({"chart", whole.c_str(), "--column", "weight", "-o", picture.c_str()}).messages,
                        "--column is 'weight'"));
}

TEST(SweepChart, NumbersThatAreProvedToDifferAreReported) {
  const auto point = [](std::optional<double> least, std::optional<double> most) {
    return ChartPoint{0.0, 0.0, 1.0, least, most};
  };
  EXPECT_EQ(change_between(point(8, 8), point(10, 10)), CountChange::proved);
  EXPECT_EQ(change_between(point(12, {}), point(8, 11)), CountChange::proved);
  EXPECT_EQ(change_between(point(8, {}), point(10, 10)), CountChange::possible);
  EXPECT_EQ(change_between(point(8, 10), point(9, {})), CountChange::possible);
  EXPECT_EQ(change_between(point(10, 10), point(10, 10)), CountChange::none);
  EXPECT_EQ(change_between(point({}, {}), point(10, 10)), CountChange::none) << "no figures";
}

TEST(SweepChart, LinesAreWhereNeighboursDiffer) {
  SweepChart chart{"c", {"a"}, {}, true};
  for (const auto& [x, count] : {std::pair(3.0, 10.0), {1.0, 8.0}, {2.0, 8.0}, {4.0, 10.0}})
    chart.points.push_back({x, 0.0, x, count, count});
  const PagePicture picture = draw_chart(chart, "");
  std::size_t lines = 0;
  for (const PageElement& element : picture.elements)
    if (const auto* curves = std::get_if<PageCurves>(&element))
      for (const PageLine& line : curves->lines)
        if (line.size() == 2 && line[0].x() == line[1].x() && line[0].y() != line[1].y()) {
          ++lines;
          EXPECT_EQ(line[0].x(), 80.0 + 0.5 * 520.0) << "between 2 and 3 of 1 to 4";
        }
  EXPECT_EQ(lines, 1U);
}

TEST_F(SweepCommand, WhatDoesNotFitIsRefused) {
  const auto refused = [&](const char* vary, std::vector<const char*> more) {
    std::vector<const char*> arguments{"sweep", "five_bar", "--vary", vary, "-o", whole.c_str()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, exit_code::bad_input);
    return outcome.messages;
  };
  EXPECT_TRUE(test::has(refused("wheel_1=1", {}), "There is no parameter 'wheel_1'"));
  EXPECT_TRUE(test::has(refused("crank_1=1:2", {}), "--vary has 'crank_1=1:2'"));
  EXPECT_TRUE(test::has(refused("crank_1=2:1:5", {}), "the lower end comes first"));
  EXPECT_EQ(refused("crank_1=1:2:-5", {}),
            "--vary crank_1 is '-5'; give a whole number from 0 to 100000000.\n");
  EXPECT_TRUE(test::has(refused("crank_1=1:2:5", {"--shard", "0/2"}), "--shard is '0/2'"));
  EXPECT_TRUE(test::has(refused("crank_1=1:2:5", {"--report", "weight"}), "--report has 'weight'"));
  EXPECT_TRUE(test::has(refused("crank_1=1:2:5", {"--report", "workspace"}), "takes --shape"));
  const std::string all = refused(
      "crank_1=1:2:5", {"--report", "workspace", "--shape", "ball", "--resolution", "0", "--gap", "2"});
  for (const char* words : {"--resolution is '0'", "A ball takes 3", "--gap is a share"})
    EXPECT_TRUE(test::has(all, words));
  EXPECT_TRUE(test::has(refused("crank_1=1:2", {"--sample", "sobol"}), "takes --designs"));
}

}  // namespace
}  // namespace parallel_aspects::tools
