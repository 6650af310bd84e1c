// SPDX-License-Identifier: BSD-3-Clause
#include "ask/question_parts.h"
#include "model/message_text.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <sstream>
#include <string>

namespace parallel_aspects::ask {
namespace {

using test::Held;
using test::Robot;

struct Placed {
  Pose pose;
  double moved = 0.0;
  ProblemList problems;
};

/// The pose that this text gives, on the slice.
Placed placed(const Robot& robot, const Held& held, const std::string& text) {
  std::istringstream stream(text);
  PoseCoordinates numbers(static_cast<Eigen::Index>(coordinate_names(robot->task_space()).size()));
  for (Eigen::Index i = 0; i < numbers.size(); ++i) stream >> numbers[i];
  Placed result;
  result.pose = pose_from_coordinates(robot->motions(), numbers).value();
  result.moved = put_onto_slice(test::slice_of(robot, held), *robot, "start", result.pose, result.problems);
  return result;
}

TEST(SliceEnds, TakesPosesOfTablesWithAJointHeld) {
  const Robot robot = test::three_rpr();
  const AnchorCircle circle = circle_of_anchor(*robot, {0, 14.98, false});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-EIGEN_PI, EIGEN_PI);
  double most = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const Pose pose = circle.pose(angle(random), angle(random));
    const Placed found = placed(robot, {{"leg_1_joint", 14.98}}, pose_numbers(robot->task_space(), pose));
    ASSERT_TRUE(found.problems.empty()) << found.problems.front().fault;
    EXPECT_LE(std::abs(circle.distance(found.pose)), 1e-12);
    EXPECT_LE((found.pose.position - pose.position).norm(), 1e-3);
    most = std::max(most, found.moved);
  }
  EXPECT_GT(most, held_joint_tolerance);  // so that rounding is what was asked for
}

TEST(SliceEnds, TakesPosesOfTablesInOtherSlices) {
  const Robot robot = test::stewart();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Held held{{"roll", number(random)}, {"pitch", 0.2}, {"yaw", -0.3}};
    Pose pose = test::slice_of(robot, held).held;
    pose.position = {number(random), number(random), number(random)};
    const Placed found = placed(robot, held, pose_numbers(robot->task_space(), pose));
    EXPECT_TRUE(found.problems.empty()) << found.problems.front().fault;
  }
}

/// How far a pose is turned about another axis than that of the slice, as half a sine.
double turned_aside(const MapSlice& slice, const Pose& pose) {
  const Eigen::Vector3d turn = (pose.orientation * slice.held.orientation.conjugate()).vec();
  return (turn - turn.dot(slice.axis) * slice.axis).norm();
}

TEST(SliceEnds, TakesPosesOfTablesWithAnAngleFree) {
  const Robot robot = test::stewart();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  double most = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Held held{{"x", 0.1}, {"y", 0.0}, {"roll", number(random)}, {"yaw", number(random)}};
    const MapSlice slice = test::slice_of(robot, held);
    Pose pose = slice.held;
    pose.position.z() = number(random);
    pose.orientation = Eigen::AngleAxisd(3.0 * number(random), slice.axis) * slice.held.orientation;
    const Placed found = placed(robot, held, pose_numbers(robot->task_space(), pose));
    EXPECT_TRUE(found.problems.empty()) << found.problems.front().fault;
    EXPECT_LE(turned_aside(slice, found.pose), 1e-9);
    EXPECT_LE(found.pose.orientation.angularDistance(pose.orientation), 1e-4);
    most = std::max(most, found.moved);
  }
  EXPECT_GT(most, 1e-9);
}

void expect_named_pose_is_taken(const Robot& robot, const Held& held, const std::string& pose) {
  const Placed off = placed(robot, held, pose);
  ASSERT_EQ(off.problems.size(), 1U);
  const std::string& message = off.problems.front().remedy;
  const std::string words = "The nearest in the task frame is \"";
  const std::size_t begin = message.find(words) + words.size(), end = message.find('"', begin);
  ASSERT_NE(end, std::string::npos) << message;
  const Placed again = placed(robot, held, message.substr(begin, end - begin));
  EXPECT_TRUE(again.problems.empty()) << message;
  EXPECT_LE(again.moved, held_joint_tolerance);
}

TEST(SliceEnds, NamesAPoseThatIsTaken) {
  expect_named_pose_is_taken(test::three_rpr(), {{"leg_1_joint", 15.0}},
                             "-14.89612810 1.58296166 0.24530953");
  expect_named_pose_is_taken(test::stewart(), {{"x", 0.0}, {"y", 0.0}, {"roll", 0.0}, {"yaw", 0.0}},
                             "0.1 0 1.3 0.1 0.2 0 0.9746794345");
}

// A frame that is far off leaves few digits to where the robot is.
TEST(SliceEnds, RefusesPosesThatAreFarOffForTheRobot) {
  const Robot robot = test::delta();
  EXPECT_TRUE(placed(robot, {{"z", -0.6}}, "0.1 0.2 -0.600001").problems.empty());
  EXPECT_FALSE(placed(robot, {{"z", -0.6}}, "0.1 0.2 -0.60001").problems.empty());
  EXPECT_FALSE(placed(robot, {{"z", 1e6}}, "0.1 0.2 1000001").problems.empty());
}

}  // namespace
}  // namespace parallel_aspects::ask
