// SPDX-License-Identifier: BSD-3-Clause
//
// What the tracker says where the actuated joints alone do not tell the assembly mode.
#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

JointVector joints(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Pose at(double x, double y, double phi = 0.0) {
  Pose pose;
  pose.position << x, y, 0.0;
  pose.orientation = Eigen::AngleAxisd(phi, Eigen::Vector3d::UnitZ());
  return pose;
}

JointVector joint_values(const Manipulator& robot, const Pose& pose, const std::vector<int>& signs) {
  return inverse(robot, pose, *WorkingMode::from_signs(signs)).q;
}

std::shared_ptr<const Manipulator> with_velocity(const Manipulator& robot, double velocity) {
  std::vector<Leg> legs = robot.legs();
  for (Leg& leg : legs) leg.limits.velocity = velocity;
  return test::manipulator(robot.name(), robot.task_space(), std::move(legs));
}

// For steps that are long in time and path, and taken to be straight.
TrackerOptions straight() {
  TrackerOptions options;
  options.samples.path_bend = 0.0;
  options.samples.longest_interval = std::numeric_limits<double>::infinity();
  return options;
}

const auto bipod = with_velocity(*test::bipod(), 1.0);

TEST(AmbiguousTracker, AStepBeyondTheVelocityLimitsIsAGap) {
  Tracker tracker(bipod);
  const JointVector q = joint_values(*bipod, at(2.0, 4.0), {1, 1});
  ASSERT_TRUE(tracker.start_near(0.0, q, at(2.0, 4.0), 1e-6));
  JointVector moved = q + joints({0.0009, -0.0009});
  EXPECT_EQ(tracker.update(0.001, moved).status, TrackStatus::tracking);
  moved[0] += 0.05;
  EXPECT_EQ(tracker.update(0.101, moved).status, TrackStatus::tracking);
  moved[0] += 0.05;
  EXPECT_EQ(tracker.update(0.102, moved).status, TrackStatus::ambiguous);
  EXPECT_EQ(tracker.state().ambiguity, Ambiguity::gap);
  ASSERT_EQ(tracker.transitions().count, 1U);
  EXPECT_EQ(tracker.transitions().begin()->kind, TransitionKind::lost);
  EXPECT_FALSE(tracker.transitions().begin()->determinant);
  EXPECT_TRUE(tracker.wants_candidates());
  EXPECT_FALSE(tracker.find_candidates());
  EXPECT_EQ(tracker.candidates().size(), 2U);
  EXPECT_TRUE(tracker.candidates().complete());
  EXPECT_TRUE(
      tracker.keep_candidates([](const Pose& pose, const JointVector&) { return pose.position.y() > 0.0; }));
  EXPECT_EQ(tracker.state().status, TrackStatus::tracking);
  EXPECT_GT(tracker.state().pose.position.y(), 0.0);
}

TEST(AmbiguousTracker, RefusesOptionsThatMakeNoSense) {
  EXPECT_TRUE(problems_of(TrackerOptions{}).empty());
  TrackerOptions options;
  options.hysteresis = 1.0;
  options.max_steps = 0;
  options.samples.velocity_tolerance = -0.1;
  options.samples.encoder_noise = std::numeric_limits<double>::quiet_NaN();
  options.samples.longest_interval = 0.0;
  options.samples.interval_ratio = 0.5;
  EXPECT_EQ(problems_of(options).size(), 6U);
}

TEST(AmbiguousTracker, AnIntervalThatIsTooLongIsASilence) {
  Tracker tracker(bipod);
  const JointVector q = joint_values(*bipod, at(2.0, 4.0), {1, 1});
  ASSERT_TRUE(tracker.start_near(0.0, q, at(2.0, 4.0), 1e-6));
  EXPECT_EQ(tracker.update(0.5, q).status, TrackStatus::tracking);
  EXPECT_EQ(tracker.update(1.1, q).ambiguity, Ambiguity::silence);
  ASSERT_TRUE(tracker.start_near(2.0, q, at(2.0, 4.0), 1e-6));
  EXPECT_EQ(tracker.update(1.9, q).ambiguity, Ambiguity::silence) << "nobody knows how long that was";
  TrackerOptions options;
  options.samples.longest_interval = std::numeric_limits<double>::infinity();
  Tracker trusting(bipod, options);
  ASSERT_TRUE(trusting.start_near(0.0, q, at(2.0, 4.0), 1e-6));
  EXPECT_EQ(trusting.update(1000.0, q).status, TrackStatus::tracking) << "continuity was stated";
}

// Moved by hand through det A = 0 while nothing was published, and back to actuated joints near those before:
// now in the other assembly mode.
TEST(AmbiguousTracker, ARobotThatWasMovedInSilenceIsNotFollowed) {
  const auto robot = test::five_bar();
  const JointVector q = joint_values(*robot, at(4.5, 8.0), {-1, -1});
  for (const double pause : {0.06, 0.3}) {
    Tracker tracker(robot);
    ASSERT_TRUE(tracker.start_with_sign(0.0, q, 1));
    for (int i = 1; i <= 20; ++i) ASSERT_EQ(tracker.update(0.01 * i, q).status, TrackStatus::tracking);
    EXPECT_EQ(tracker.update(0.2 + pause, q + joints({0.01, 0.0})).ambiguity, Ambiguity::pause);
    EXPECT_EQ(tracker.transitions().begin()->kind, TransitionKind::lost);
    EXPECT_FALSE(tracker.find_candidates());
    EXPECT_EQ(tracker.candidates().size(), 2U) << "both assembly modes are possible";
  }
}

TEST(AmbiguousTracker, TheParameterThatMakesASilenceIsNamed) {
  EXPECT_NE(std::string(reason(Ambiguity::silence)).find("tracking/longest_interval"), std::string::npos);
  EXPECT_NE(std::string(reason(Ambiguity::pause)).find("tracking/interval_ratio"), std::string::npos);
  EXPECT_EQ(std::string(reason(Ambiguity::half_turn)).find("interval"), std::string::npos);
}

TEST(AmbiguousTracker, ASilenceIsDistinguishedFromTheUsualRate) {
  const auto free = test::five_bar(), limited = with_velocity(*free, 1.0);
  const JointVector q = joint_values(*free, at(4.5, 8.0), {-1, -1});
  SampleOptions options;
  SampleIntervals intervals;
  const auto gap = [&](const Manipulator& robot, double seconds) {
    return gap_between(robot, options, intervals, q, q, seconds);
  };
  intervals.add(0.01);
  intervals.add(0.01);
  EXPECT_EQ(gap(*free, 0.4), SampleGap::none) << "no rate is known yet";
  intervals.add(0.001);
  EXPECT_EQ(gap(*free, 0.049), SampleGap::none);
  EXPECT_EQ(gap(*free, 0.051), SampleGap::pause);
  EXPECT_EQ(gap(*limited, 0.4), SampleGap::none) << "the limit says how far it can have moved";
  options.check_velocity = false;
  EXPECT_EQ(gap(*limited, 0.051), SampleGap::pause);
  options.interval_ratio = 100.0;
  EXPECT_EQ(gap(*limited, 0.4), SampleGap::none);
  options.interval_ratio = 5.0;
  for (int i = 0; i < 8; ++i) intervals.add(0.1);
  EXPECT_EQ(gap(*free, 0.4), SampleGap::none) << "this is the rate now";
}

TEST(AmbiguousTracker, TransitionsAreTakenOnce) {
  Tracker tracker(bipod);
  const JointVector q = joint_values(*bipod, at(2.0, 4.0), {1, 1});
  ASSERT_TRUE(tracker.start_near(0.0, q, at(2.0, 4.0), 1e-6));
  tracker.update(1.0, q);
  EXPECT_EQ(tracker.take_transitions().count, 1U);
  EXPECT_TRUE(tracker.take_transitions().empty());
  ASSERT_TRUE(tracker.find_candidates());
  EXPECT_EQ(tracker.take_transitions().count, 1U) << "its velocity limits say that it is the same";
  EXPECT_TRUE(tracker.take_transitions().empty());
}

// At (4.5, 8) the second crank stands at 3.138 in this mode, just below half a turn.
TEST(AmbiguousTracker, EncodersMayWrap) {
  const auto robot = test::five_bar();
  Tracker tracker(robot);
  JointVector q = joint_values(*robot, at(4.5, 8.0), {-1, -1});
  ASSERT_NEAR(q[1], 3.138465, 1e-6);
  ASSERT_TRUE(tracker.start_near(0.0, q, at(4.5, 8.0), 1e-6));
  for (int i = 1; i <= 100; ++i) {
    q += joints({0.0, 0.001});
    JointVector wrapped = q;
    for (double& angle : coefficients_of(wrapped)) angle = std::remainder(angle, 2.0 * EIGEN_PI);
    ASSERT_EQ(tracker.update(i * 0.001, wrapped).status, TrackStatus::tracking);
    ASSERT_LT((tracker.state().q - q).norm(), 1e-12);
  }
  EXPECT_GT(q[1], EIGEN_PI);
}

// Whatever the actuated joints are within their uncertainty, the platform is as near as the spread says, and
// in the assembly mode that is followed.
TEST(AmbiguousTracker, UncertainDrivesAreFollowedAsAWhole) {
  const auto robot = test::five_bar();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const JointVector uncertainty = joints({0.002, 0.001});
  Tracker tracker(robot);
  JointVector q = joint_values(*robot, at(4.5, 8.0), {-1, 1});
  ASSERT_TRUE(tracker.start_near(0.0, q, at(4.5, 8.0), 1e-6));
  int followed = 0;
  for (; followed < 3000; ++followed) {
    q += joints({0.001, -0.001});
    const TrackedState& state = tracker.update(0.001 * (followed + 1), q, uncertainty);
    if (!state.followed()) break;
    ASSERT_GT(state.spread, 0.0);
    for (int i = 0; i < 10; ++i) {
      const JointVector truth = q + joints({share(random), share(random)}).cwiseProduct(uncertainty);
      const DirectResult all = direct(*robot, truth);
      ASSERT_EQ(all.solutions.size(), 2U) << "this far from det A = 0 at least";
      const AssemblyMode& same = all.solutions[state.determinant_sign > 0 ? 0 : 1];
      EXPECT_LE((same.pose.position - state.pose.position).norm(), state.spread);
    }
  }
  EXPECT_GT(followed, 10);
  EXPECT_EQ(tracker.state().ambiguity, Ambiguity::near_parallel_singularity);
  tracker.update(0.001 * (followed + 2), q, uncertainty);
  tracker.find_candidates();
  EXPECT_FALSE(tracker.candidates().complete()) << "at other actuated joints there may be others";
}

// An actuated joint of 1 rad/s may have gone round the other way within three seconds.
TEST(AmbiguousTracker, ATimeForHalfATurnIsASilence) {
  const auto robot = with_velocity(*test::five_bar(), 1.0);
  const JointVector q = joint_values(*robot, at(4.5, 8.0), {-1, -1});
  SampleOptions options;
  options.longest_interval = std::numeric_limits<double>::infinity();
  const auto gap = [&](const JointVector& step, double seconds) {
    return gap_between(*robot, options, {}, q, q + step, seconds);
  };
  EXPECT_EQ(gap(joints({1.2, -1.2}), 1.0), SampleGap::none);
  EXPECT_EQ(gap(joints({1.3, 0.0}), 1.0), SampleGap::step);
  EXPECT_EQ(gap(joints({0.0, 0.0}), 2.5), SampleGap::none);
  EXPECT_EQ(gap(joints({0.0, 0.0}), 3.0), SampleGap::half_turn);
  EXPECT_EQ(gap(joints({0.001, 0.0}), -1.0), SampleGap::step) << "time goes backwards";
}

TEST(AmbiguousTracker, LimitsSayWhichTurnIsMeant) {
  std::vector<Leg> legs = test::five_bar()->legs();
  legs[0].limits = JointLimits{0.5, 5.0};
  const auto robot = test::manipulator("limited", TaskSpace::T2, legs);
  EXPECT_NEAR(unwrapped(*robot, {}, joints({-2.0, 9.0}))[0], 2.0 * EIGEN_PI - 2.0, 1e-12);
  EXPECT_EQ(unwrapped(*robot, {}, joints({-2.0, 9.0}))[1], 9.0);
  EXPECT_EQ(unwrapped(*robot, joints({0.5, 3.0}), joints({4.9, -3.0}))[0], 4.9);
  EXPECT_NEAR(unwrapped(*robot, joints({0.5, 3.0}), joints({4.9, -3.0}))[1], 2.0 * EIGEN_PI - 3.0, 1e-12);
  EXPECT_EQ(unwrapped(*robot, joints({0.5, 3.0}), joints({0.0, 3.0}))[0], 0.0);
}

// Six assembly modes at the first sample: each is followed until what is known leaves one.
TEST(AmbiguousTracker, FollowsEveryAssemblyModeUntilOneIsLeft) {
  const auto robot = test::three_rpr();
  Tracker tracker(robot);
  JointVector q = joints({14.98, 15.38, 12.0});
  EXPECT_EQ(tracker.update(0.0, q).status, TrackStatus::uninitialised);
  EXPECT_FALSE(tracker.find_candidates());
  EXPECT_EQ(tracker.state().ambiguity, Ambiguity::several_assembly_modes);
  ASSERT_EQ(tracker.candidates().size(), 6U);
  for (int i = 1; i <= 50; ++i) {
    q += joints({0.001, -0.0005, 0.0007});
    ASSERT_EQ(tracker.update(0.001 * i, q).status, TrackStatus::ambiguous);
  }
  ASSERT_EQ(tracker.candidates().size(), 6U);
  ASSERT_TRUE(tracker.candidates().complete());
  const DirectResult truth = direct(*robot, q);
  ASSERT_EQ(truth.solutions.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_LT((tracker.candidates()[i].pose.position - truth.solutions[i].pose.position).norm(), 1e-7);
  const Eigen::Vector3d known = truth.solutions[2].pose.position;
  const auto near = [&](const Pose& pose, const JointVector&) {
    return (pose.position - known).norm() < 0.1;
  };
  EXPECT_TRUE(tracker.keep_candidates(near));
  EXPECT_LT((tracker.state().pose.position - known).norm(), 1e-7);
  EXPECT_EQ(tracker.update(0.051, q).status, TrackStatus::tracking);
}

// So near det A = 0 that the direct solver tells both assembly modes as one: the list is not complete.
TEST(AmbiguousTracker, DoesNotStartWhereTwoAssemblyModesMeet) {
  Tracker tracker(test::five_bar());
  JointVector q = joints({1.558, 0.8314682264352418});
  tracker.update(0.0, q);
  EXPECT_FALSE(tracker.find_candidates());
  EXPECT_FALSE(tracker.candidates().complete());
  for (int i = 1; i <= 60; ++i) {
    q[1] += 0.002;
    ASSERT_NE(tracker.update(0.001 * i, q).status, TrackStatus::tracking);
    ASSERT_TRUE(tracker.wants_candidates());
  }
  EXPECT_FALSE(tracker.find_candidates());
  EXPECT_EQ(tracker.candidates().size(), 2U);
  EXPECT_TRUE(tracker.candidates().complete());
}

// One sample that cannot be assembled is no reason to list none from then on.
TEST(AmbiguousTracker, ListsCandidatesAgainAfterDrivesThatCannotBeAssembled) {
  Tracker tracker(test::five_bar());
  tracker.update(0.0, joints({EIGEN_PI, 0.0}));
  EXPECT_FALSE(tracker.find_candidates());
  EXPECT_EQ(tracker.candidates().size(), 0U);
  tracker.update(0.001, joints({1.633334, 1.027907}));
  ASSERT_TRUE(tracker.wants_candidates());
  EXPECT_FALSE(tracker.find_candidates());
  EXPECT_EQ(tracker.candidates().size(), 2U);
}

TEST(AmbiguousTracker, SaysWhereNoCandidateFitsOrNoneExists) {
  const auto robot = test::three_rpr();
  Tracker tracker(robot);
  tracker.update(0.0, joints({14.98, 15.38, 12.0}));
  tracker.find_candidates();
  EXPECT_FALSE(tracker.keep_candidates([](const Pose&, const JointVector&) { return false; }));
  EXPECT_EQ(tracker.state().ambiguity, Ambiguity::no_candidate_fits);
  EXPECT_TRUE(tracker.wants_candidates());
  tracker.stop();
  tracker.update(1.0, joints({10.0, 32.0, 60.0}));
  EXPECT_FALSE(tracker.find_candidates());
  EXPECT_EQ(tracker.state().ambiguity, Ambiguity::no_direct_solution);
}

TEST(AmbiguousTracker, StartsWhereALegIsStretchedOnceItIsNot) {
  const auto robot = test::five_bar();
  Tracker tracker(robot);
  // Leg 1 in line, along x: the tip of the crank at (8, 0), the platform at (13, 0); leg 2 reaches it.
  const JointVector stretched = joints({0.0, joint_values(*robot, at(13.0, 0.0), {1, -1})[1]});
  EXPECT_FALSE(tracker.start_near(0.0, stretched, at(13.0, 0.0), 1e-3));
  EXPECT_EQ(tracker.state().status, TrackStatus::ambiguous);
  EXPECT_EQ(tracker.state().ambiguity, Ambiguity::serial_singularity);
  int i = 1;
  JointVector q = stretched;
  while (i < 100 && tracker.state().status != TrackStatus::tracking) {
    q += joints({0.001, 0.0});
    tracker.update(0.001 * i++, q);
  }
  EXPECT_EQ(tracker.state().status, TrackStatus::tracking);
  EXPECT_EQ(tracker.state().mode.sign(1), -1);
}

TEST(AmbiguousTracker, AResidualMakesTheStateInconsistentAndIsFollowedOn) {
  Tracker tracker(bipod);
  const JointVector q = joint_values(*bipod, at(2.0, 4.0), {1, 1});
  ASSERT_TRUE(tracker.start_near(0.0, q, at(2.0, 4.0), 1e-6));
  tracker.report_residual(3.0, true);
  EXPECT_EQ(tracker.state().status, TrackStatus::inconsistent);
  EXPECT_EQ(tracker.update(0.1, q + joints({0.01, 0.0})).status, TrackStatus::inconsistent);
  tracker.report_residual(0.1, false);
  EXPECT_EQ(tracker.state().status, TrackStatus::tracking);
}

TEST(AmbiguousTracker, AStepThatNeedsTooManySubdivisionsIsSaidToBeOne) {
  TrackerOptions options = straight();
  options.max_steps = 1;
  const auto robot = test::five_bar();
  Tracker tracker(robot, options);
  const JointVector q = joint_values(*robot, at(4.5, 8.0), {-1, -1});
  ASSERT_TRUE(tracker.start_with_sign(0.0, q, 1));
  EXPECT_EQ(tracker.update(1.0, q + joints({0.5, 0.5})).ambiguity, Ambiguity::step_budget);
}

// The time of a crossing is right even where one step leads far across it.
TEST(AmbiguousTracker, CrossingsOfLongStepsAreTimed) {
  const auto robot = test::five_bar();
  const JointVector q = joint_values(*robot, at(4.5, 8.0), {-1, -1});
  double fine = 0.0;
  Tracker tracker(robot, straight());
  ASSERT_TRUE(tracker.start_with_sign(0.0, q, 1));
  for (int i = 1; i <= 4000 && fine == 0.0; ++i) {
    tracker.update(i * 0.001, q + joints({i * 0.001, 0.0}));
    if (!tracker.transitions().empty()) fine = tracker.transitions().begin()->time;
  }
  ASSERT_GT(fine, 0.0);
  ASSERT_TRUE(tracker.start_with_sign(0.0, q, 1));
  tracker.update(fine + 0.2, q + joints({fine + 0.2, 0.0}));
  ASSERT_EQ(tracker.transitions().count, 1U);
  EXPECT_NEAR(tracker.transitions().begin()->time, fine, 1e-3);
}

// Steps so long that several legs change sides in one.
TEST(AmbiguousTracker, CrossingsOfOneStepAreAChain) {
  const auto robot = test::three_prr();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  int several = 0;
  for (int run = 0; run < 3000 && several < 20; ++run) {
    const InverseSolution start = inverse(*robot, at(uniform(random), uniform(random), uniform(random)),
                                          WorkingMode::from_index(3, static_cast<std::size_t>(run) % 8));
    if (start.status != InverseStatus::solved) continue;
    Tracker tracker(robot, straight());
    if (!tracker.start_with_sign(0.0, start.q, run % 2 == 0 ? 1 : -1)) continue;
    const WorkingMode first = tracker.state().mode;
    tracker.update(1.0, start.q + joints({uniform(random), uniform(random), uniform(random)}));
    const WorkingMode* mode = &first;
    for (const Transition& each : tracker.transitions()) {
      if (each.kind != TransitionKind::working_mode) continue;
      several += mode != &first;
      EXPECT_EQ(each.mode_before, *mode) << "run " << run;
      EXPECT_EQ(each.mode_after.sign(each.leg), -each.mode_before.sign(each.leg)) << "run " << run;
      EXPECT_TRUE(each.time > 0.0 && each.time < 1.0) << "run " << run;
      mode = &each.mode_after;
    }
    EXPECT_EQ(*mode, tracker.state().mode) << "run " << run;
  }
  EXPECT_GT(several, 0);
}

}  // namespace
}  // namespace parallel_aspects
