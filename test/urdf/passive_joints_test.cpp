// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

class PassiveJointsOf : public testing::TestWithParam<const char*> {
 protected:
  // What encoders on every joint would say.
  Eigen::VectorXd readings(const Pose& pose, const JointVector& q) const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(mechanism_->joint_names().size()));
    EXPECT_TRUE(mechanism_->complete(pose, q, values));
    return values;
  }

  // A configuration with room about it, near the one that the robot was assembled in.
  AssembledConfiguration configuration() const {
    const AssembledConfiguration assembled = mechanism_->assembled();
    const Manipulator& robot = *mechanism_->manipulator();
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
      TaskVector step(static_cast<Eigen::Index>(robot.leg_count()));
      for (Eigen::Index k = 0; k < step.size(); ++k)
        step[k] = uniform(random) *
                  (k < static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot.task_space()))
                       ? 0.2
                       : 0.05 * robot.size());
      const Pose pose = displaced(robot.motions(), assembled.pose, step);
      for (const WorkingMode& mode : working_modes(robot)) {
        const InverseSolution solution = inverse(robot, pose, mode);
        if (solution.status != InverseStatus::solved || !passive_.within_limits(pose, solution.q)) continue;
        Tracker trial(mechanism_->manipulator());
        if (trial.start_near(0.0, solution.q, pose, 1e-6 * robot.size())) return {pose, solution.q};
      }
    }
    ADD_FAILURE() << "no configuration was found";
    return assembled;
  }

  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped(GetParam());
  const PassiveJoints passive_{mechanism_};
};

// From the actuated joints and the passive joints of one sample.
TEST_P(PassiveJointsOf, StartTheTracker) {
  const AssembledConfiguration truth = configuration();
  Tracker tracker(mechanism_->manipulator());
  tracker.update(0.0, truth.q);
  tracker.find_candidates();
  const PassiveResidual found = passive_.apply(readings(truth.pose, truth.q), tracker);
  ASSERT_EQ(tracker.state().status, TrackStatus::tracking) << tracker.candidates().size() << " candidates";
  EXPECT_EQ(found.compared, passive_.comparable());
  EXPECT_LT(found.excess, 1e-4);
  for (const Leg& leg : mechanism_->manipulator()->legs())
    EXPECT_LT((tracker.state().pose.transform(leg.anchor) - truth.pose.transform(leg.anchor)).norm(),
              1e-6 * mechanism_->manipulator()->size());
}

// An encoder with a bias is named, whether it is that of a passive joint or of an actuated joint.
TEST_P(PassiveJointsOf, ContradictABiasedEncoder) {
  const AssembledConfiguration truth = configuration();
  Tracker tracker(mechanism_->manipulator());
  ASSERT_TRUE(tracker.start_near(0.0, truth.q, truth.pose, 1e-6 * mechanism_->manipulator()->size()));
  Eigen::VectorXd values = readings(truth.pose, truth.q);
  const std::size_t biased = mechanism_->determined_joints().back().index;
  values[static_cast<Eigen::Index>(biased)] += 1.0;
  const PassiveResidual found = passive_.apply(values, tracker);
  EXPECT_EQ(tracker.state().status, TrackStatus::inconsistent);
  EXPECT_EQ(mechanism_->joint_names()[found.joint], mechanism_->joint_names()[biased]);
  EXPECT_NEAR(found.difference, 1.0, 1e-6);
  values[static_cast<Eigen::Index>(biased)] -= 1.0;
  passive_.apply(values, tracker);
  EXPECT_EQ(tracker.state().status, TrackStatus::tracking);
  values.setConstant(nothing);
  EXPECT_EQ(passive_.apply(values, tracker).compared, 0U);
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, PassiveJointsOf,
                         testing::Values("five_bar", "bipod", "three_rpr", "three_rrr", "three_prr", "delta",
                                         "linear_delta", "agile_eye", "spherical_3rrr", "stewart", "hexa",
                                         "six_pus", "ankle", "skew_wrist", "tilt_table", "four_bar"),
                         [](const testing::TestParamInfo<const char*>& tested) {
                           return std::string(tested.param);
                         });

// An actuated joint whose encoder is off by a tenth of a radian assembles elsewhere, and the passive joints
// say so.
TEST(PassiveJoints, ContradictABiasedDrive) {
  const auto mechanism = test::shipped("five_bar");
  const PassiveJoints passive(mechanism);
  const AssembledConfiguration truth = mechanism->assembled();
  Eigen::VectorXd values(static_cast<Eigen::Index>(mechanism->joint_names().size()));
  ASSERT_TRUE(mechanism->complete(truth.pose, truth.q, values));
  JointVector biased = truth.q;
  biased[0] += 0.1;
  Tracker tracker(mechanism->manipulator());
  ASSERT_TRUE(tracker.start_near(0.0, biased, truth.pose, mechanism->manipulator()->size()));
  EXPECT_TRUE(passive.apply(values, tracker).contradicts());
  EXPECT_EQ(tracker.state().status, TrackStatus::inconsistent);
}

TEST(PassiveJoints, RefuseOptionsThatMakeNoSense) {
  EXPECT_TRUE(problems_of(PassiveOptions{}).empty());
  EXPECT_EQ(problems_of(PassiveOptions{0.0, nothing, 2.0}).size(), 3U);
}

}  // namespace
}  // namespace parallel_aspects
