// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/rotation_slice.h"

#include "aspects/tree/slice_space.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Held;
using test::orientation_of;
using test::Robot;
using test::upright;

TEST(RotationSlice, TurnsAboutAxesOfTheBaseAndOfThePlatform) {
  const Robot robot = test::shipped("stewart")->manipulator();
  Problems problems;
  const Held held{{"x", 0.0}, {"y", 0.0}, {"z", 1.3}, {"roll", 0.3}, {"pitch", 0.2}, {"yaw", 0.1}};
  const MapSlice base = make_rotation_slice(TaskSpace::SE3, held, "y", problems);
  const MapSlice own = make_rotation_slice(TaskSpace::SE3, held, "own-z", problems);
  ASSERT_TRUE(problems.empty());
  EXPECT_EQ(find_slice_problem(*robot, own), "");
  const Eigen::Quaterniond start = orientation_of(0.3, 0.2, 0.1);
  const MapPosition quarter{0, {0.5, 0.0, 0.0}};
  const Pose about_base = make_slice_space(base, Box{}, 1.0)->pose(quarter);
  const Pose about_own = make_slice_space(own, Box{}, 1.0)->pose(quarter);
  const Eigen::Quaterniond y(Eigen::AngleAxisd(0.5 * EIGEN_PI, Eigen::Vector3d::UnitY()));
  const Eigen::Quaterniond z(Eigen::AngleAxisd(0.5 * EIGEN_PI, Eigen::Vector3d::UnitZ()));
  EXPECT_LT(about_base.orientation.angularDistance(y * start), 1e-7);
  EXPECT_LT(about_own.orientation.angularDistance(start * z), 1e-7);
  EXPECT_EQ(coordinate_names(own), std::vector<std::string>{"phi"});
  EXPECT_EQ(measure_unit(own), "rad");
}

std::string rotation_problem(TaskSpace space, const Held& held, const std::string& axis) {
  Problems problems;
  make_rotation_slice(space, held, axis, problems);
  return problems.size() == 1 ? problems.front() : std::to_string(problems.size()) + " problems";
}

TEST(RotationSlice, EveryMistakeIsOneSentence) {
  EXPECT_EQ(
      rotation_problem(TaskSpace::SE3, upright({{"x", 0.0}}), "w"),
      "The slice turns about 'w'; give x, y or z of the base, or own-x, own-y or own-z of the platform.");
  EXPECT_EQ(rotation_problem(TaskSpace::SE3, {{"x", 0.0}, {"y", 0.0}, {"roll", 0.0}}, "x"),
            "The slice turns from an orientation that it does not state; hold 'pitch' once.");
  EXPECT_EQ(rotation_problem(TaskSpace::SE2, {{"x", 0.0}}, "z"),
            "A slice of SE2 turns about no other axis; leave 'turn' out.");
  EXPECT_NE(rotation_problem(TaskSpace::SE3, upright(), "x"), "0 problems");
}

}  // namespace
}  // namespace parallel_aspects
