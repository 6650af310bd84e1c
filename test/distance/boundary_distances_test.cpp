// SPDX-License-Identifier: BSD-3-Clause
// Distances against values that were computed by other means, and the contract of the meter.
#include "parallel_aspects/distance/boundary_distances.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

Pose at(double x, double y, double z = 0.0) {
  Pose pose;
  pose.position << x, y, z;
  return pose;
}

Pose turned(double x, double y, double phi) {
  Pose pose = at(x, y);
  pose.orientation = Eigen::AngleAxisd(phi, Eigen::Vector3d::UnitZ());
  return pose;
}

WorkingMode mode_of(const std::vector<int>& signs) { return *WorkingMode::from_signs(signs); }

void expect_distance(const BoundaryDistance& distance, double value, double digits) {
  EXPECT_EQ(distance.status, DistanceStatus::tight);
  EXPECT_TRUE(distance.upper_proved);
  EXPECT_NEAR(distance.upper, value, digits);
  EXPECT_LE(distance.lower, value + digits);
  EXPECT_GE(distance.lower, 0.99 * value - digits);
}

void expect_witness(const BoundaryDistance& distance, const Pose& pose, double digits) {
  EXPECT_NEAR(distance.witness.position.x(), pose.position.x(), digits);
  EXPECT_NEAR(distance.witness.position.y(), pose.position.y(), digits);
}

// Elbow signs of the reference are those of q = atan2(.) + s acos(.); B_jj has the other sign.
TEST(FiveBarDistances, ParallelSingularitiesOfTheReference) {
  BoundaryDistanceMeter meter(test::five_bar());
  const BoundaryDistances near = meter.measure(at(4.5, 8.0), mode_of({-1, 1}));
  EXPECT_EQ(near.status, ConfigurationStatus::measured);
  EXPECT_NEAR(near.q[0], 1.633334, 1e-6);
  EXPECT_NEAR(near.q[1], 1.027907, 1e-6);
  expect_distance(near.parallel, 1.5359, 5e-5);
  expect_witness(near.parallel, at(4.218, 6.490), 2e-3);
  const BoundaryDistances far = meter.measure(at(4.5, 8.0), mode_of({-1, -1}));
  EXPECT_NEAR(far.q[1], 3.138465, 1e-6);
  expect_distance(far.parallel, 4.9153, 5e-5);
  expect_witness(far.parallel, at(3.145, 3.275), 2e-3);
}

TEST(FiveBarDistances, SerialSingularityOfTheReference) {
  BoundaryDistanceMeter meter(test::five_bar());
  for (const WorkingMode& mode : working_modes(*test::five_bar())) {
    const BoundaryDistances distances = meter.measure(at(4.5, 8.0), mode);
    expect_distance(distances.serial, 3.821220, 1e-6);
    EXPECT_NEAR(distances.serial.lower, 3.821220, 1e-6);
    EXPECT_EQ(distances.actuated_limit.status, DistanceStatus::absent);
    EXPECT_EQ(distances.actuated_limit.lower, std::numeric_limits<double>::infinity());
  }
}

TEST(ThreeRprDistances, ParallelSingularityOfTheReference) {
  BoundaryDistanceMeter meter(test::three_rpr());
  const Pose pose = turned(-8.72659533, 12.17566975, -0.98697424);
  expect_distance(meter.measure(pose, mode_of({1, 1, 1})).parallel, 6.4946, 5e-5);
}

// det A = 0 on the base line alone; |p - base point| is limited to [2, 6] and [4, 9].
TEST(BipodDistances, AreThoseOfALineAndOfCircles) {
  BoundaryDistanceMeter meter(test::bipod());
  const BoundaryDistances distances = meter.measure(at(2.0, 4.0), mode_of({1, 1}));
  expect_distance(distances.parallel, 4.0, 1e-9);
  expect_distance(distances.serial, std::sqrt(20.0), 1e-9);
  expect_distance(distances.actuated_limit, 1.0, 1e-9);
  EXPECT_EQ(distances.actuated_limit.leg, 1U);
  EXPECT_EQ(distances.actuated_limit.end, LimitEnd::lower);
  EXPECT_NEAR(distances.actuated_limit.joint_displacement[1], -1.0, 1e-9);
  expect_witness(distances.actuated_limit, at(2.6, 3.2), 1e-9);
}

TEST(BoundaryDistances, WitnessLiesInItsDirection) {
  const auto robot = test::three_rpr();
  BoundaryDistanceMeter meter(robot);
  const Pose pose = turned(-8.72659533, 12.17566975, -0.98697424);
  const BoundaryDistance parallel = meter.measure(pose, mode_of({1, 1, 1})).parallel;
  EXPECT_NEAR(anchor_distance(*robot, pose, parallel.witness), parallel.upper, 1e-9);
  const double step = 1e-4;
  const Pose next = displaced(TaskSpace::SE2, pose, step * parallel.direction);
  EXPECT_NEAR(anchor_distance(*robot, pose, next), step, 1e-3 * step);
  // Chords of a rotation do not add up to its chord; so the rest is shorter by about a step only.
  EXPECT_NEAR(anchor_distance(*robot, next, parallel.witness), parallel.upper - step, 2e-2 * step);
}

