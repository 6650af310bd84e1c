// SPDX-License-Identifier: BSD-3-Clause
//
// What a node says at its start of a threshold that lies inside the stand-off, and where none is set.
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"
#include "ros/node/process.h"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace parallel_aspects {
namespace {

constexpr const char* stand_off = "the assembly mode can be determined as near as";
constexpr const char* offer = "No threshold is set; for example thresholds: {parallel_stop: ";
constexpr const char* warning = "the level may become UNKNOWN before it is STOP";

// Lines of information are not flushed one by one into a file unless stdbuf sees to it.
/// All that a node of the five-bar says until it has ended, which it is asked to once it has said what is
/// awaited.
std::string said_with(const std::string& name_space, double parallel_stop, const std::string& awaited) {
  ros::param::set(name_space + "/robot_description", test::source_file("urdf/five_bar.urdf"));
  const std::string node = name_space + "/aspect_node/";
  ros::param::set(node + "mechanism", test::five_bar_mechanism_parameter());
  ros::param::set(node + "map/resolution", 0.2);
  ros::param::set(node + "thresholds/parallel_stop", parallel_stop);
  const std::string file = std::filesystem::temp_directory_path() / ("said" + std::to_string(getpid()));
  const auto said = [&file] {
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  test::Process process(
      "/bin/sh", "",
      {"-c", "exec stdbuf -oL " PARALLEL_ASPECTS_NODE " __ns:=" + name_space + " > " + file + " 2>&1"});
  EXPECT_TRUE(test::eventually([&] { return said().find(awaited) != std::string::npos; })) << said();
  EXPECT_EQ(process.end(), 0);
  const std::string all = said();
  std::filesystem::remove(file);
  return all;
}

TEST(StandOffWarning, IsSaidWhereAThresholdLiesInside) {
  const std::string said = said_with("/inside", 1e-4, warning);
  EXPECT_NE(said.find("thresholds/parallel_stop is 0.0001 m, but nearer than about"), std::string::npos)
      << said;
  EXPECT_NE(said.find(stand_off), std::string::npos) << said;
}

TEST(StandOffWarning, IsNotSaidOtherwise) {
  EXPECT_EQ(said_with("/outside", 5.0, stand_off).find(warning), std::string::npos);
}

TEST(StandOffWarning, WithoutAThresholdSomeAreOffered) {
  const std::string said = said_with("/none", 0.0, offer);
  EXPECT_EQ(said.find(warning), std::string::npos) << said;
  EXPECT_EQ(said_with("/some", 5.0, stand_off).find(offer), std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "stand_off_warning_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
