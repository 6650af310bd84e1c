// SPDX-License-Identifier: BSD-3-Clause
//
// Becomes rviz, with a view that fits the robot that aspect_node was given. Parameters: ~server (name of that
// node), ~config (rviz configuration file, of which the view is replaced).
#include "ros/programs/rviz_view.h"

#include <ros/ros.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

std::optional<std::string> text_of(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

// In a file that rviz finds at its start and may keep.
std::optional<std::string> saved(const std::string& text) {
  std::string path = "/tmp/parallel_aspects_XXXXXX.rviz";
  const int file = mkstemps(path.data(), 5);
  if (file < 0) return std::nullopt;
  close(file);
  std::ofstream stream(path);
  stream << text;
  stream.close();
  return stream ? std::make_optional(path) : std::nullopt;
}

std::optional<std::string> prepare(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh) {
  const std::string config = private_nh.param<std::string>("config", "");
  const auto text = text_of(config);
  if (!text) {
    ROS_FATAL_STREAM("The file '" << config << "' that parameter config names cannot be read.");
    return std::nullopt;
  }
  try {
    const auto server = private_nh.param<std::string>("server", "aspect_node");
    const auto path = saved(
        parallel_aspects::with_view_of(*text, parallel_aspects::load_setup(nh, ros::NodeHandle(server))));
    if (!path) ROS_FATAL_STREAM("No file can be written in /tmp: " << std::strerror(errno));
    return path;
  } catch (const parallel_aspects::InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems()) ROS_FATAL_STREAM(problem);
  } catch (const std::exception& failure) {
    ROS_FATAL_STREAM("The file '" << config << "' is not an rviz configuration: " << failure.what());
  }
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);  // before ros::init takes some of them
  std::optional<std::string> path;
  {
    ros::init(argc, argv, "rviz");
    const ros::NodeHandle nh, private_nh("~");
    path = prepare(nh, private_nh);
    ros::shutdown();
  }
  if (!path) return EXIT_FAILURE;
  std::string program = "rviz", option = "-d";
  arguments[0] = program.data();
  arguments.insert(arguments.begin() + 1, {option.data(), path->data()});
  arguments.push_back(nullptr);
  execvp("rviz", arguments.data());
  std::perror("rviz cannot be started");
  return EXIT_FAILURE;
}
