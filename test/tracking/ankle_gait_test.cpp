// SPDX-License-Identifier: BSD-3-Clause
//
// An ankle that walks at 1 kHz, and one that is driven into singularities: what the tracker and the
// thresholds say, against formulas of the test's own.
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/hazards.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/robots/ankle_formulas.h"
#include "support/robots/robots.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <random>

namespace parallel_aspects {
namespace {

using test::ankle_formulas::cranks;
using test::ankle_formulas::Vector2d;
namespace formulas = test::ankle_formulas;

constexpr double degree = EIGEN_PI / 180.0, period = 1e-3;  // [s]
const std::array<int, 2> positive{1, 1};

// A gait cycle as recorded, in eleven values [deg]: pitch is positive with the toes down, at push-off.
constexpr std::array<double, 11> pitches{0.0, 6.0, 0.0, -6.0, -10.0, -14.0, -6.0, 19.0, 12.0, 3.0, 0.0};
constexpr std::array<double, 11> rolls{3.0, 0.0, -3.0, -4.0, -4.0, -3.0, 0.0, 4.5, 4.0, 2.0, 3.0};

/// The smooth periodic curve through the values, by trigonometric interpolation; `phase` 0 to 1.
double along_cycle(const std::array<double, 11>& values, double phase) {
  constexpr double n = 11.0;
  double result = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double x = EIGEN_PI * (phase - static_cast<double>(k) / n);
    result += values[k] * (std::abs(std::sin(x)) < 1e-12 ? 1.0 : std::sin(n * x) / (n * std::sin(x)));
  }
  return result;
}

Vector2d gait(double time) {
  constexpr double cycle = 1.1;  // [s]
  const double phase = time / cycle - std::floor(time / cycle);
  return degree * Vector2d(along_cycle(pitches, phase), along_cycle(rolls, phase));
}

class Ankle : public testing::Test {
 protected:
  Pose pose_at(const Vector2d& angles) const { return *pose_from_coordinates(robot->motions(), angles); }

  Vector2d angles_of(const Pose& pose) const { return pose_coordinates(robot->task_space(), pose); }

  JointVector inverse_at(const Vector2d& angles) const {
    const InverseSolution solution = inverse(*robot, pose_at(angles), mode);
    EXPECT_EQ(solution.status, InverseStatus::solved) << angles.transpose();
    return solution.q;
  }

  JointVector read(const JointVector& q) {
    return q + noise * JointVector(Vector2d(uniform(random), uniform(random)));
  }

  /// How far noise in both encoders takes the robot, in the worst of four directions.
  double largest_error(const Vector2d& angles, const Vector2d& q) const {
    double largest = 0.0;
    for (const double one : {-noise, noise})
      for (const double other : {-noise, noise}) {
        const Vector2d there = formulas::angles_at(angles, q + Vector2d(one, other));
        largest = std::max(largest, formulas::distance(angles, there));
      }
    return largest;
  }

