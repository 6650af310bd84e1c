// SPDX-License-Identifier: BSD-3-Clause
//
// Short texts that stand for much, and long ones that ask for more than their length: each is refused with a
// message, or loaded, before it has taken the memory or the time of the machine.
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include <string>

namespace parallel_aspects {
namespace {

// All that is wrong with the five-bar after a change; empty where it is loaded.
std::string problems_of(const test::Description& description) {
  try {
    test::load(description);
  } catch (const InvalidDescription& invalid) {
    return invalid.what();
  }
  return {};
}

test::Description five_bar_with_config(const std::string& config) {
  return {test::source_file("urdf/five_bar.urdf"), config};
}

test::Description five_bar_with(const std::string& elements) {
  test::Description five_bar = test::shipped_text("five_bar");
  five_bar.urdf.insert(five_bar.urdf.find("</robot>"), elements);
  return five_bar;
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

bool says(const std::string& problems, const std::string& message) {
  return problems.find(message) != std::string::npos;
}

TEST(EnormousYaml, OfAliasesThatMultiply) {
  std::string config = "a0: &a0 {frames: [tool]}\n";
  for (int level = 1; level <= 8; ++level)
    config += "a" + std::to_string(level) + ": &a" + std::to_string(level) + " [" +
              repeated("*a" + std::to_string(level - 1) + ", ", 10) + "]\n";
  const std::string problems = problems_of(five_bar_with_config(config + "mechanism: {closures: *a8}\n"));
  EXPECT_TRUE(says(problems,
                   "cannot be read as YAML at line 6: more than 200000 characters are said, each alias "
                   "counted as what it stands for; correct it there."))
      << problems.substr(0, 300);
}

TEST(EnormousYaml, OfLongTextsAndManyAliases) {
  const std::string config = "long: &long {? " + std::string(9000, 'x') + " : 1}\nmechanism: {closures: [" +
                             repeated("*long,", 9000) + "]}\n";
  const std::string problems = problems_of(five_bar_with_config(config));
  EXPECT_TRUE(says(problems, "more than 200000 characters")) << problems.substr(0, 300);
}

TEST(EnormousYaml, OfAnAliasInsideItself) {
  const std::string problems = problems_of(five_bar_with_config("mechanism: &a {closures: [*a]}\n"));
  EXPECT_TRUE(says(problems, "at line 1: an alias stands inside what it stands for")) << problems;
}

TEST(EnormousYaml, OfListsInOneAnother) {
  const std::string config = "mechanism: {closures: " + std::string(300, '[') + std::string(300, ']') + "}\n";
  const std::string problems = problems_of(five_bar_with_config(config));
  EXPECT_TRUE(says(problems, "more than 100 lists and maps lie in one another")) << problems;
}

// To yaml-cpp a comma where a document ends begins another one, and that one more, without end.
TEST(EnormousYaml, OfACommaAfterADocument) {
  for (const char* config : {",", "- a\n,", "\"a\" , b", "[a] , b", "--- a\n...\n,"}) {
    const std::string problems = problems_of(five_bar_with_config(config));
    EXPECT_TRUE(says(problems, "a second document begins")) << config << ": " << problems;
  }
}

TEST(EnormousMechanism, OfManyClosures) {
  test::Description five_bar = test::shipped_text("five_bar");
  const std::string closure = "- {frames: [tool, closing_2], type: revolute}";
  five_bar.change_config(closure, repeated(closure + "\n    ", 1000));
  const std::string problems = problems_of(five_bar);
  EXPECT_TRUE(says(problems, "describe 1000 closures, and at most 36 are treated")) << problems;
}

TEST(EnormousMechanism, OfManyJointsInALoop) {
  std::string chain, parent = "rod_1";
  for (int k = 0; k < 1000; ++k) {
    const std::string child = "chain_" + std::to_string(k);
    chain += "<link name=\"" + child + "\"/>" +
             test::moving_joint("of_" + child, parent, child, "0 0 1", "xyz=\"0.001 0 0\"");
    parent = child;
  }
  test::Description five_bar = five_bar_with(chain);
  five_bar.change_config("[tool, closing_2]", "[" + parent + ", closing_2]");
  const std::string problems = problems_of(five_bar);
  EXPECT_TRUE(says(problems, "movable joints in its loops, and at most 120 are treated")) << problems;
}

TEST(EnormousNames, OfAClosingFrame) {
  const std::string frame = "closing_" + std::string(1000000, 'a') + "_1";
  test::Description five_bar =
      five_bar_with("<link name=\"" + frame + "\"/>" + test::fixed_joint("base_link", frame, ""));
  five_bar.config = "mechanism: {operational_point: tool}\n";
  EXPECT_TRUE(says(problems_of(five_bar), "has the closing frame 'closing_aaa"));
}

TEST(EnormousNames, ThatMayBeMeant) {
  const std::string link(1000000, 'a'), other(1000000, 'b');
  const std::string problems =
      problems_of(five_bar_with("<link name=\"" + link + "\"/>" + test::fixed_joint(other, link, "")));
  EXPECT_TRUE(says(problems, "which does not exist; add it, or write '")) << problems.substr(0, 300);
}

TEST(EnormousXml, OfElementsInOneAnother) {
  std::string foreign = repeated("<a>", 90) + repeated("<b/>", 500000) + repeated("</a>", 90);
  EXPECT_EQ(problems_of(five_bar_with(foreign)), "");
}

}  // namespace
}  // namespace parallel_aspects
