// SPDX-License-Identifier: BSD-3-Clause
//
// The guard against a simulation of its model of motion, and by formulas of the test's own.
#include "parallel_aspects/motion/motion_guard.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/guard_campaign.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <cmath>
#include <limits>
#include <string>

namespace parallel_aspects {
namespace {

static_assert(noexcept(std::declval<MotionGuard&>().guard(std::declval<const TrackedState&>(),
                                                          std::declval<const ProvedDistances&>(),
                                                          std::declval<const TaskVector&>(), 0.0)));
static_assert(noexcept(std::declval<MotionGuard&>().halt(0.0)));

TaskVector vector(double x, double y) { return (TaskVector(2) << x, y).finished(); }

// The paper's five-bar at a pose far from everything, with distances that a test invents.
class FiveBarGuard : public testing::Test {
 protected:
  FiveBarGuard() {
    options_.latency = 0.0;
    options_.period = 0.1;
    options_.linear_deceleration = 2.0;
    options_.recovery = 0.0;
    state_ = test::tracked_at(*robot_, Pose::planar(4.5, 8.0), mode_, 0.0);
    proved_ = test::proved_of(BoundaryDistanceMeter(robot_).measure(state_.pose, mode_), state_.pose, mode_);
  }

  GuardedMotion guard(const TaskVector& twist) {
    return MotionGuard(robot_, options_).guard(state_, proved_, twist, 0.0);
  }

