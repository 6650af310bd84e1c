// SPDX-License-Identifier: BSD-3-Clause
// The rooms of the house hold: includes point down only, and nothing below ros/ knows of ROS.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

// From the bottom to the top; each may include itself and those before it. A room is a folder of src/, and
// has the public headers of its sources. A public header without a source is in the lowest room of its layer.
const Strings rooms{"model",
                    "kinematics",
                    "kinematics/homotopy",
                    "kinematics/direct",
                    "singularity",
                    "interval",
                    "legs",
                    "aspects/tree",
                    "aspects/constraints",
                    "aspects/boxes",
                    "aspects/symmetry",
                    "aspects/components",
                    "aspects/map",
                    "aspects/graph",
                    "aspects/basins",
                    "aspects/roadmap",
                    "aspects/file",
                    "aspects/pictures",
                    "distance",
                    "tracking",
                    "motion",
                    "motion/check",
                    "motion/plan",
                    "motion/timing",
                    "motion/choose",
                    "motion/guard",
                    "urdf/description",
                    "urdf/config",
                    "urdf/reading",
                    "urdf/dialects",
                    "urdf/closing",
                    "urdf/recognition",
                    "urdf/corrections",
                    "urdf/culprits",
                    "urdf",
                    "urdf/setup",
                    "tools/report",
                    "tools/drawing",
                    "tools",
                    "tools/paths",
                    "tools/subcommands",
                    "ompl",
                    "ros/parameters",
                    "ros/messages",
                    "ros/joint_states",
                    "ros/monitor",
                    "ros/pictures",
                    "ros/node",
                    "ros/programs",
                    "rviz/display",
                    "rviz/panel"};

constexpr std::size_t max_files_in_a_folder = 30;
constexpr std::size_t max_public_headers = 60;

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

// Layers that a build may leave out, so that none but themselves may include them.
const Strings optional_layers{"ompl", "rviz"};

std::string layer_of(const std::string& room) { return room.substr(0, room.find('/')); }

// What a layer below ros/ may include besides the standard library and lower rooms.
const Strings& libraries(const std::string& layer) {
  static const Strings eigen{"Eigen/"};
  static const Strings aspects{"Eigen/", "tbb/", "zlib.h", "fcntl.h", "sys/stat.h", "unistd.h"};
  static const Strings urdf{"Eigen/",          "urdf_parser/", "urdf_model/", "urdf_world/",
                            "urdf_exception/", "yaml-cpp/",    "tinyxml2.h",  "console_bridge/"};
  static const Strings tools{"Eigen/", "nlohmann/", "unistd.h", "yaml-cpp/"};
  static const Strings ompl{"Eigen/", "ompl/"};
  return layer == "aspects" ? aspects
         : layer == "urdf"  ? urdf
         : layer == "tools" ? tools
         : layer == "ompl"  ? ompl
                            : eigen;
}

bool is_optional(const std::string& layer) {
  return std::find(optional_layers.begin(), optional_layers.end(), layer) != optional_layers.end();
}

std::ptrdiff_t height(const std::string& room) {
  return std::find(rooms.begin(), rooms.end(), room) - rooms.begin();
}

bool is_layer(const std::string& name) {
  return std::any_of(rooms.begin(), rooms.end(),
                     [&](const std::string& room) { return layer_of(room) == name; });
}

// Where the source of a public header is, which is named as "LAYER/NAME.h".
std::string room_of_public(const fs::path& root, const fs::path& header) {
  const std::string layer = header.parent_path();
  const std::string source = header.stem().string() + ".cpp";
  std::string lowest;
  for (const std::string& room : rooms) {
    if (layer_of(room) != layer) continue;
    if (fs::exists(root / "src" / room / source)) return room;
    if (lowest.empty()) lowest = room;
  }
  return lowest;
}

// Empty for what is none of the package's own headers.
std::string room_of_include(const fs::path& root, const std::string& header) {
  static const std::string own = "parallel_aspects/";
  const bool is_public = starts_with(header, own);
  const fs::path path = is_public ? header.substr(own.size()) : header;
  if (is_public) return path.has_parent_path() ? room_of_public(root, path) : "";
  return fs::exists(root / "src" / path) ? path.parent_path().string() : "";
}

bool is_standard(const std::string& header) { return header.find_first_of("./") == std::string::npos; }

bool is_allowed(const fs::path& root, const std::string& room, const std::string& header) {
  const std::string other = room_of_include(root, header);
  const std::string layer = layer_of(room);
  if (!other.empty())
    return height(other) <= height(room) && (layer_of(other) == layer || !is_optional(layer_of(other)));
  const Strings& allowed = libraries(layer);
  return layer == "ros" || layer == "rviz" || is_standard(header) ||
         std::any_of(allowed.begin(), allowed.end(),
                     [&](const std::string& start) { return starts_with(header, start); });
}

// A file of data beside the source, which is checked like it.
bool is_neighbor(const fs::path& file, const std::string& header) {
  return header.find('/') == std::string::npos && fs::path(header).extension() == ".inc" &&
         fs::exists(file.parent_path() / header);
}

Strings includes_of(const fs::path& file) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::ifstream stream(file);
  Strings headers;
  std::smatch match;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_search(line, match, include)) headers.push_back(match[1]);
  return headers;
}

