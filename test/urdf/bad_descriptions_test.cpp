// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <algorithm>
#include <filesystem>
#include <sstream>

namespace parallel_aspects {
namespace {

// Each file of test/data/bad holds one fault of the five-bar, and the messages that it must be refused with,
// each in a line that starts with "expect: ".
std::vector<std::string> bad_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(PARALLEL_ASPECTS_SOURCE_DIR "/test/data/bad"))
    files.push_back(entry.path().filename().string());
  std::sort(files.begin(), files.end());
  return files;
}

Problems expected_problems(const std::string& text) {
  const std::string marker = "expect: ";
  Problems expected;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (const auto start = line.find(marker); start != std::string::npos)
      expected.push_back(line.substr(start + marker.size()));
  return expected;
}

Problems problems_of(const std::string& urdf, const std::string& urdf_name, const std::string& config,
                     const std::string& config_name) {
  try {
    load_mechanism(urdf, urdf_name, config, config_name);
  } catch (const InvalidDescription& invalid) {
    return invalid.problems();
  }
  return {};
}

class BadDescription : public ::testing::TestWithParam<std::string> {};

TEST_P(BadDescription, IsRefusedWithItsSentence) {
  const std::string text = test::source_file("test/data/bad/" + GetParam());
  const Problems expected = expected_problems(text);
  ASSERT_FALSE(expected.empty());
  const bool is_config = GetParam().find(".yaml") != std::string::npos;
  const Problems found =
      is_config
          ? problems_of(test::source_file("urdf/five_bar.urdf"), "five_bar.urdf", text, GetParam())
          : problems_of(text, GetParam(), test::source_file("config/robots/five_bar.yaml"), "five_bar.yaml");
  EXPECT_EQ(found, expected);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, BadDescription, ::testing::ValuesIn(bad_files()), test_name);

TEST(BadDescriptions, AreReportedAllAtOnce) {
  const Problems problems = problems_of("<robot/>", "robot.urdf", "mechanism: {colour: red}", "robot.yaml");
  const Problems expected{
      "robot.yaml has an unknown key 'colour' under mechanism; there are 'name', 'base_link', "
      "'operational_point', 'actuated_joints', 'task_space', 'symmetrize', 'tolerance', 'closures', "
      "'added_closures', 'task'.",
      "robot.yaml does not say mechanism.operational_point; name the link whose origin is the operational "
      "point of the platform.",
      "robot.urdf has a <robot> without a name; write <robot name=\"...\">.",
      "robot.urdf has no links; give a URDF with the links and joints of the robot."};
  EXPECT_EQ(problems, expected);
}

TEST(BadDescriptions, MayBeEmpty) {
  const Problems problems = problems_of("", "robot.urdf", "", "robot.yaml");
  const Problems expected{
      "robot.yaml has no key 'mechanism'; add it, with base_link, operational_point, actuated_joints and "
      "closures.",
      "robot.urdf is empty or missing; give a URDF."};
  EXPECT_EQ(problems, expected);
}

TEST(InvalidDescription, NeverComesWithoutAReason) {
  EXPECT_EQ(InvalidDescription({}).problems().size(), 1U);
  EXPECT_FALSE(std::string(InvalidDescription({}).what()).empty());
  EXPECT_EQ(InvalidDescription({"one", "two"}).problems(), (Problems{"one", "two"}));
}

TEST(SharedMechanism, IsNeverNull) {
  EXPECT_THROW(SharedMechanism{nullptr}, InvalidDescription);
  EXPECT_TRUE(SharedMechanism(test::shipped("five_bar"))->manipulator());
}

}  // namespace
}  // namespace parallel_aspects
