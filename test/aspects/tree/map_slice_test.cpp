// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/map_slice.h"

#include "aspects/tree/slice_space.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <cmath>
#include <functional>
#include <map>
#include <string>

namespace parallel_aspects {
namespace {

using test::Held;
using test::orientation_of;
using test::Robot;
using test::slice_of;
using test::upright;

// A free roll, pitch or yaw turns about the axis that it should.
TEST(MapSlice, FreeAnglesAreThoseOfTheOrientation) {
  const std::map<std::string, std::function<Eigen::Quaterniond(double)>> expected{
      {"roll", [](double t) { return orientation_of(t, 0.2, 0.1); }},
      {"pitch", [](double t) { return orientation_of(0.3, t, 0.1); }},
      {"yaw", [](double t) { return orientation_of(0.3, 0.2, t); }}};
  for (const auto& [free, orientation] : expected) {
    Held held;
    for (const HeldCoordinate& each :
         Held{{"x", 0.0}, {"y", 0.0}, {"z", 1.0}, {"roll", 0.3}, {"pitch", 0.2}, {"yaw", 0.1}})
      if (each.name != free) held.push_back(each);
    Problems problems;
    const auto space = make_slice_space(make_slice(TaskSpace::SE3, held, problems), Box{}, 1.0);
    for (const double half_turns : {-0.7, -0.2, 0.0, 0.1, 0.9})
      EXPECT_LT(space->pose({0, {half_turns, 0.0, 0.0}})
                    .orientation.angularDistance(orientation(half_turns * EIGEN_PI)),
                1e-7)
          << free << " " << half_turns;
  }
}

std::string problem_of(TaskSpace space, const Held& held) {
  Problems problems;
  make_slice(space, held, problems);
  return problems.size() == 1 ? problems.front() : std::to_string(problems.size()) + " problems";
}

TEST(MapSlice, EveryMistakeIsOneSentence) {
  EXPECT_EQ(problem_of(TaskSpace::T3, {{"phi", 0.0}}),
            "A slice of T3 has no coordinate 'phi'; hold some of x, y and z.");
  EXPECT_EQ(problem_of(TaskSpace::T3, {{"z", 0.0}, {"z", 1.0}}), "The slice holds 'z' twice; leave one out.");
  EXPECT_EQ(problem_of(TaskSpace::T3, {{"z", NAN}}), "The slice holds 'z' at no finite number; give one.");
  EXPECT_EQ(problem_of(TaskSpace::SE2, {}),
            "The slice holds nothing; hold some of x, y and phi, such as \"phi=0\".");
  EXPECT_EQ(problem_of(TaskSpace::T2, {{"x", 0.0}, {"y", 1.0}}),
            "The slice leaves no coordinate free; leave one to three.");
  EXPECT_EQ(problem_of(TaskSpace::SE3, {{"x", 0.0}, {"roll", 1.0}}),
            "The slice leaves y, z, pitch and yaw free; leave one to three.");
  EXPECT_EQ(problem_of(TaskSpace::SE3, {{"x", 0.0}, {"y", 0.0}, {"z", 1.0}, {"yaw", 0.0}}),
            "The slice leaves the angles roll and pitch free; hold all of them but one, or let all three "
            "turn with x, y and z held.");
  EXPECT_EQ(problem_of(TaskSpace::T1, {{"x", 0.0}}),
            "T1 has no slices, since x is all there is; map it whole.");
}

std::string problem_of(const Robot& robot, const Held& held) {
  Problems problems;
  make_slice(*robot, held, problems);
  return problems.size() == 1 ? problems.front() : std::to_string(problems.size()) + " problems";
}

TEST(MapSlice, HoldsAnActuatedJoint) {
  const MapSlice slice = slice_of(test::three_rpr(), {{"leg_2_joint", 20.0}});
  ASSERT_TRUE(slice.joint);
  EXPECT_EQ(slice.joint->leg, 1U);
  EXPECT_EQ(slice.dimension(), 2U);
  EXPECT_EQ(slice.free_positions(), 0U);
  EXPECT_EQ(to_string(slice), "leg_2_joint = 20 m");
  EXPECT_EQ(to_string(slice_of(test::three_rrr(), {{"leg_1_joint", 0.5}})), "leg_1_joint = 0.5 rad");
  EXPECT_EQ(find_slice_problem(*test::three_rpr(), slice), "");
  MapSlice both = slice;
  both.moves[0] = true;
  EXPECT_NE(find_slice_problem(*test::three_rpr(), both), "");
  both = slice;
  both.joint->leg = 3;
  EXPECT_NE(find_slice_problem(*test::three_rpr(), both), "");
  EXPECT_EQ(problem_of(test::three_rrr(), {{"phi", 0.0}}), "0 problems");
}

TEST(MapSlice, JointsThatCanNotBeHeldAreRefused) {
  EXPECT_EQ(problem_of(test::three_rpr(), {{"leg_4_joint", 20.0}}),
            "'three_rpr' has no pose coordinate or actuated joint 'leg_4_joint'; hold some of x, y and phi, "
            "or one of leg_1_joint, leg_2_joint or leg_3_joint.");
  EXPECT_EQ(problem_of(test::three_rpr(), {{"leg_1_joint", 20.0}, {"phi", 0.0}}),
            "The slice holds the joint 'leg_1_joint' and more; hold that joint alone, or pose coordinates.");
  EXPECT_EQ(problem_of(test::three_rpr(), {{"leg_1_joint", 9.0}}),
            "The slice holds 'leg_1_joint' at 9, outside of its limits, 10 to 32; hold it inside.");
  EXPECT_EQ(problem_of(test::three_rpr(), {{"leg_1_joint", NAN}}),
            "The slice holds 'leg_1_joint' at no finite number; give one.");
  EXPECT_EQ(problem_of(test::five_bar(), {{"leg_1_joint", 0.5}}),
            "A slice of T2 can hold pose coordinates only; joints can be held in SE2.");
  EXPECT_EQ(problem_of(test::three_rrr_actuated_elbow(), {{"leg_1_joint", 0.5}}),
            "The slice holds 'leg_1_joint', which is an actuated elbow; hold the joint of a crank, slide or "
            "strut.");
  ManipulatorDescription free = test::three_rpr()->description();
  free.legs[0].limits = JointLimits{};
  EXPECT_EQ(
      problem_of(std::make_shared<const Manipulator>(free), {{"leg_1_joint", 0.0}}),
      "The slice holds 'leg_1_joint' at 0, where its leg has no length in the plane; give another value.");
}

// An angle that is inside of its limits after some turns is refused with the value to hold, which is taken.
TEST(MapSlice, RefusesAnAngleThatIsTurnsAwayWithTheValueToHold) {
  ManipulatorDescription limited = test::three_rrr()->description();
  limited.legs[0].limits = JointLimits{4.8, 8.2};
  const auto robot = std::make_shared<const Manipulator>(limited);
  EXPECT_EQ(problem_of(robot, {{"leg_1_joint", -0.25}}),
            "The slice holds 'leg_1_joint' at -0.25, outside of its limits, 4.8 to 8.2; hold it inside, as "
            "at 6.03318530718, the same angle.");
  EXPECT_EQ(problem_of(robot, {{"leg_1_joint", 6.03318530718}}), "0 problems");
  EXPECT_EQ(problem_of(robot, {{"leg_1_joint", 4.0}}),
            "The slice holds 'leg_1_joint' at 4, outside of its limits, 4.8 to 8.2; hold it inside.");
}

TEST(MapSlice, SlicesThatDoNotFitTheRobotAreRefused) {
  const Robot planar = test::three_rrr(), spatial = test::stewart(), delta = test::delta();
  MapSlice slice = slice_of(planar, {{"phi", 0.0}});
  EXPECT_EQ(find_slice_problem(*planar, slice), "");
  slice.moves[2] = true;
  EXPECT_NE(find_slice_problem(*planar, slice), "");
  slice = slice_of(planar, {{"x", 0.0}});
  slice.axis = Eigen::Vector3d::UnitX();
  EXPECT_NE(find_slice_problem(*planar, slice), "");
  slice = slice_of(delta, {{"z", 0.0}});
  slice.held.orientation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
  EXPECT_NE(find_slice_problem(*delta, slice), "");
  slice = slice_of(spatial, upright());
  slice.held.position.x() = NAN;
  EXPECT_NE(find_slice_problem(*spatial, slice), "");
  slice = slice_of(spatial, upright());
  slice.axis.setZero();
  EXPECT_NE(find_slice_problem(*spatial, slice), "");
  slice = slice_of(spatial, upright());
  slice.rotation = MapSlice::Rotation::freely;
  EXPECT_NE(find_slice_problem(*spatial, slice), "");
  slice.moves.fill(false);
  slice.rotation = MapSlice::Rotation::none;
  EXPECT_NE(find_slice_problem(*spatial, slice), "");
}

}  // namespace
}  // namespace parallel_aspects
