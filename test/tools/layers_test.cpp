// SPDX-License-Identifier: BSD-3-Clause
// The rooms of the house hold: includes point down only, and nothing below ros/ knows of ROS.
#include "tools/layer_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace parallel_aspects::test {
namespace {

// An empty tree in a folder of its own, gone at the end of the test.
class PlantedTree : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "layers_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = pattern;
    for (const std::string& room : rooms) {
      fs::create_directories(root_ / "src" / room);
      fs::create_directories(root_ / "include" / "parallel_aspects" / layer_of(room));
    }
  }
  void TearDown() override { fs::remove_all(root_); }

  void plant(const std::string& file, const std::string& line) {
    std::ofstream(root_ / file) << line << '\n';
  }

  fs::path root_;
};

TEST_F(PlantedTree, DownwardIncludesPass) {
  plant("include/parallel_aspects/model/leg.h", "");
  plant("src/tools/a.h",
        "#include \"parallel_aspects/model/leg.h\"\n#include <vector>\n#include <nlohmann/json.hpp>");
  plant("src/tools/subcommands/a.cpp", "#include \"tools/a.h\"");
  plant("src/ros/node/a.cpp", "#include <ros/ros.h>");
  EXPECT_EQ(violations_in(root_), Strings());
}

TEST_F(PlantedTree, UpwardIncludesAreFound) {
  plant("src/kinematics/direct/direct.cpp", "");
  plant("include/parallel_aspects/kinematics/direct.h", "");
  plant("src/kinematics/a.cpp", "#include \"parallel_aspects/kinematics/direct.h\"");
  plant("src/aspects/map/tree.h", "");
  plant("src/aspects/boxes/a.cpp", "  #  include <aspects/map/tree.h>");
  plant("include/parallel_aspects/model/a.h", "#include \"parallel_aspects/kinematics/direct.h\"");
  EXPECT_EQ(violations_in(root_).size(), 3U);
}

TEST_F(PlantedTree, RosBelowRosIsFound) {
  plant("src/tools/a.cpp", "#include <ros/ros.h>");
  plant("src/urdf/a.cpp", "#include <urdf/model.h>");
  plant("src/tracking/a.cpp", "#include \"parallel_aspects/State.h\"");
  plant("src/model/a.hpp", "#include <geometry_msgs/Pose.h>");
  EXPECT_EQ(violations_in(root_).size(), 4U);
}

TEST_F(PlantedTree, OptionalLayersAreIncludedByNoOther) {
  plant("src/ompl/a.h", "#include <ompl/base/State.h>");
  plant("src/ompl/b.cpp", "#include \"ompl/a.h\"\n#include \"parallel_aspects/model/leg.h\"");
  EXPECT_EQ(violations_in(root_), Strings());
  plant("src/ros/node/a.cpp", "#include \"ompl/a.h\"");
  plant("src/tools/a.cpp", "#include <ompl/base/State.h>");
  EXPECT_EQ(violations_in(root_).size(), 2U);
  plant("src/rviz/display/a.h", "#include <rviz/display.h>\n#include \"ros/node/b.h\"");
  plant("src/rviz/panel/a.cpp", "#include \"rviz/display/a.h\"\n#include \"ompl/a.h\"");
  plant("src/ros/programs/a.cpp", "#include \"rviz/display/a.h\"");
  EXPECT_EQ(violations_in(root_).size(), 4U);
}

TEST_F(PlantedTree, StraySourcesAreFound) {
  EXPECT_EQ(strays_in(root_), Strings());
  plant("src/a.cpp", "");
  plant("src/aspects/a.cpp", "");
  fs::create_directories(root_ / "include" / "parallel_aspects" / "util");
  plant("include/parallel_aspects/util/a.h", "");
  EXPECT_EQ(strays_in(root_).size(), 3U);
}

TEST_F(PlantedTree, StrayTestsAreFound) {
  for (const char* folder : {"test/aspects/tree", "test/legs", "test/support"})
    fs::create_directories(root_ / folder);
  plant("test/aspects/tree/a_test.cpp", "");
  plant("test/aspects/b_test.cpp", "");
  plant("test/support/c.h", "");
  EXPECT_EQ(stray_tests_in(root_), Strings());
  plant("test/support/d_test.cpp", "");
  plant("test/e_test.cpp", "");
  EXPECT_EQ(stray_tests_in(root_).size(), 2U);
}