  const std::shared_ptr<const Manipulator> robot_ = test::shipped("five_bar")->manipulator();
  const WorkingMode mode_ = *WorkingMode::from_signs({-1, 1});
  GuardOptions options_;
  TrackedState state_;
  ProvedDistances proved_;
};

TEST_F(FiveBarGuard, PassesWhatIsSafe) {
  const GuardedMotion motion = guard(vector(0.3, -0.2));
  EXPECT_EQ(motion.scale, 1.0);
  EXPECT_EQ(motion.reason, GuardReason::none);
  const TaskVector right = direct_matrix(*robot_, state_.pose, state_.q) * motion.twist;
  const TaskVector left =
      inverse_diagonal(*robot_, state_.pose, state_.q).cwiseProduct(motion.joint_velocities);
  EXPECT_LT((right - left).norm(), 1e-9 * right.norm());
}

TEST_F(FiveBarGuard, StopsWhereTheMeterSays) {
  // Towards the witness at speed v: v s T + (v s)^2 / (2 a) is the way to the threshold, or a little more.
  const BoundaryDistance parallel = BoundaryDistanceMeter(robot_).measure(state_.pose, mode_).parallel;
  options_.stop = {0.4, 0.0, 0.0};
  const double speed = 10.0;
  const GuardedMotion motion = guard(speed * parallel.direction);
  EXPECT_EQ(motion.reason, GuardReason::hazard);
  EXPECT_EQ(motion.hazard, Hazard::parallel_singularity);
  const double v = motion.scale * speed, braking = v * v / (2.0 * 2.0);
  EXPECT_LE(v * options_.period + braking, parallel.upper - 0.4);
  EXPECT_GE(v * options_.period + 2.0 * braking,
            parallel.lower - 0.4 - 1e-6);  // which the guard counts twice
}

// A size a second: one call must not take room that the next ones need.
TEST(StrongPush, NeitherHaltsOnTheWayNorTurnsBack) {
  for (const char* name : {"five_bar", "three_rrr", "delta"}) {
    const std::shared_ptr<const Manipulator> robot = test::shipped(name)->manipulator();
    const GuardOptions options = test::guard_options_for(*robot);
    test::GuardLoop loop(robot, options);
    test::PosePairs random(robot, 20261126);
    int halts = 0;
    for (int i = 0; i < test::thinned(6); ++i) {
      const auto start = test::draw_start(random, loop, Hazard::parallel_singularity, options);
      if (!start) continue;
      const double delays[] = {0.0, options.latency, -options.latency};
      const TaskVector straight = TaskVector::Zero(static_cast<Eigen::Index>(robot->leg_count()));
      const test::GuardRun run = loop.push(start->pose, start->mode, Hazard::parallel_singularity,
                                           robot->size(), 1.5, delays[i % 3], straight, 1);
      SCOPED_TRACE(std::string(name) + " in " + to_string(start->mode) + " from " +
                   to_string(robot->task_space(), start->pose));
      EXPECT_FALSE(run.lost);
      EXPECT_GE(run.over, 0.0);
      EXPECT_LE(run.turns, 3);
      halts += run.halts;
    }
    EXPECT_LE(halts, 60) << name;  // of 750 calls in each of 6 runs
  }
}

TEST_F(FiveBarGuard, KeepsVelocityLimits) {
  for (std::size_t j = 0; j < 2; ++j) ASSERT_EQ(robot_->leg(j).limits.velocity, 2.0);
  proved_.lower.fill(std::numeric_limits<double>::infinity());
  const GuardedMotion motion = guard(vector(0.0, -200.0));
  EXPECT_EQ(motion.reason, GuardReason::joint_velocity);
  EXPECT_NEAR(motion.joint_velocities.cwiseAbs().maxCoeff(), 2.0, 1e-9);
}

TEST_F(FiveBarGuard, JointVelocitiesAreTheTwistThatTheyMake) {
  const GuardedMotion motion =
      MotionGuard(robot_, options_).guard_joints(state_, proved_, vector(0.01, 0.02), 0.0);
  EXPECT_LT((motion.joint_velocities - vector(0.01, 0.02)).norm(), 1e-12);
}

TEST_F(FiveBarGuard, UnknownGivesZero) {
  const auto expect_zero = [&](const TaskVector& twist, double time, GuardReason reason) {
    const GuardedMotion motion = MotionGuard(robot_, options_).guard(state_, proved_, twist, time);
    EXPECT_EQ(motion.scale, 0.0);
    EXPECT_EQ(motion.reason, reason);
    EXPECT_TRUE(motion.twist.isZero(0.0));
    EXPECT_TRUE(motion.joint_velocities.isZero(0.0));
  };
  const TaskVector some = vector(0.1, 0.0);
  expect_zero(some, 1.0, GuardReason::unknown_state);
  expect_zero(some, std::nan(""), GuardReason::unknown_state);
  expect_zero(vector(std::nan(""), 0.0), 0.0, GuardReason::invalid_command);
  expect_zero(TaskVector::Zero(3), 0.0, GuardReason::invalid_command);
  for (const TrackStatus status :
       {TrackStatus::ambiguous, TrackStatus::inconsistent, TrackStatus::uninitialised}) {
    state_.status = status;
    expect_zero(some, 0.0, GuardReason::unknown_state);
  }
}

// With nothing measured, what is clear about the robot is found by the guard alone.
TEST_F(FiveBarGuard, NeedsNoMeasuredDistance) {
  const GuardedMotion motion =
      MotionGuard(robot_, options_).guard(state_, ProvedDistances(), vector(0.5, 0.0), 0.0);
  EXPECT_EQ(motion.scale, 1.0);
}

TEST_F(FiveBarGuard, RisesSlowlyAfterwards) {
  options_.recovery = 0.5;
  options_.stop = {0.4, 0.0, 0.0};
  MotionGuard guard(robot_, options_);
  const TaskVector towards = BoundaryDistanceMeter(robot_).measure(state_.pose, mode_).parallel.direction;
  const double low = guard.guard(state_, proved_, 100.0 * towards, 0.0).scale;
  ASSERT_LT(low, 0.1);
  state_.time = 0.01;
  const GuardedMotion after = guard.guard(state_, proved_, -0.1 * towards, 0.01);
  EXPECT_EQ(after.reason, GuardReason::recovery);
  EXPECT_NEAR(after.scale, low + std::max(low, 0.05) * 0.01 / 0.5, 1e-12);
  guard.forget();
  EXPECT_EQ(guard.guard(state_, proved_, -0.1 * towards, 0.01).scale, 1.0);
}

TEST_F(FiveBarGuard, InsideAThresholdOnlyTheWayOutPasses) {
  const BoundaryDistance parallel = BoundaryDistanceMeter(robot_).measure(state_.pose, mode_).parallel;
  options_.stop = {1.2 * parallel.upper, 0.0, 0.0};
  EXPECT_EQ(guard(0.5 * parallel.direction).scale, 0.0);
  EXPECT_EQ(guard(0.5 * parallel.direction).reason, GuardReason::inside_threshold);
  const auto escape = escape_direction(*robot_, state_.pose, state_.q, parallel);
  ASSERT_TRUE(escape);
  const GuardedMotion out = guard(0.5 * escape->twist);
  EXPECT_EQ(out.reason, GuardReason::escape);
  EXPECT_EQ(out.scale, 1.0);
  EXPECT_LT((out.joint_velocities - 0.5 * escape->joint_rate).norm(), 1e-9);
}

TEST_F(FiveBarGuard, BadOptionsAreRefused) {
  options_.latency = -1.0;
  options_.linear_deceleration = 0.0;
  options_.stop[1] = std::nan("");
  EXPECT_EQ(problems_of(options_).size(), 3U);
  EXPECT_THROW(MotionGuard(robot_, options_), InvalidDescription);
}

// A strut beyond its limit may be brought back, and not be taken further.
TEST(GuardBeyondLimits, LetsTheJointComeBack) {
  const auto robot = test::shipped("bipod")->manipulator();
  GuardOptions options = test::guard_options_for(*robot);
  test::GuardLoop loop(robot, options);
  test::PosePairs random(robot, 3);
  const auto start = test::draw_start(random, loop, Hazard::limit, options);
  ASSERT_TRUE(start);
  const BoundaryDistance limit = loop.measure(start->pose, start->mode).actuated_limit;
  const Pose beyond =
      displaced(robot->motions(), start->pose, (limit.upper + 0.01 * robot->size()) * limit.direction);
  const TrackedState state = test::tracked_at(*robot, beyond, start->mode, 0.0);
  ASSERT_FALSE(robot->within_limits(state.q));
  const ProvedDistances proved = test::proved_of(loop.measure(beyond, start->mode), beyond, start->mode);
  const double speed = 0.01 * robot->size();
  options.recovery = 0.0;
  const GuardedMotion further =
      MotionGuard(robot, options).guard(state, proved, speed * limit.direction, 0.0);
  EXPECT_EQ(further.scale, 0.0);
  const GuardedMotion back = MotionGuard(robot, options).guard(state, proved, -speed * limit.direction, 0.0);
  EXPECT_GT(back.scale, 0.0);
  EXPECT_EQ(back.reason, GuardReason::escape);
}

// By the kinematics alone: all poses that are nearer than the threshold are reached, with det A of one sign.
TEST(GuardAgainstBruteForce, NoSingularityIsNearerThanTheThreshold) {
  const auto robot = test::shipped("five_bar")->manipulator();
  const GuardOptions options = test::guard_options_for(*robot);
  BoundaryDistanceMeter meter(robot);
  test::GuardLoop loop(robot, options);
  test::PosePairs random(robot, 17);
  for (int run = 0; run < test::thinned(20); ++run) {
    const auto start = test::draw_start(random, loop, Hazard::parallel_singularity, options);
    ASSERT_TRUE(start);
    const int sign = test::sign_in_doubles(*robot, start->pose, start->mode);
    test::LatePlatform platform(TaskSpace::T2, start->pose, options,
                                random.uniform(0.0, 1.0) * options.latency, 1);
    MotionGuard guard(robot, options);
    ProvedDistances proved;
    const double heading = random.uniform(-EIGEN_PI, EIGEN_PI);
    for (int i = 0; i < 750; ++i) {
      const double time = i * test::guard_step;
      const Pose pose = platform.pose();
      if (i % 10 == 0) proved = test::proved_of(meter.measure(pose, start->mode), pose, start->mode);
      // Straight, and later round a curve along what stops it.
      const double angle = heading + (i > 300 ? 0.01 * (i - 300) : 0.0);
      const TaskVector twist = 0.3 * robot->size() * vector(std::cos(angle), std::sin(angle));
      platform.command(
          time, guard.guard(test::tracked_at(*robot, pose, start->mode, time), proved, twist, time).twist);
      platform.move(time, time + test::guard_step);
      for (int k = 0; i % 5 == 0 && k < 72; ++k) {
        const double r = options.stop[0] * (0.999 - 0.333 * (k % 3)), at = k * EIGEN_PI / 36.0;
        const Pose near = displaced(TaskSpace::T2, pose, r * vector(std::cos(at), std::sin(at)));
        ASSERT_EQ(test::sign_in_doubles(*robot, near, start->mode), sign)
            << "run " << run << ", step " << i << ": " << to_string(TaskSpace::T2, near) << " in "
            << to_string(start->mode) << " from " << to_string(TaskSpace::T2, start->pose) << ", heading "
            << heading;
      }
    }
  }
}

// Each robot that has the hazard is pushed into it, by commands that are late by various times.
class GuardCampaign : public testing::TestWithParam<std::string> {};

TEST_P(GuardCampaign, StaysOutAndDoesNotChatter) {
  const auto robot = test::shipped(GetParam())->manipulator();
  const GuardOptions options = test::guard_options_for(*robot);
  test::GuardLoop loop(robot, options);
  test::PosePairs random(robot, 11);
  const int runs = test::is_sanitized ? 1 : 3;
  const double seconds = test::is_sanitized ? 0.3 : 2.0;
  const double delays[] = {options.latency, 0.0, -options.latency};
  for (std::size_t h = 0; h < hazard_count; ++h)
    for (int i = 0; i < runs; ++i) {
      const Hazard hazard = static_cast<Hazard>(h);
      const auto start = test::draw_start(random, loop, hazard, options, test::thinned(300));
      if (!start) break;
      const TaskVector none = TaskVector::Zero(static_cast<Eigen::Index>(robot->leg_count()));
      const test::GuardRun run = loop.push(start->pose, start->mode, hazard, 0.2 * robot->size(), seconds,
                                           delays[i], none, static_cast<std::uint64_t>(i));
      const std::string where = to_string(robot->task_space(), start->pose) + " in " +
                                to_string(start->mode) + " to a " + name(hazard);
      EXPECT_FALSE(run.lost) << where;
      EXPECT_GE(run.over, 0.0) << where;
      EXPECT_LE(run.turns, 10.0 * seconds) << where;
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, GuardCampaign,
                         testing::Values("five_bar", "bipod", "three_rpr", "three_rrr", "three_prr", "delta",
                                         "linear_delta", "spherical_3rrr", "stewart", "hexa", "six_pus"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace parallel_aspects