bool is_source(const fs::path& file) {
  static const Strings endings{".h", ".hpp", ".cpp", ".cc", ".cxx", ".ipp", ".inl"};
  return std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
}

// With those in the folders below.
std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> sources;
  if (!fs::exists(folder)) return sources;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_source(entry.path())) sources.push_back(entry.path());
  return sources;
}

std::string folder_of(const fs::path& file, const fs::path& root) {
  return file.parent_path().lexically_relative(root);
}

void check_file(const fs::path& root, const fs::path& file, const std::string& room, Strings& violations) {
  for (const std::string& header : includes_of(file))
    if (!is_allowed(root, room, header) && !is_neighbor(file, header))
      violations.push_back(file.string() + " in " + room + " includes " + header);
}

Strings violations_in(const fs::path& root) {
  Strings violations;
  for (const std::string& room : rooms)
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "src" / room))
      if (is_source(entry.path())) check_file(root, entry.path(), room, violations);
  const fs::path headers = root / "include" / "parallel_aspects";
  for (const fs::path& header : sources_in(headers))
    check_file(root, header, room_of_public(root, header.lexically_relative(headers)), violations);
  return violations;
}

// Sources in folders that are no rooms would escape the check.
Strings strays_in(const fs::path& root) {
  Strings strays;
  for (const fs::path& source : sources_in(root / "src"))
    if (height(folder_of(source, root / "src")) == height("")) strays.push_back(source);
  const fs::path headers = root / "include" / "parallel_aspects";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(headers))
    if (entry.is_regular_file() && !is_layer(folder_of(entry.path(), headers)) &&
        entry.path().parent_path() != headers)
      strays.push_back(entry.path());
  return strays;
}

// Tests that lie in no folder of test/ named as a room, or as a layer for what concerns all of it.
Strings stray_tests_in(const fs::path& root) {
  Strings strays;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "test")) {
    const std::string folder = folder_of(entry.path(), root / "test");
    const bool is_test = entry.path().stem().string().find("_test") != std::string::npos;
    if (is_test && entry.is_regular_file() && height(folder) == height("") && !is_layer(folder))
      strays.push_back(entry.path());
  }
  return strays;
}

// A test that is named as a source lies where that is.
Strings misplaced_tests_in(const fs::path& root) {
  std::map<std::string, std::string> room_of_source;
  const fs::path headers = root / "include" / "parallel_aspects";
  for (const fs::path& header : sources_in(headers))
    room_of_source[header.stem()] = room_of_public(root, header.lexically_relative(headers));
  for (const fs::path& source : sources_in(root / "src"))
    room_of_source[source.stem()] = folder_of(source, root / "src");
  Strings misplaced;
  for (const fs::path& test : sources_in(root / "test")) {
    const std::string stem = test.stem();
    const auto source = room_of_source.find(stem.substr(0, stem.rfind("_test")));
    if (stem.rfind("_test") == std::string::npos || source == room_of_source.end()) continue;
    if (folder_of(test, root / "test") != source->second)
      misplaced.push_back(test.string() + " tests a source of " + source->second);
  }
  return misplaced;
}

// Public headers are what clients compile: they include none that is private, and there are few of them.
Strings private_includes_in(const fs::path& root) {
  Strings found;
  for (const fs::path& file : sources_in(root / "include"))
    for (const std::string& header : includes_of(file))
      if (fs::exists(root / "src" / header)) found.push_back(file.string() + " includes " + header);
  return found;
}

// Where one kind of leg is looked for, the compiler does not ask for a new one.
Strings single_kinds_in(const fs::path& root) {
  static const std::regex single(R"((get|get_if|holds_alternative)<\w*Actuation>)");
  Strings found;
  for (const fs::path& source : sources_in(root / "src")) {
    std::ifstream stream(source);
    bool any = false;
    for (std::string line; std::getline(stream, line);) any = any || std::regex_search(line, single);
    if (any) found.push_back(source);
  }
  return found;
}

std::map<std::string, std::size_t> files_by_folder(const fs::path& folder) {
  std::map<std::string, std::size_t> counts;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) ++counts[entry.path().parent_path()];
  return counts;
}

// Names that are there twice make an #include, or an error message, name either.
Strings repeated_names_in(const fs::path& root) {
  std::map<std::string, std::size_t> counts;
  for (const fs::path& folder : {root / "src", root / "include"})
    for (const fs::path& source : sources_in(folder)) ++counts[source.filename()];
  Strings repeated;
  for (const auto& [name, count] : counts)
    if (count > 1) repeated.push_back(name);
  return repeated;
}

std::string listed(const Strings& items) {
  std::string text;
  for (const std::string& item : items) text += item + '\n';
  return text;
}

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

TEST(Layers, NoFolderHoldsTooManyFiles) {
  for (const char* folder : {"src", "include", "test/support"})
    for (const auto& [name, count] : files_by_folder(here / folder))
      EXPECT_LE(count, max_files_in_a_folder) << name;
}

TEST(Layers, NoTwoFilesHaveOneName) { EXPECT_EQ(repeated_names_in(here), Strings()); }

}  // namespace
