// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/frame_watch.h"

#include <gtest/gtest.h>

namespace parallel_aspects {
namespace {

using Topic = FrameWatch::Topic;

const ros::WallTime noon(43200.0);

ros::WallTime after(double seconds) { return noon + ros::WallDuration(seconds); }

TEST(FrameWatch, SaysOnceThatTwoNodesPublishAFrame) {
  FrameWatch watch("left/");
  EXPECT_EQ(watch.hear("left/platform", "/left", Topic::tf, noon), "");
  EXPECT_EQ(watch.message(noon), "");
  EXPECT_EQ(
      watch.hear("left/platform", "/right", Topic::tf, after(0.1)),
      "Both /left and /right publish the tf frame left/platform; give one of them another frame_prefix.");
  EXPECT_EQ(watch.hear("left/platform", "/left", Topic::tf, after(0.2)), "");
  EXPECT_NE(watch.message(after(0.3)), "");
}

TEST(FrameWatch, TellsFramesOfOthersFromItsOwn) {
  FrameWatch watch("left/");
  watch.hear("crank", "/left/robot_state_publisher", Topic::tf, noon);
  EXPECT_EQ(watch.hear("crank", "/right/robot_state_publisher", Topic::tf, noon),
            "Both /left/robot_state_publisher and /right/robot_state_publisher publish the tf frame crank; "
            "stop one of "
            "them, or rename the links of one robot.");
}

TEST(FrameWatch, OneNodeMayPublishManyFramesAndOneMayTakeTheOthersPlace) {
  FrameWatch watch("left/");
  EXPECT_EQ(watch.hear("a", "/one", Topic::tf, noon), "");
  EXPECT_EQ(watch.hear("b", "/one", Topic::tf, noon), "");
  EXPECT_EQ(watch.hear("c", "/two", Topic::tf, noon), "");
  EXPECT_EQ(watch.hear("a", "/two", Topic::tf, after(10.0)), "");
}

TEST(FrameWatch, ADisputeEndsWhereOneOfTheNodesDoes) {
  FrameWatch watch("left/");
  watch.hear("a", "/one", Topic::tf, noon);
  watch.hear("a", "/two", Topic::tf, noon);
  watch.hear("a", "/two", Topic::tf, after(20.0));
  EXPECT_EQ(watch.message(after(20.0)), "");
  watch.hear("b", "/one", Topic::tf_static, noon);
  watch.hear("b", "/two", Topic::tf_static, noon);
  EXPECT_NE(watch.message(after(20.0)), "");  // nothing more is heard of static transforms
}

}  // namespace
}  // namespace parallel_aspects
