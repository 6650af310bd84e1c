// SPDX-License-Identifier: BSD-3-Clause
//
// Main of the tests of the running node.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include "main/tests_of_file.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  parallel_aspects::test::choose_tests_of_file(argc, argv);
  ros::init(argc, argv, "node_test");  // rostest gives it the name of the test
  const ros::NodeHandle nh;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
