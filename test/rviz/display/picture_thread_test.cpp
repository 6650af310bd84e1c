// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/picture_thread.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"

namespace parallel_aspects {
namespace {

// Which the robot leaves a little until the next one is there.
TEST(ReceivedMap, AVolumeIsAskedForThePositionAtItsOwnOrientation) {
  const test::Robot robot = test::shipped("stewart")->mapped_manipulator();
  MapOptions options;
  options.slice.emplace();
  options.slice->moves = {true, true, true};
  options.modes = working_modes(*robot);
  options.resolution = 0.08 * robot->size();
  ReceivedMap received;
  received.map = test::map_of(robot, options);
  ASSERT_FALSE(received.map->aspects().empty());
  for (const Aspect& aspect : received.map->aspects()) {
    Pose pose = aspect.deepest;
    pose.orientation = Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitX()) * pose.orientation;
    EXPECT_EQ(received.locate(pose, aspect.mode), aspect.id);
    ReceivedMap sent = received;
    sent.bytes = 1;
    EXPECT_EQ(sent.locate(pose, aspect.mode), 0) << "a map that was sent is asked for the pose itself";
  }
}

}  // namespace
}  // namespace parallel_aspects
