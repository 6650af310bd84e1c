// SPDX-License-Identifier: BSD-3-Clause
#include "tools/numbers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using Numbers = std::vector<double>;

TEST(Numbers, AreSeparatedByBlanksOrCommas) {
  for (const char* text : {"-1 2.5", "-1,2.5", " -1 , 2.5 ", "-1e0\t25e-1"}) {
    Problems problems;
    EXPECT_EQ(parse_numbers("--pose", text, {"x", "y"}, problems), Numbers({-1.0, 2.5})) << text;
    EXPECT_TRUE(problems.empty()) << text;
  }
}

TEST(Numbers, MayHaveTheirNamesAsAnswersPrintThem) {
  Problems problems;
  EXPECT_EQ(parse_numbers("--pose", "x -1, y 2.5", {"x", "y"}, problems), Numbers({-1.0, 2.5}));
  EXPECT_TRUE(problems.empty());
  parse_numbers("--pose", "y -1, x 2.5", {"x", "y"}, problems);
  EXPECT_FALSE(problems.empty());
}

TEST(Numbers, NamedOnesMayHaveBlanksAroundTheSign) {
  EXPECT_EQ(words_of_list("z = 0.5, roll=0  yaw= 1"), (std::vector<std::string>{"z=0.5", "roll=0", "yaw=1"}));
}

TEST(Numbers, EveryProblemIsReportedAtOnce) {
  Problems problems;
  parse_numbers("--pose", "nan inf x", {"x", "y"}, problems);
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_EQ(problems[0], "--pose has 3 numbers, but needs 2: \"x y\".");
  EXPECT_EQ(problems[1], "--pose has 'nan', which is not a finite number; give one.");
}

class Garbage : public testing::TestWithParam<const char*> {};

TEST_P(Garbage, IsNoPositiveNumber) {
  Problems problems;
  parse_positive("--resolution", GetParam(), problems);
  EXPECT_EQ(problems.size(), 1U);
}

TEST_P(Garbage, IsNoCount) {
  Problems problems;
  parse_count("--threads", GetParam(), 8, problems);
  EXPECT_EQ(problems.size(), std::string(GetParam()) == "0" ? 0U : 1U);
}

INSTANTIATE_TEST_SUITE_P(All, Garbage,
                         testing::Values("", " ", "nan", "-nan", "inf", "-inf", "1e999", "-1", "0", "-0.0",
                                         "1 ", " 1", "1x", "0.1.2", "1,5", "9999999999999999999999x", "--",
                                         "\xff"));

TEST(Numbers, CountsStopAtTheLargest) {
  Problems problems;
  EXPECT_EQ(parse_count("--threads", "8", 8, problems), 8U);
  EXPECT_TRUE(problems.empty());
  parse_count("--threads", "9", 8, problems);
  parse_count("--threads", "99999999999999999999", 8, problems);
  EXPECT_EQ(problems.size(), 2U);
}

TEST(Numbers, CountsBeginAtTheLeast) {
  Problems problems;
  EXPECT_EQ(parse_count("--samples", "1", 8, problems, 1), 1U);
  EXPECT_TRUE(problems.empty());
  for (const char* text : {"0", "-5", "some"}) parse_count("--samples", text, 8, problems, 1);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0], "--samples is '0'; give a whole number from 1 to 8.");
  EXPECT_EQ(problems[1], "--samples is '-5'; give a whole number from 1 to 8.");
}

}  // namespace
}  // namespace parallel_aspects::tools
