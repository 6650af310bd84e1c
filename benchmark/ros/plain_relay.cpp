// SPDX-License-Identifier: BSD-3-Clause
//
// The least that a node can do between two topics: what the latency of the node is compared with.
#include <ros/ros.h>

#include <sensor_msgs/JointState.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "plain_relay");
  ros::NodeHandle nh;
  const ros::Publisher out = nh.advertise<sensor_msgs::JointState>("relayed", 100);
  const ros::Subscriber in = nh.subscribe<sensor_msgs::JointState>(
      "to_relay", 1000, [&](const sensor_msgs::JointState::ConstPtr& message) { out.publish(message); },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  ros::spin();
}
