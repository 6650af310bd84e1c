// SPDX-License-Identifier: BSD-3-Clause
// Distances of random configurations against dense samples of poses, whose kinematics share no code with the
// enclosures.
#include "model/task_space_traits.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

/// Poses in the ball about a pose, many of them close to its border.
class BallSampler {
 public:
  BallSampler(const Robot& robot, const Pose& center, std::uint64_t seed)
      : robot_(robot), center_(center), engine_(seed) {}

  /// D from the center is at most `radius`.
  Pose draw(double radius) {
    TaskVector twist(static_cast<Eigen::Index>(robot_->leg_count()));
    for (Eigen::Index i = 0; i < twist.size(); ++i) twist[i] = normal_(engine_);
    const auto turning = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot_->task_space()));
    twist.head(turning) /= robot_->characteristic_length();
    const double aim = radius * (1.0 - std::pow(uniform_(engine_), 3.0));
    Pose pose = center_;
    for (int i = 0; i < 3; ++i) {
      const double distance = i == 0 ? twist.norm() : anchor_distance(*robot_, center_, pose);
      if (distance > 0.0) twist *= aim / distance;
      pose = displaced(robot_->motions(), center_, twist);
    }
    return anchor_distance(*robot_, center_, pose) <= radius ? pose : center_;
  }

 private:
  Robot robot_;
  Pose center_;
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

