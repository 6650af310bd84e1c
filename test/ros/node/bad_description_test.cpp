// SPDX-License-Identifier: BSD-3-Clause
//
// Starts the node with bad parameters: it must end by itself, with a status that says failure and every
// problem in a message, and must not have advertised anything.
#include "ros/monitor/five_bar_setup.h"

#include <gtest/gtest.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/param.h>

#include "support/robots/shipped.h"
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace parallel_aspects {
namespace {

struct Ending {
  int status = 0;  ///< of the process; 124 when it did not end in time
  std::string output;
};

// Runs the node in a namespace of its own until it ends, at most a minute.
Ending run_node(const std::string& name_space) {
  const std::string command =
      "timeout --kill-after=5 60 " PARALLEL_ASPECTS_NODE " __ns:=" + name_space + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  Ending ending;
  std::array<char, 4096> buffer;
  while (pipe != nullptr && fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr)
    ending.output += buffer.data();
  const int status = pipe != nullptr ? pclose(pipe) : -1;
  ending.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ending;
}

void expect_refused(const std::string& name_space, const std::vector<std::string>& words) {
  const Ending ending = run_node(name_space);
  EXPECT_EQ(ending.status, EXIT_FAILURE) << ending.output;
  for (const std::string& word : words)
    EXPECT_NE(ending.output.find(word), std::string::npos) << "'" << word << "' is not in:\n"
                                                           << ending.output;
}

void set_good_urdf(const std::string& name_space) {
  ros::param::set(name_space + "/robot_description", test::source_file("urdf/five_bar.urdf"));
}

TEST(BadDescription, NothingIsThere) {
  expect_refused("/nothing",
                 {"robot_description is not there", "/nothing/aspect_node/mechanism is not there"});
}

TEST(BadDescription, TheUrdfIsEmpty) {
  for (const char* blank : {"", "   "}) {
    ros::param::set("/empty/robot_description", blank);
    ros::param::set("/empty/aspect_node/mechanism", test::five_bar_mechanism_parameter());
    expect_refused("/empty", {"/empty/robot_description is empty or missing"});
  }
}

TEST(BadDescription, TheUrdfIsANumber) {
  ros::param::set("/number/robot_description", 7);
  ros::param::set("/number/aspect_node/mechanism", test::five_bar_mechanism_parameter());
  expect_refused("/number", {"/number/robot_description is not text"});
}

TEST(BadDescription, TheUrdfIsNotXml) {
  ros::param::set("/not_xml/robot_description", "five_bar.urdf");
  ros::param::set("/not_xml/aspect_node/mechanism", test::five_bar_mechanism_parameter());
  expect_refused("/not_xml", {"/not_xml/robot_description"});
}

TEST(BadDescription, TheClosureNamesAnUnknownLink) {
  set_good_urdf("/unknown_link");
  XmlRpc::XmlRpcValue mechanism = test::five_bar_mechanism_parameter();
  mechanism["closures"][0]["frames"][1] = "closing_3";
  ros::param::set("/unknown_link/aspect_node/mechanism", mechanism);
  expect_refused("/unknown_link", {"/unknown_link/aspect_node names link", "closing_3"});
}

TEST(BadDescription, TheConstraintsAreANumber) {
  set_good_urdf("/constraints");
  ros::param::set("/constraints/aspect_node/mechanism", test::five_bar_mechanism_parameter());
  ros::param::set("/constraints/aspect_node/constraints", 7);
  expect_refused("/constraints", {"/constraints/aspect_node has a 'constraints' that is not a map",
                                  "actuated_limits, passive_limits"});
}

TEST(BadDescription, EveryProblemIsSaidAtOnce) {
  set_good_urdf("/many");
  XmlRpc::XmlRpcValue mechanism = test::five_bar_mechanism_parameter();
  mechanism["actuated_joints"][0] = "crank_7_joint";
  ros::param::set("/many/aspect_node/mechanism", mechanism);
  ros::param::set("/many/aspect_node/map/resolution", "fine");
  ros::param::set("/many/aspect_node/joint_state_timeout", 0.5);
  expect_refused("/many", {"crank_7_joint", "/many/aspect_node/map/resolution must be a number",
                           "/many/aspect_node/joint_state_timeout is not known"});
}

TEST(BadDescription, AnOptionIsOutOfRange) {
  set_good_urdf("/range");
  ros::param::set("/range/aspect_node/mechanism", test::five_bar_mechanism_parameter());
  ros::param::set("/range/aspect_node/start/pose", std::vector<double>{1.0, 2.0, 3.0});
  ros::param::set("/range/aspect_node/joint_states_timeout", -1.0);
  expect_refused("/range", {"start/pose must be a list of finite numbers [x, y]",
                            "/range/aspect_node/joint_states_timeout must be a positive number"});
}

// Of several nodes in one terminal.
TEST(BadDescription, NothingWasAdvertised) {
  ros::master::V_TopicInfo topics;
  ASSERT_TRUE(ros::master::getTopics(topics));
  for (const auto& topic : topics) EXPECT_EQ(topic.name.find("aspect_node"), std::string::npos) << topic.name;
}

}  // namespace
}  // namespace parallel_aspects
