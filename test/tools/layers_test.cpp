// SPDX-License-Identifier: BSD-3-Clause
// The layers hold: includes point down only, and nothing below ros/ knows of ROS.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

// From the bottom to the top; each may include itself and those before it.
const Strings layers{"model",    "kinematics", "singularity", "aspects", "distance",
                     "tracking", "urdf",       "tools",       "ros"};

// What a layer below ros/ may include besides the standard library and lower layers.
const Strings& libraries(const std::string& layer) {
  static const Strings eigen{"Eigen/"};
  static const Strings aspects{"Eigen/", "tbb/", "zlib.h", "fcntl.h", "sys/stat.h", "unistd.h"};
  static const Strings urdf{"Eigen/",          "urdf_parser/", "urdf_model/", "urdf_world/",
                            "urdf_exception/", "yaml-cpp/",    "tinyxml2.h",  "console_bridge/"};
  static const Strings tools{"Eigen/", "nlohmann/", "unistd.h"};
  return layer == "aspects" ? aspects : layer == "urdf" ? urdf : layer == "tools" ? tools : eigen;
}

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

std::ptrdiff_t height(const std::string& layer) {
  return std::find(layers.begin(), layers.end(), layer) - layers.begin();
}

bool is_standard(const std::string& header) { return header.find_first_of("./") == std::string::npos; }

bool is_allowed(const std::string& layer, const std::string& header) {
  static const std::string own = "parallel_aspects/";
  if (starts_with(header, own)) {
    const std::string rest = header.substr(own.size());
    const auto slash = rest.find('/');
    return slash != std::string::npos && height(rest.substr(0, slash)) <= height(layer);
  }
  const Strings& allowed = libraries(layer);
  return is_standard(header) || std::any_of(allowed.begin(), allowed.end(), [&](const std::string& start) {
           return starts_with(header, start);
         });
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

void check_folder(const std::string& layer, const fs::path& folder, Strings& violations) {
  if (!fs::is_directory(folder)) return;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!is_source(entry.path())) continue;
    for (const std::string& header : includes_of(entry.path()))
      if (!is_allowed(layer, header) && !is_neighbor(entry.path(), header))
        violations.push_back(entry.path().string() + " includes " + header);
  }
}

Strings violations_in(const fs::path& root) {
  Strings violations;
  for (const std::string& layer : layers) {
    if (layer == "ros") continue;
    check_folder(layer, root / "include" / "parallel_aspects" / layer, violations);
    check_folder(layer, root / "src" / layer, violations);
  }
  return violations;
}

// Sources directly in src/ or in an unknown layer would escape the check.
Strings strays_in(const fs::path& root) {
  Strings strays;
  for (const fs::path& folder : {root / "include" / "parallel_aspects", root / "src"})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (!entry.is_directory() || height(entry.path().filename().string()) == height(""))
        strays.push_back(entry.path());
  return strays;
}

std::string listed(const Strings& items) {
  std::string text;
  for (const std::string& item : items) text += item + '\n';
  return text;
}

Strings needed_libraries(const std::string& binary) {
  const std::string command = "LC_ALL=C readelf -d '" + binary + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  static const std::regex needed(R"(\(NEEDED\).*\[(.+)\])");
  std::array<char, 4096> line{};
  Strings names;
  std::cmatch match;
  while (pipe && std::fgets(line.data(), line.size(), pipe.get()) != nullptr)
    if (std::regex_search(line.data(), match, needed)) names.push_back(match[1]);
  return names;
}

bool is_ros_library(const std::string& name) {
  static const std::regex ros(
      "lib(ros|cpp_common|tf|actionlib|nodelet|bondcpp|pluginlib|class_loader|message_filters|diagnostic|"
      "dynamic_reconfigure|xmlrpcpp|kdl_parser|urdf\\.|rviz|interactive_markers|parallel_aspects_ros|.*_msgs)"
      ".*");
  return std::regex_match(name, ros);
}

// An empty tree in a folder of its own, gone at the end of the test.
class PlantedTree : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "layers_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = pattern;
    for (const std::string& layer : layers) {
      fs::create_directories(root_ / "src" / layer);
      fs::create_directories(root_ / "include" / "parallel_aspects" / layer);
    }
  }
  void TearDown() override { fs::remove_all(root_); }

  void plant(const std::string& file, const std::string& line) {
    std::ofstream(root_ / file) << line << '\n';
  }

  fs::path root_;
};

TEST_F(PlantedTree, DownwardIncludesPass) {
  plant("src/tools/a.cpp",
        "#include \"parallel_aspects/model/leg.h\"\n#include <vector>\n#include <nlohmann/json.hpp>");
  plant("src/ros/a.cpp", "#include <ros/ros.h>");
  EXPECT_EQ(violations_in(root_), Strings());
}

TEST_F(PlantedTree, UpwardIncludesAreFound) {
  plant("include/parallel_aspects/model/a.h", "#include \"parallel_aspects/kinematics/inverse.h\"");
  plant("src/aspects/a.cpp", "  #  include <parallel_aspects/urdf/mechanism.h>");
  EXPECT_EQ(violations_in(root_).size(), 2U);
}

TEST_F(PlantedTree, RosBelowRosIsFound) {
  plant("src/tools/a.cpp", "#include <ros/ros.h>");
  plant("src/urdf/a.cpp", "#include <urdf/model.h>");
  plant("src/tracking/a.cpp", "#include \"parallel_aspects/State.h\"");
  plant("src/model/a.hpp", "#include <geometry_msgs/Pose.h>");
  EXPECT_EQ(violations_in(root_).size(), 4U);
}

TEST_F(PlantedTree, StraySourcesAreFound) {
  EXPECT_EQ(strays_in(root_), Strings());
  plant("src/a.cpp", "");
  fs::create_directories(root_ / "include" / "parallel_aspects" / "util");
  EXPECT_EQ(strays_in(root_).size(), 2U);
}

TEST(Layers, IncludesPointDown) {
  const Strings violations = violations_in(PARALLEL_ASPECTS_SOURCE_DIR);
  EXPECT_TRUE(violations.empty()) << listed(violations);
}

TEST(Layers, EverySourceIsInALayer) {
  const Strings strays = strays_in(PARALLEL_ASPECTS_SOURCE_DIR);
  EXPECT_TRUE(strays.empty()) << listed(strays);
}

TEST(Layers, RosLibrariesAreRecognised) {
  for (const char* name :
       {"libroscpp.so.4d", "librosconsole.so.3d", "libtf2_ros.so.1d", "liburdf.so.1d", "libtf2.so"})
    EXPECT_TRUE(is_ros_library(name)) << name;
  for (const char* name :
       {"liburdfdom_model.so.3.0", "libtbb.so.12", "libyaml-cpp.so.0.7", "libconsole_bridge.so.1.0"})
    EXPECT_FALSE(is_ros_library(name)) << name;
}

TEST(Layers, TheCommandAndTheCoreLinkNoRos) {
  for (const std::string binary : {PARALLEL_ASPECTS_CORE_FILE, PARALLEL_ASPECTS_COMMAND_FILE}) {
    if (fs::path(binary).extension() == ".a") continue;
    const Strings needed = needed_libraries(binary);
    ASSERT_FALSE(needed.empty()) << "readelf told nothing of " << binary;
    for (const std::string& name : needed) EXPECT_FALSE(is_ros_library(name)) << binary << ' ' << name;
  }
}

}  // namespace
