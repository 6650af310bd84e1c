// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/ros/aspect_server.h"

#include <ros/console.h>
#include <ros/init.h>

#include <cstdlib>

int main(int argc, char** argv) {
  ros::init(argc, argv, "aspect_node");
  try {
    const parallel_aspects::AspectServer server(ros::NodeHandle{}, ros::NodeHandle{"~"});
    ros::spin();
  } catch (const parallel_aspects::InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems()) ROS_FATAL_STREAM(problem);
    return EXIT_FAILURE;
  }
}