TEST(BoundaryDistances, WhatCannotBeMeasuredIsSaid) {
  BoundaryDistanceMeter meter(test::five_bar());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(meter.measure(at(nan, 8.0), mode_of({1, 1})).status, ConfigurationStatus::invalid);
  EXPECT_EQ(meter.measure(at(1e300, 8.0), mode_of({1, 1})).status, ConfigurationStatus::invalid);
  EXPECT_EQ(meter.measure(at(4.5, 8.0), mode_of({1, 1, 1})).status, ConfigurationStatus::invalid);
  EXPECT_EQ(meter.measure(at(4.5, 80.0), mode_of({1, 1})).status, ConfigurationStatus::out_of_reach);
  EXPECT_EQ(meter.measure(at(13.001, 0.0), mode_of({1, 1})).status, ConfigurationStatus::out_of_reach);
}

// Where inverse kinematics has joint values, the pose is not out of reach.
TEST(BoundaryDistances, AtASerialSingularityThatOneIsTouched) {
  BoundaryDistanceMeter meter(test::five_bar());
  for (const double y : {0.0, 1e-9})
    for (const WorkingMode& mode : working_modes(*test::five_bar())) {
      ASSERT_TRUE(inverse(*test::five_bar(), at(13.0 - y, 0.0), mode));
      const BoundaryDistances on = meter.measure(at(13.0 - y, 0.0), mode);
      EXPECT_NE(on.status, ConfigurationStatus::out_of_reach);
      EXPECT_EQ(on.serial.leg, 0U);
      EXPECT_LE(on.serial.lower, y);
    }
  const BoundaryDistances on = meter.measure(at(13.0, 0.0), mode_of({1, 1}));
  EXPECT_EQ(on.status, ConfigurationStatus::at_serial_singularity);
  EXPECT_EQ(on.serial.status, DistanceStatus::touching);
  EXPECT_EQ(on.serial.lower, 0.0);
  EXPECT_EQ(on.parallel.status, DistanceStatus::unavailable);
  EXPECT_FALSE(on);
}

TEST(BoundaryDistances, OutsideLimitsTheLimitIsTouched) {
  BoundaryDistanceMeter meter(test::bipod());
  const BoundaryDistances distances = meter.measure(at(2.0, 7.0), mode_of({1, 1}));
  EXPECT_EQ(distances.status, ConfigurationStatus::outside_limits);
  EXPECT_EQ(distances.actuated_limit.status, DistanceStatus::touching);
  EXPECT_EQ(distances.actuated_limit.leg, 0U);
  EXPECT_EQ(distances.actuated_limit.lower, 0.0);
  expect_distance(distances.parallel, 7.0, 1e-9);
}

TEST(BoundaryDistances, ASingularConfigurationTouches) {
  BoundaryDistanceMeter meter(test::bipod());
  const BoundaryDistances distances = meter.measure(at(2.0, 0.0), mode_of({1, 1}));
  EXPECT_EQ(distances.parallel.status, DistanceStatus::touching);
  EXPECT_EQ(distances.parallel.lower, 0.0);
}

TEST(BoundaryDistances, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(BoundaryDistanceMeter(test::bipod(), DistanceOptions{0.0, 100}), InvalidDescription);
  EXPECT_THROW(BoundaryDistanceMeter(test::bipod(), DistanceOptions{0.01, 0}), InvalidDescription);
}

// Zeros of det A where the rods are parallel, by a search along them: the first steps from these poses lead
// elsewhere.
TEST(FiveBarDistances, TheNearestSingularityIsFoundWhereTheFirstStepsLeadElsewhere) {
  BoundaryDistanceMeter meter(test::five_bar());
  expect_distance(meter.measure(at(5.583065312540176, 11.564917774977864), mode_of({-1, 1})).parallel,
                  5.246642, 2e-3);
  expect_distance(meter.measure(at(10.809365546491014, -5.840266199349996), mode_of({-1, -1})).parallel,
                  3.404113, 2e-3);
}

// However little is spent, what is proved holds: it stays below the distance that much work finds.
TEST(BoundaryDistances, ASmallBudgetIsLooseButRight) {
  const Pose pose = turned(-8.72659533, 12.17566975, -0.98697424);
  for (const int boxes : {1, 3, 10, 30, 100, 300}) {
    BoundaryDistanceMeter meter(test::three_rpr(), DistanceOptions{0.01, boxes});
    const BoundaryDistances distances = meter.measure(pose, mode_of({1, 1, 1}));
    EXPECT_LE(distances.parallel.lower, 6.4947) << boxes;
    EXPECT_LE(distances.parallel.boxes, boxes);
    EXPECT_GE(distances.parallel.upper, 6.4945) << boxes;
  }
}

}  // namespace
}  // namespace parallel_aspects
