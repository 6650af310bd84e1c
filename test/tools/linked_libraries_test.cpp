// SPDX-License-Identifier: BSD-3-Clause
// The command and the core are of use without ROS, so they link none of it.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

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

TEST(LinkedLibraries, RosLibrariesAreRecognised) {
  for (const char* name :
       {"libroscpp.so.4d", "librosconsole.so.3d", "libtf2_ros.so.1d", "liburdf.so.1d", "libtf2.so"})
    EXPECT_TRUE(is_ros_library(name)) << name;
  for (const char* name :
       {"liburdfdom_model.so.3.0", "libtbb.so.12", "libyaml-cpp.so.0.7", "libconsole_bridge.so.1.0"})
    EXPECT_FALSE(is_ros_library(name)) << name;
}

TEST(LinkedLibraries, TheCommandAndTheCoreHaveNoRos) {
  for (const std::string binary : {PARALLEL_ASPECTS_CORE_FILE, PARALLEL_ASPECTS_COMMAND_FILE}) {
    if (fs::path(binary).extension() == ".a") continue;
    const Strings needed = needed_libraries(binary);
    ASSERT_FALSE(needed.empty()) << "readelf told nothing of " << binary;
    for (const std::string& name : needed) EXPECT_FALSE(is_ros_library(name)) << binary << ' ' << name;
  }
}

}  // namespace
