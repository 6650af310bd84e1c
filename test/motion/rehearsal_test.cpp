// SPDX-License-Identifier: BSD-3-Clause
#include "motion/demo_rounds.h"
#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include <cmath>
#include <memory>
#include <string>

namespace parallel_aspects {
namespace {

constexpr double interval = 0.01;  // [s]

TrackerOptions straight() {
  TrackerOptions options;
  options.samples.path_bend = 0.0;
  return options;
}

JointVector joint_values(double a, double b) {
  JointVector q(2);
  q << a, b;
  return q;
}

/// A tour through the aspects of a robot, and where it begins.
struct Trip {
  std::shared_ptr<const Manipulator> robot;
  Pose start;
  Tour tour;
};

Trip trip_of(const std::shared_ptr<const Manipulator>& robot, double resolution, const Pose& start,
             const WorkingMode& mode) {
  MapOptions options;
  options.resolution = resolution;
  options.extra_levels = 3;
  return {robot, start, plan_tour(*compute_aspect_map(robot, options).map, start, mode)};
}

const Trip& five_bar_trip() {
  static const Trip trip = [] {
    Pose start;
    start.position << 4.5, 8.0, 0.0;
    return trip_of(test::five_bar(), 0.2, start, *WorkingMode::from_signs({1, -1}));
  }();
  return trip;
}

TEST(SampledMotion, HasEveryCornerAndStraightWaysOfEvenSpeed) {
  const std::vector<JointVector> corners{joint_values(0.0, 0.0), joint_values(0.033, 0.0),
                                         joint_values(0.033, 0.2), joint_values(0.0, 0.0)};
  const SampledMotion motion = sampled(*test::five_bar(), corners, 1.0, interval);
  EXPECT_EQ(motion.gain, joint_values(0.0, 0.0));
  std::size_t corner = 0;
  double longest = 0.0;
  for (std::size_t i = 0; i < motion.samples.size(); ++i) {
    if (corner + 1 < corners.size() && motion.samples[i] == corners[corner]) ++corner;
    if (i > 0) longest = std::max(longest, (motion.samples[i] - motion.samples[i - 1]).norm());
  }
  EXPECT_EQ(corner + 1, corners.size());
  EXPECT_GE(motion.samples.size(), 100U);
  EXPECT_LE(motion.samples.size(), 103U);
  EXPECT_LE(longest, 0.0044);
}

TEST(SampledMotion, KeepsToTheVelocityLimits) {
  const auto robot = test::shipped("delta")->manipulator();
  std::vector<Leg> legs = robot->legs();
  for (Leg& leg : legs) leg.limits.velocity = 0.5;
  const auto limited = test::manipulator("limited", TaskSpace::T3, legs);
  const std::vector<JointVector> corners{JointVector::Zero(3), JointVector::Constant(3, 1.0)};
  EXPECT_GE(sampled(*limited, corners, 0.1, interval).samples.size(), 200U);
}

TEST(Rehearsal, ATourOfManyAspectsIsFollowedSampleBySample) {
  const Trip& trip = five_bar_trip();
  ASSERT_GE(trip.tour.aspects.size(), 5U);
  Rehearsal rehearsal(trip.robot, straight(), interval);
  ASSERT_TRUE(rehearsal.start(trip.start, trip.tour.joint_values.front()));
  const SampledMotion motion = rehearsal.slow_enough(trip.tour.joint_values, 2.0);
  ASSERT_FALSE(motion.samples.empty());
  EXPECT_LT(motion.samples.size(), 400U + trip.tour.joint_values.size());
  for (int round = 0; round < 3; ++round) EXPECT_TRUE(rehearsal.play(motion));
}

TEST(Rehearsal, GoesOnWhereItWasAfterAMotionThatIsNotFollowed) {
  const Trip& trip = five_bar_trip();
  Rehearsal rehearsal(trip.robot, straight(), interval);
  ASSERT_TRUE(rehearsal.start(trip.start, trip.tour.joint_values.front()));
  EXPECT_FALSE(rehearsal.play({{joint_values(0.0, 0.0)}, joint_values(0.0, 0.0)}));
  EXPECT_TRUE(rehearsal.play(rehearsal.slow_enough(trip.tour.joint_values, 2.0)));
}

TEST(Rehearsal, IsSlowedDownForATrackerThatAllowsForBentWays) {
  const Trip& trip = five_bar_trip();
  Rehearsal rehearsal(trip.robot, TrackerOptions(), interval);
  ASSERT_TRUE(rehearsal.start(trip.start, trip.tour.joint_values.front()));
  const SampledMotion motion = rehearsal.slow_enough(trip.tour.joint_values, 10.0);
  EXPECT_GT(motion.samples.size(), 2000U);
  EXPECT_TRUE(rehearsal.play(motion));
}

// A gate of the Delta close to det A = 0, where one actuated joint takes its leg to the other posture.
TEST(StraightMotion, ThatExistsIsFollowedInOneSample) {
  const auto robot = test::shipped("delta")->manipulator();
  Pose pose;
  pose.position << 0.79959, 0.0140745, -0.210234;
  int passable = 0;
  for (const WorkingMode& mode : working_modes(*robot)) {
    for (std::size_t leg = 0; leg < robot->leg_count(); ++leg) {
      WorkingMode other = mode;
      other.set_sign(leg, -mode.sign(leg));
      const Place from{pose, inverse(*robot, pose, mode).q};
      const JointVector change = joint_change(*robot, from.q, inverse(*robot, pose, other).q);
      if (!straight_motion_exists(*robot, from, change, pose)) continue;
      ++passable;
      TrackerOptions options = straight();
      options.samples.check_velocity = false;  // the whole motion in one sample is faster than the robot
      Tracker tracker(robot, options);
      ASSERT_TRUE(tracker.start_near(0.0, from.q, pose, 1e-6));
      EXPECT_TRUE(tracker.update(interval, from.q + change).followed()) << to_string(mode) << ", leg " << leg;
    }
  }
  EXPECT_GT(passable, 0);
}

TEST(Rehearsal, DoesNotBeginWhereNoTrackerStarts) {
  Rehearsal rehearsal(test::five_bar(), straight(), interval);
  EXPECT_FALSE(rehearsal.start(Pose(), joint_values(0.0, 0.0)));
}

}  // namespace
}  // namespace parallel_aspects
