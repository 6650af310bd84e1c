// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"
#include "ros/node/aspect_server.h"

#include <ros/console.h>
#include <ros/init.h>

#include <cstdlib>

int main(int argc, char** argv) {
  ros::init(argc, argv, "aspect_node");
  const ros::NodeHandle nh, private_nh("~");  // the log ends with the last of its handles
  try {
    const parallel_aspects::AspectServer server(nh, private_nh);
    ros::spin();
  } catch (const parallel_aspects::InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems()) ROS_FATAL_STREAM(problem);
    return EXIT_FAILURE;
  }
}