double sign_of(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

struct Case {
  Robot robot;
  Pose pose;
  WorkingMode mode;
  BoundaryDistances distances;

  std::string text() const {
    return robot->name() + " " + to_string(mode) + " at " + to_string(robot->task_space(), pose);
  }
  double determinant_sign(const Pose& at) const {
    const InverseSolution solution = inverse(*robot, at, mode);
    return solution.status == InverseStatus::out_of_reach
               ? 0.0
               : sign_of(direct_determinant(*robot, at, solution.q));
  }
};

/// Whether det A has different signs at two poses of the ball, and every leg reaches all the way between them
/// in it: then det A vanishes there. Beyond a gap that a leg cannot reach across, it may have any sign.
bool crosses_singularity(const Case& each, const Pose& from, const Pose& to, double radius) {
  constexpr int steps = 200;
  if (each.determinant_sign(from) * each.determinant_sign(to) >= 0.0) return false;
  for (int i = 0; i <= steps; ++i) {
    const Pose between = pose_between(each.robot->motions(), from, to, static_cast<double>(i) / steps);
    if (each.determinant_sign(between) == 0.0) return false;
    if (anchor_distance(*each.robot, each.pose, between) > radius) return false;
  }
  return true;
}

double within(double lower) { return std::isfinite(lower) ? lower * (1.0 - 1e-9) : 0.0; }

void expect_no_boundary_below(const Case& each, std::uint64_t seed, int samples) {
  BallSampler ball(each.robot, each.pose, seed);
  const BoundaryDistances& d = each.distances;
  Pose before = each.pose;
  for (int i = 0; i < samples; ++i) {
    const Pose near = ball.draw(within(d.parallel.lower));
    for (const Pose& from : {each.pose, before})
      ASSERT_FALSE(crosses_singularity(each, from, near, d.parallel.lower))
          << each.text() << ": det A changes its sign below " << d.parallel.lower << " between "
          << to_string(each.robot->task_space(), from) << " and "
          << to_string(each.robot->task_space(), near);
    before = near;
    const Pose reached = ball.draw(within(d.serial.lower));
    ASSERT_NE(inverse(*each.robot, reached, each.mode).status, InverseStatus::out_of_reach)
        << each.text() << " below " << d.serial.lower << " at "
        << to_string(each.robot->task_space(), reached);
    const Pose free = ball.draw(within(std::min(d.actuated_limit.lower, d.serial.lower)));
    if (d.status == ConfigurationStatus::measured) {
      ASSERT_EQ(inverse(*each.robot, free, each.mode).status, InverseStatus::solved)
          << each.text() << " below " << d.actuated_limit.lower << " at "
          << to_string(each.robot->task_space(), free);
    }
  }
}

void expect_at_its_distance(const Case& each, const BoundaryDistance& distance) {
  EXPECT_LE(distance.lower, distance.upper) << each.text();
  if (!std::isfinite(distance.upper)) return;
  EXPECT_NEAR(anchor_distance(*each.robot, each.pose, distance.witness), distance.upper,
              1e-5 * distance.upper)
      << each.text();
}

void expect_parallel_witness(const Case& each) {
  const BoundaryDistance& parallel = each.distances.parallel;
  expect_at_its_distance(each, parallel);
  if (!std::isfinite(parallel.upper)) return;
  const SingularityIndices here = singularity_indices(*each.robot, each.pose, each.distances.q);
  const SingularityIndices there = singularity_indices(*each.robot, parallel.witness, parallel.witness_q);
  EXPECT_LT(std::abs(there.smallest_singular_value), 1e-4) << each.text();
  EXPECT_LT(std::abs(there.determinant),
            1e-4 * std::abs(here.determinant) + 1e-6 * std::pow(each.robot->size(), 9))
      << each.text();
}

void expect_leg_witnesses(const Case& each) {
  const BoundaryDistance &serial = each.distances.serial, &limit = each.distances.actuated_limit;
  expect_at_its_distance(each, serial);
  if (std::isfinite(serial.upper)) {
    const Leg& leg = each.robot->leg(serial.leg);
    const double there = squared_inverse_entry(leg, serial.witness.transform(leg.anchor));
    const double here = squared_inverse_entry(leg, each.pose.transform(leg.anchor));
    EXPECT_LT(std::abs(there), 1e-6 * std::abs(here) + 1e-9 * std::pow(each.robot->size(), 2)) << each.text();
  }
  if (each.distances.status != ConfigurationStatus::measured) return;
  expect_at_its_distance(each, limit);
  if (!std::isfinite(limit.upper)) return;
  const JointLimits& limits = each.robot->leg(limit.leg).limits;
  const double end = limit.end == LimitEnd::lower ? limits.lower : limits.upper;
  const double gap = limit.witness_q[static_cast<Eigen::Index>(limit.leg)] - end;
  EXPECT_NEAR(each.robot->leg(limit.leg).actuated_by_angle() ? std::remainder(gap, 2.0 * EIGEN_PI) : gap, 0.0,
              1e-6)
      << each.text();
}

void expect_right(const Case& each, std::uint64_t seed, int samples) {
  ASSERT_NE(each.distances.status, ConfigurationStatus::invalid) << each.text();
  expect_no_boundary_below(each, seed, samples);
  expect_parallel_witness(each);
  expect_leg_witnesses(each);
}

void expect_right_distances(const Robot& robot, int configurations, int samples,
                            const std::shared_ptr<const DistanceMap>& map = nullptr) {
  BoundaryDistanceMeter meter(robot);
  meter.use(map);
  test::PosePairs random(robot, 20261121);
  for (int i = 0; i < configurations; ++i) {
    const WorkingMode mode = random.mode();
    const auto pose = random.reached(mode);
    ASSERT_TRUE(pose) << robot->name();
    expect_right({robot, *pose, mode, meter.measure(*pose, mode)}, 1000 + static_cast<std::uint64_t>(i),
                 samples);
  }
}

/// With limits of the actuated joints about where the robots work.
Robot limited(const Robot& robot, double lower, double upper) {
  ManipulatorDescription description;
  description.name = robot->name() + "_limited";
  description.task_space = robot->task_space();
  description.legs = robot->legs();
  for (Leg& leg : description.legs) leg.limits = JointLimits{lower, upper};
  return std::make_shared<const Manipulator>(description);
}

class EveryRobot : public testing::TestWithParam<Robot> {};

TEST_P(EveryRobot, HasNoBoundaryBelowTheLowerBoundAndOneAtTheWitness) {
  const bool six = GetParam()->leg_count() == 6;
  expect_right_distances(GetParam(), six ? 25 : 12, 500);
}

INSTANTIATE_TEST_SUITE_P(
    Distances, EveryRobot,
    testing::Values(test::five_bar(), limited(test::five_bar(), -1.0, 2.5), test::bipod(), test::three_rpr(),
                    test::three_rrr(), limited(test::three_rrr(), -2.0, 2.5),
                    test::three_rrr_actuated_elbow(), limited(test::three_rrr_actuated_elbow(), 0.3, 2.0),
                    test::three_prr(), limited(test::three_prr(), -0.5, 0.6), test::delta(),
                    limited(test::delta(), -0.8, 1.4), test::linear_delta(),
                    limited(test::linear_delta(), -0.3, 0.5), test::agile_eye(),
                    limited(test::agile_eye(), -2.0, 1.5), test::spherical_three_rrr(), test::stewart(),
                    limited(test::stewart(), 0.3, 1.0), test::dietmaier(), test::hexa(), test::six_pus()),
    [](const testing::TestParamInfo<Robot>& parameter) { return parameter.param->name(); });

/// A coarse map, made ready; within a box about the origin where one is given.
std::shared_ptr<const DistanceMap> coarse_map(const Robot& robot, double share,
                                              const std::optional<Box>& region = {}) {
  MapOptions options;
  options.resolution = robot->task_space() == TaskSpace::SO3 ? 20.0 * share : share * robot->size();
  options.region = region;
  options.extra_levels = 0;
  const MapResult result = compute_aspect_map(robot, options);
  EXPECT_TRUE(result) << result.message;
  return result ? std::make_shared<const DistanceMap>(result.map) : nullptr;
}

class EveryMappedRobot : public testing::TestWithParam<Robot> {};

TEST_P(EveryMappedRobot, HasNoBoundaryBelowTheBoundThatItsMapGives) {
  expect_right_distances(GetParam(), 15, 400, coarse_map(GetParam(), 0.08));
}

INSTANTIATE_TEST_SUITE_P(
    Distances, EveryMappedRobot,
    testing::Values(test::five_bar(), limited(test::five_bar(), -1.0, 2.5), test::bipod(), test::three_rpr(),
                    test::three_rrr(), test::three_rrr_actuated_elbow(),
                    limited(test::three_prr(), -0.5, 0.6), test::delta(), limited(test::delta(), -0.8, 1.4),
                    limited(test::linear_delta(), -0.3, 0.5), test::agile_eye(), test::spherical_three_rrr()),
    [](const testing::TestParamInfo<Robot>& parameter) { return parameter.param->name(); });

// Poses beyond the region of a map count, too.
TEST(Distances, HoldForRandomRobotsWithMaps) {
  test::RandomRobots random(20261122);
  int measured = 0;
  for (const TaskSpace space : test::all_task_spaces) {
    if (space == TaskSpace::SE3) continue;
    for (const test::ActuationKind kind : test::all_actuation_kinds)
      for (int i = 0; i < 2; ++i) {
        const Robot robot = random.robot(space, kind);
        const double half = 0.3 * robot->size();
        Box region{traits(space).translations, {}, {}};
        for (std::size_t k = 0; k < region.dimension; ++k) {
          region.lower[k] = -half;
          region.upper[k] = half;
        }
        const auto map = coarse_map(robot, 0.08, region);
        BoundaryDistanceMeter meter(robot, DistanceOptions{0.01, 200}), without(robot);
        meter.use(map);
        for (int k = 0; k < 6; ++k) {
          const Pose pose = random.pose(robot->motions(), 0.5);
          const std::vector<WorkingMode> modes = working_modes(*robot);
          const WorkingMode mode = modes[static_cast<std::size_t>(k) % modes.size()];
          if (inverse(*robot, pose, mode).status == InverseStatus::out_of_reach) continue;
          const Case each{robot, pose, mode, meter.measure(pose, mode)};
          expect_right(each, 1, 50);
          EXPECT_LE(each.distances.parallel.lower, without.measure(pose, mode).parallel.upper) << each.text();
          ++measured;
        }
      }
  }
  EXPECT_GT(measured, 50);
}

// Every kind of leg in every task space, of general geometry.
TEST(Distances, HoldForRandomRobots) {
  test::RandomRobots random(20261121);
  int measured = 0;
  for (const TaskSpace space : test::all_task_spaces)
    for (const test::ActuationKind kind : test::all_actuation_kinds)
      for (int i = 0; i < 40; ++i) {
        const Robot robot = random.robot(space, kind);
        const Pose pose = random.pose(robot->motions(), 0.5);
        const std::vector<WorkingMode> modes = working_modes(*robot);
        const WorkingMode mode = modes[static_cast<std::size_t>(i) % modes.size()];
        if (inverse(*robot, pose, mode).status == InverseStatus::out_of_reach) continue;
        BoundaryDistanceMeter meter(robot, DistanceOptions{0.01, 200});
        expect_right({robot, pose, mode, meter.measure(pose, mode)}, 1, 50);
        ++measured;
      }
  EXPECT_GT(measured, 200);
}

}  // namespace
}  // namespace parallel_aspects
