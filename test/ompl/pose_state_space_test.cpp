// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/pose_sampler.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/ompl/aspect_space_information.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

namespace ob = ompl::base;
using Robot = std::shared_ptr<const Manipulator>;

std::vector<Robot> robots() {
  std::vector<Robot> result;
  for (const auto& mechanism :
       {models::bipod(), models::five_bar(), models::three_prr(), models::three_rpr(), models::three_rrr(),
        models::delta(), models::linear_delta(), models::agile_eye(), models::spherical_3rrr(),
        models::hexa(), models::six_pus(), models::stewart()})
    result.push_back(mechanism->manipulator());
  return result;
}

double distance(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() + a.orientation.angularDistance(b.orientation);
}

TEST(PoseStateSpace, MotionsRunAsCertifiedSegments) {
  for (const Robot& robot : robots()) {
    const ob::StateSpacePtr space = make_pose_state_space(*robot);
    ob::ScopedState<> from(space), to(space), between(space);
    for (int i = 0; i < 200; ++i) {
      from.random(), to.random();
      const double t = i / 199.0;
      space->interpolate(from.get(), to.get(), t, between.get());
      const TaskSpace kind = robot->task_space();
      const Pose expected = pose_between(pose_of(kind, *from), pose_of(kind, *to), t);
      ASSERT_LT(distance(pose_of(kind, *between), expected), 1e-12 * (1.0 + robot->size())) << robot->name();
      ASSERT_TRUE(space->satisfiesBounds(between.get())) << robot->name();
      space->interpolate(from.get(), to.get(), t, to.get());  // into an end
      ASSERT_LT(distance(pose_of(kind, *to), expected), 1e-12 * (1.0 + robot->size())) << robot->name();
    }
  }
}

// Why `interpolate` is not OMPL's: its motions of SE2 and SE3 are other curves.
TEST(PoseStateSpace, OmplsOwnMotionsAreOtherCurves) {
  const auto ours = make_pose_state_space(*models::three_rpr()->manipulator());
  const ob::SE2StateSpace theirs;
  ob::ScopedState<ob::SE2StateSpace> from(ours), to(ours), our_state(ours), their_state(ours);
  from->setXY(0.0, 0.0), from->setYaw(0.0);
  to->setXY(1.0, 0.0), to->setYaw(3.0);
  ours->interpolate(from.get(), to.get(), 0.25, our_state.get());
  theirs.interpolate(from.get(), to.get(), 0.25, their_state.get());
  EXPECT_DOUBLE_EQ(our_state->getX(), their_state->getX());
  EXPECT_GT(std::abs(our_state->getYaw() - their_state->getYaw()), 0.05);
}

TEST(PoseStateSpace, PosesComeBack) {
  for (const Robot& robot : robots()) {
    const ob::StateSpacePtr space = make_pose_state_space(*robot);
    PoseSampler sampler(robot, 1, {}, EIGEN_PI);
    ob::ScopedState<> state(space);
    for (int i = 0; i < 200; ++i) {
      const auto pose = sampler.draw();
      if (!pose) continue;
      set_pose(robot->task_space(), *pose, *state);
      ASSERT_LT(distance(pose_of(robot->task_space(), *state), *pose), 1e-6) << robot->name();
    }
  }
}

TEST(PoseStateSpace, BoundsHoldAllThatIsReached) {
  for (const Robot& robot : robots()) {
    const ob::StateSpacePtr space = make_pose_state_space(*robot);
    PoseSampler sampler(robot, 2, {}, EIGEN_PI);
    ob::ScopedState<> state(space);
    int reached = 0;
    for (int i = 0; i < 5000; ++i) {
      const auto pose = sampler.draw();
      if (!pose) continue;
      const auto solutions = inverse_in_all_modes(*robot, *pose);
      if (std::none_of(solutions.begin(), solutions.end(), [](const InverseSolution& solution) {
            return solution.status == InverseStatus::solved;
          }))
        continue;
      ++reached;
      set_pose(robot->task_space(), *pose, *state);
      ASSERT_TRUE(space->satisfiesBounds(state.get()))
          << robot->name() << ' ' << to_string(robot->task_space(), *pose);
    }
    EXPECT_GT(reached, 0) << robot->name();
  }
}

// What planners of OMPL rely on, by OMPL's own checks.
TEST(PoseStateSpace, OmplFindsItSane) {
  for (const Robot& robot : robots()) {
    const ob::StateSpacePtr space = make_pose_state_space(*robot);
    space->setup();
    EXPECT_NO_THROW(space->sanityChecks()) << robot->name();
  }
}

TEST(PoseStateSpace, DistancesOfRotationsAreMetres) {
  const Robot stewart = models::stewart()->manipulator();
  const ob::StateSpacePtr space = make_pose_state_space(*stewart);
  ob::ScopedState<> from(space), to(space);
  set_pose(TaskSpace::SE3, Pose{}, *from);
  Pose turned;
  turned.orientation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY());
  set_pose(TaskSpace::SE3, turned, *to);
  EXPECT_NEAR(space->distance(from.get(), to.get()), 0.3 * stewart->characteristic_length(), 1e-9);
}

std::string refusal(const Manipulator& robot, const std::optional<Box>& region) {
  try {
    make_pose_state_space(robot, region);
  } catch (const InvalidDescription& invalid) {
    return invalid.what();
  }
  return "";
}

TEST(PoseStateSpace, RefusesWhatHasNoBounds) {
  ManipulatorDescription description = models::bipod()->manipulator()->description();
  for (Leg& leg : description.legs) leg.limits = {};
  const Manipulator robot(description);
  EXPECT_EQ(refusal(robot, {}),
            "The legs of 'bipod' have no limits that bound the workspace; limit the actuated joints in the "
            "URDF or give a region.");
  EXPECT_EQ(refusal(robot, Box{1, {0.0}, {1.0}}),
            "The region has 1 coordinates; give one for each position of the task space, which are 2.");
  EXPECT_EQ(refusal(robot, Box{2, {0.0, 1.0}, {1.0, 0.0}}),
            "The region, the workspace and the reach of the legs of 'bipod' have no position in common; give "
            "another region.");
  EXPECT_EQ(refusal(robot, Box{2, {0.0, NAN}, {1.0, 1.0}}),
            "The legs of 'bipod' have no limits that bound the workspace; limit the actuated joints in the "
            "URDF or give a region.");
  EXPECT_EQ(refusal(robot, Box{2, {0.0, 0.0}, {1.0, 1.0}}), "");
}

}  // namespace
}  // namespace parallel_aspects
