// SPDX-License-Identifier: BSD-3-Clause
//
// Platforms on two passive hinges in MJCF: the shipped robots by their files alone.
#include "urdf/reading/description_file.h"
#include "urdf/setup/setup_texts.h"

#include <gtest/gtest.h>

#include "support/same_legs.h"
#include <ostream>
#include <string>

namespace parallel_aspects {
namespace {

struct Hinged {
  const char *robot, *base, *platform;
  test::Strings joints;
};

void PrintTo(const Hinged& hinged, std::ostream* stream) { *stream << hinged.robot; }

SetupResult set_up_file(const std::string& robot) {
  Problems problems;
  const std::string path = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/mjcf/" + robot + ".xml";
  const auto text = read_description_file(path, problems);
  EXPECT_TRUE(text) << test::listed(problems);
  return test::set_up_text(text.value_or(""));
}

class MjcfHinges : public ::testing::TestWithParam<Hinged> {};

TEST_P(MjcfHinges, AreSetUpFromTheFileAlone) {
  const Hinged& expected = GetParam();
  const SetupResult result = set_up_file(expected.robot);
  ASSERT_TRUE(result.mechanism) << test::listed(result.problems)
                                << (result.question ? result.question->text : "");
  EXPECT_FALSE(result.question) << result.question->text;
  EXPECT_EQ(result.mechanism->manipulator()->task_space(), TaskSpace::R2);
  EXPECT_EQ(result.mechanism->manipulator()->base_frame(), expected.base);
  EXPECT_EQ(result.mechanism->platform_link(), expected.platform);
  EXPECT_EQ(test::actuated_joints(*result.mechanism), expected.joints);
  test::expect_same_legs(*result.mechanism, *test::shipped(expected.robot));
}

INSTANTIATE_TEST_SUITE_P(All, MjcfHinges,
                         ::testing::Values(Hinged{"ankle", "world", "foot", {"motor_left", "motor_right"}},
                                           Hinged{"tilt_table", "world", "table", {"stroke_x", "stroke_y"}}),
                         [](const auto& hinged) { return std::string(hinged.param.robot); });

}  // namespace
}  // namespace parallel_aspects
