// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/frame_watch.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Topic = FrameWatch::Topic;

const ros::WallTime noon(43200.0);

ros::WallTime after(double seconds) { return noon + ros::WallDuration(seconds); }

class FrameWatchTest : public testing::Test {
 protected:
  void hear(const std::string& frame, const std::string& publisher, double seconds = 0.0,
            Topic topic = Topic::tf) {
    watch_.hear(frame, publisher, topic, after(seconds));
  }
  std::size_t news(double seconds) { return watch_.news(after(seconds)).size(); }

  FrameWatch watch_{"left/", {"crank", "rod", "base_link"}};
};

TEST_F(FrameWatchTest, SaysOnceThatTwoNodesPublishAFrame) {
  hear("left/platform", "/left");
  EXPECT_EQ(watch_.message(noon), "");
  hear("left/platform", "/right", 0.1);
  hear("left/platform", "/left", 0.2);
  EXPECT_EQ(news(0.3), 0U) << "there may be more frames";
  const std::vector<std::string> said = watch_.news(after(1.2));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said.front().find("Both /left and /right publish the tf frame left/platform; "), 0U)
      << said.front();
  hear("left/platform", "/right", 1.3);
  EXPECT_EQ(news(9.0), 0U);
  EXPECT_NE(watch_.message(after(1.4)), "");
}

TEST_F(FrameWatchTest, SaysInOneLineWhatTwoNodesShare) {
  for (const char* frame : {"rod", "crank", "base_link"})
    for (const char* node : {"/right/robot_state_publisher", "/left/robot_state_publisher"})
      hear(frame, node);
  const std::vector<std::string> said = watch_.news(after(1.0));
  ASSERT_EQ(said.size(), 1U);
  for (const char* words :
       {"Both /left/robot_state_publisher and /right/robot_state_publisher publish 3 tf frames",
        "such as base_link", "frame_prefix"})
    EXPECT_NE(said.front().find(words), std::string::npos) << said.front();
  EXPECT_EQ(watch_.message(after(1.0)), said.front());
}

TEST_F(FrameWatchTest, LeavesFramesOfOtherRobotsToTheirMonitors) {
  hear("panda_hand", "/one");
  hear("panda_hand", "/two");
  EXPECT_EQ(news(2.0), 0U);
  EXPECT_EQ(watch_.message(noon), "");
}

TEST_F(FrameWatchTest, OneNodeMayPublishManyFramesAndOneMayTakeTheOthersPlace) {
  hear("crank", "/one");
  hear("rod", "/one");
  hear("base_link", "/two");
  hear("crank", "/two", 10.0);
  EXPECT_EQ(news(20.0), 0U);
}

TEST_F(FrameWatchTest, ADisputeEndsWhereOneOfTheNodesDoes) {
  hear("crank", "/one");
  hear("crank", "/two");
  hear("crank", "/two", 20.0);
  EXPECT_EQ(watch_.message(after(20.0)), "");
  hear("rod", "/one", 0.0, Topic::tf_static);
  hear("rod", "/two", 0.0, Topic::tf_static);
  EXPECT_NE(watch_.message(after(20.0)), "");  // nothing more is heard of static transforms
}

}  // namespace
}  // namespace parallel_aspects