TEST_F(PlantedTree, MisplacedTestsAreFound) {
  for (const char* folder : {"test/aspects/tree", "test/legs"}) fs::create_directories(root_ / folder);
  plant("include/parallel_aspects/aspects/box.h", "");
  plant("src/legs/row.h", "");
  plant("test/aspects/tree/box_test.cpp", "");
  plant("test/legs/row_test.cpp", "");
  plant("test/legs/all_robots_test.cpp", "");
  EXPECT_EQ(misplaced_tests_in(root_), Strings());
  plant("test/legs/box_test.cpp", "");
  plant("test/aspects/tree/row_test.cpp", "");
  EXPECT_EQ(misplaced_tests_in(root_).size(), 2U);
}

TEST_F(PlantedTree, PrivateIncludesAndRepeatedNamesAreFound) {
  plant("src/model/a.h", "");
  plant("include/parallel_aspects/model/b.h", "#include \"model/a.h\"");
  plant("src/legs/a.h", "");
  EXPECT_EQ(private_includes_in(root_).size(), 1U);
  EXPECT_EQ(repeated_names_in(root_), Strings{"a.h"});
}

TEST_F(PlantedTree, SingleKindsOfLegsAreFound) {
  plant("src/model/a.cpp", "std::visit(Overloaded{[](const RevoluteActuation&) {}}, leg.actuation);");
  EXPECT_EQ(single_kinds_in(root_), Strings());
  plant("src/legs/a.cpp", "const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation);");
  plant("src/tools/b.cpp", "return std::holds_alternative<ElbowActuation>(leg.actuation);");
  EXPECT_EQ(single_kinds_in(root_).size(), 2U);
}

const fs::path here = PARALLEL_ASPECTS_SOURCE_DIR;

TEST(Layers, IncludesPointDown) {
  const Strings violations = violations_in(here);
  EXPECT_TRUE(violations.empty()) << listed(violations);
}

TEST(Layers, EverySourceIsInARoom) {
  const Strings strays = strays_in(here);
  EXPECT_TRUE(strays.empty()) << listed(strays);
}

TEST(Layers, EveryTestIsInARoom) {
  const Strings strays = stray_tests_in(here);
  EXPECT_TRUE(strays.empty()) << listed(strays);
}

TEST(Layers, EveryTestNamedAsASourceIsInItsRoom) {
  const Strings misplaced = misplaced_tests_in(here);
  EXPECT_TRUE(misplaced.empty()) << listed(misplaced);
}

TEST(Layers, NoSourceLooksForOneKindOfLeg) { EXPECT_EQ(single_kinds_in(here), Strings()); }

TEST(Layers, PublicHeadersAreFewAndIncludeNoPrivateOnes) {
  const Strings found = private_includes_in(here);
  EXPECT_TRUE(found.empty()) << listed(found);
  EXPECT_LE(sources_in(here / "include").size(), max_public_headers);
}

TEST(Layers, TheUmbrellaHeaderIncludesEveryPublicOne) {
  const fs::path umbrella = here / "include/parallel_aspects/parallel_aspects.h";
  const Strings included = includes_of(umbrella);
  std::size_t count = 1 + included.size();
  for (const std::string& layer : optional_layers)
    count += sources_in(here / "include" / "parallel_aspects" / layer).size();
  EXPECT_EQ(count, sources_in(here / "include").size());
  for (const std::string& header : included) EXPECT_TRUE(fs::exists(here / "include" / header)) << header;
}

// What a build may leave out: none but its own sources includes it, and those that ask which parts there are.
TEST(Layers, WingsAreIncludedOnlyWhereTheyMayBeMissing) {
  const std::regex wing("urdf/setup/|tools/sweep/|report/setup_report"),
      own("/(setup|sweep)/|(setup|sweep|chart)_(command|report)|bind_sweep|/parallel_aspects.h");
  for (const char* folder : {"src", "include"})
    for (const fs::path& file : sources_in(here / folder)) {
      const Strings headers = includes_of(file);
      const bool asks = std::count(headers.begin(), headers.end(), "parallel_aspects/model/wings.h") > 0;
      if (asks || std::regex_search(file.string(), own)) continue;
      for (const std::string& header : headers)
        EXPECT_FALSE(std::regex_search(header, wing)) << file << " includes " << header;
    }
}

TEST(Layers, NoFolderHoldsTooManyFiles) {
  for (const char* folder : {"src", "include", "test/support"})
    for (const auto& [name, count] : files_by_folder(here / folder))
      EXPECT_LE(count, max_files_in_a_folder) << name;
}

TEST(Layers, NoTwoFilesHaveOneName) { EXPECT_EQ(repeated_names_in(here), Strings()); }

}  // namespace
}  // namespace parallel_aspects::test