  std::shared_ptr<const Manipulator> robot = test::ankle();
  WorkingMode mode{2};
  double noise = SampleOptions().encoder_noise;  // [rad], to both sides
  std::mt19937 random{20261129};
  std::uniform_real_distribution<double> uniform{-1.0, 1.0};
};

TEST_F(Ankle, TheGaitIsThatOfAnAnkle) {
  Vector2d least = Vector2d::Zero(), most = Vector2d::Zero();
  for (int i = 0; i < 1100; ++i) {
    least = least.cwiseMin(gait(period * i));
    most = most.cwiseMax(gait(period * i));
  }
  EXPECT_NEAR(least[0] / degree, -15.0, 1.0);
  EXPECT_NEAR(most[0] / degree, 20.0, 1.0);
  EXPECT_NEAR(least[1] / degree, -5.0, 1.0);
  EXPECT_NEAR(most[1] / degree, 5.0, 1.0);
}

TEST_F(Ankle, HasTheInverseKinematicsOfItsDrawing) {
  for (int i = 0; i < 1100; i += 7) {
    const Vector2d angles = gait(period * i);
    const auto expected = cranks(angles, positive);
    ASSERT_TRUE(expected);
    const JointVector q = inverse_at(angles);
    for (Eigen::Index j = 0; j < 2; ++j)
      EXPECT_NEAR(std::remainder(q[j] - (*expected)[j], 2.0 * EIGEN_PI), 0.0, 1e-11) << angles.transpose();
  }
}

// Ten cycles with noise of the encoders: followed at every sample in one aspect, and never farther from the
// truth than the spread says.
TEST_F(Ankle, IsFollowedThroughItsGaitInOneAspect) {
  MapOptions options;
  options.resolution = 0.05;
  const auto map = compute_aspect_map(robot, options).map;
  ASSERT_TRUE(map);
  Tracker tracker(robot);
  tracker.set_map(map);
  const JointVector uncertainty = JointVector::Constant(2, noise);
  const Pose start = pose_at(gait(0.0));
  ASSERT_TRUE(tracker.start_near(0.0, read(inverse_at(gait(0.0))), start, 0.001, uncertainty));
  const int aspect = tracker.state().aspect;
  EXPECT_GT(aspect, 0);
  tracker.take_transitions();
  for (int i = 1; i <= 11000; ++i) {
    const Vector2d truth = gait(period * i);
    const TrackedState& state = tracker.update(period * i, read(inverse_at(truth)), uncertainty);
    ASSERT_EQ(state.status, TrackStatus::tracking) << i << ": " << reason(state.ambiguity);
    ASSERT_EQ(state.aspect, aspect) << i;
    ASSERT_EQ(state.mode, mode) << i;
    ASSERT_TRUE(tracker.transitions().empty()) << i;
    ASSERT_LE(formulas::distance(angles_of(state.pose), truth), state.spread)
        << i << " at " << truth.transpose();
    if (i % 50 != 0) continue;
    // Half of the ball of a proof is in reserve, what both encoders do is added up, and both angles count
    // with the longest lever: 7 times in all.
    const double worst = largest_error(angles_of(state.pose), state.q);
    EXPECT_GE(state.spread, 0.999 * worst) << i;
    EXPECT_LE(state.spread, 10.0 * worst) << i;
  }
}

/// A straight motion of the angles at 0.5 rad/s, and where on it the robot is singular.
struct Drive {
  Vector2d from, direction;
  Hazard hazard;
  double singular;  // angle from `from` [rad]
};

void PrintTo(const Drive& drive, std::ostream* stream) {
  *stream << name(drive.hazard) << " from " << drive.from.transpose() << " along "
          << drive.direction.transpose();
}

// Whether the drive is past its singularity at this angle, by the formulas alone.
bool is_past(const Drive& drive, double angle) {
  const Vector2d angles = drive.from + angle * drive.direction;
  const auto q = cranks(angles, positive);
  if (drive.hazard == Hazard::serial_singularity || !q) return !q;
  const auto determinant = [&](const Vector2d& at) {
    constexpr double step = 1e-6;
    Eigen::Matrix2d slopes;
    for (Eigen::Index i = 0; i < 2; ++i)
      slopes.col(i) = (formulas::misfit(at + step * Vector2d::Unit(i), *cranks(at, positive)) -
                       formulas::misfit(at - step * Vector2d::Unit(i), *cranks(at, positive)));
    return slopes.determinant();
  };
  return (determinant(angles) > 0.0) != (determinant(drive.from) > 0.0);
}

Drive with_singularity(Drive drive) {
  double last = 0.0, past = 0.0;
  while (!is_past(drive, past)) past = (last = past) + 0.01;
  for (int k = 0; k < 50; ++k) (is_past(drive, 0.5 * (last + past)) ? past : last) = 0.5 * (last + past);
  drive.singular = last;
  return drive;
}

class AnkleDrive : public Ankle, public testing::WithParamInterface<Drive> {};

// A warning, then a stop, while the robot is followed and is as far away as the thresholds say or farther.
TEST_P(AnkleDrive, IsReportedBeforeTheSingularityIsReached) {
  const Drive drive = with_singularity(GetParam());
  const Vector2d end = drive.from + drive.singular * drive.direction;
  DistanceThresholds::Options options;
  options[static_cast<std::size_t>(drive.hazard)] = {0.004, 0.002, 0.1};
  DistanceThresholds levels(options);
  BoundaryDistanceMeter meter(robot);
  Tracker tracker(robot);
  ASSERT_TRUE(tracker.start_near(0.0, read(inverse_at(drive.from)), pose_at(drive.from), 0.001));
  std::optional<double> warned, stopped;  // angles
  ThresholdLevel before = ThresholdLevel::clear;
  for (int i = 0; !stopped; ++i) {
    const double angle = 0.5 * period * i;
    ASSERT_LT(angle, drive.singular) << "it is reached, and nothing was told";
    const Vector2d angles = drive.from + angle * drive.direction;
    const TrackedState& state = tracker.update(period * i, read(inverse_at(angles)));
    ASSERT_TRUE(state.followed()) << angle << ": " << reason(state.ambiguity);
    if (i % 20 != 0) continue;  // 50 Hz
    const BoundaryDistances measured = meter.measure(state.pose, state.mode);
    const ThresholdState& level = levels.update(
        {measured.parallel.lower, measured.serial.lower, std::numeric_limits<double>::infinity()});
    EXPECT_NE(level.level, ThresholdLevel::unknown) << angle;
    const double room = formulas::distance(angles_of(state.pose), end);
    const BoundaryDistance& of_hazard =
        drive.hazard == Hazard::serial_singularity ? measured.serial : measured.parallel;
    EXPECT_LE(of_hazard.lower, room) << angle;
    EXPECT_GE(level.level, before) << "it comes nearer all the time";
    before = level.level;
    if (level.level == ThresholdLevel::warn && !warned) warned = angle;
    if (level.level == ThresholdLevel::stop) stopped = angle;
    if (stopped) {
      EXPECT_EQ(level.hazard, drive.hazard);
    }
  }
  ASSERT_TRUE(warned);
  EXPECT_LT(*warned, *stopped);
  EXPECT_LT(*stopped, drive.singular);
}

INSTANTIATE_TEST_SUITE_P(All, AnkleDrive,
                         testing::Values(Drive{{0.2, 0.0}, {1.0, 0.0}, Hazard::serial_singularity, 0.0},
                                         Drive{{-0.2, 0.0}, {-1.0, 0.0}, Hazard::serial_singularity, 0.0},
                                         Drive{{0.0, 0.3}, {0.0, 1.0}, Hazard::serial_singularity, 0.0},
                                         Drive{
                                             {-2.932, 1.0}, {0.0, 1.0}, Hazard::parallel_singularity, 0.0}));

}  // namespace
}  // namespace parallel_aspects
