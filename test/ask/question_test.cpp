// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/question.h"

#include <gtest/gtest.h>

namespace parallel_aspects::ask {
namespace {

const Problem no_map{ProblemKind::robot, "policy", "{policy} any needs a map",
                     "give {policy} serial, or {slice}"};

std::string as_option(const std::string& field) { return "--" + field; }

TEST(Problem, NamesItsFieldsAsEachFaceDoes) {
  EXPECT_EQ(text_of(no_map, as_option), "--policy any needs a map; give --policy serial, or --slice.");
  EXPECT_EQ(text_of(no_map, plain_name), "policy any needs a map; give policy serial, or slice.");
}

TEST(Problem, OfALayerBelowIsReportedAsItIs) {
  EXPECT_EQ(text_of(told("The region {x} is empty."), as_option), "The region {x} is empty.");
}

// As of a xacro file that was not expanded.
TEST(Problem, KeepsTheBracesOfNames) {
  const Problem of_joint{ProblemKind::value, "goal", "{goal} has 3 for '" + given("${prefix}joint") + "'",
                         "give 2"};
  EXPECT_EQ(text_of(of_joint, as_option), "--goal has 3 for '${prefix}joint'; give 2.");
  EXPECT_EQ(with_names(given("{{a}") + " {b}", as_option), "{{a} --b");
}

TEST(Problem, MayHaveABraceThatNamesNothing) {
  EXPECT_EQ(with_names("a { b", as_option), "a { b");
  EXPECT_EQ(with_names("", as_option), "");
}

}  // namespace
}  // namespace parallel_aspects::ask
