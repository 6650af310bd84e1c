// SPDX-License-Identifier: BSD-3-Clause
//
// Platforms that move smoothly through det A = 0: between samples the actuated joints then do not move
// straight.
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/robots.h"
#include "support/thoroughness.h"
#include <memory>
#include <ostream>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

struct Case {
  const char* name;
  std::shared_ptr<const Manipulator> (*make)();
};

std::ostream& operator<<(std::ostream& stream, const Case& each) { return stream << each.name; }

struct Counts {
  int crossings = 0, wrong = 0, followed = 0;
};

struct Encoders {
  double noise = 0.0;    // that there is, even to both sides [rad, or of the robot's size]
  double allowed = 0.0;  // that the tracker allows for
};

class SmoothMotion : public testing::TestWithParam<Case> {
 protected:
  // Along a segment of poses in `steps` samples: how often the tracker follows with another sign of det A
  // than the truth has.
  void move(const Pose& from, const Pose& to, const WorkingMode& mode, int steps, double bend,
            const Encoders& encoders, Counts& counts) {
    TrackerOptions options;
    options.samples.path_bend = bend;
    options.samples.encoder_noise = encoders.allowed;
    options.samples.check_velocity = false;
    Tracker tracker(robot, options);
    const JointVector start = inverse(*robot, from, mode).q;
    if (!tracker.start_near(0.0, start, from, 1e-6 * robot->size())) return;
    const int sign = test::sign_in_doubles(*robot, from, mode);
    counts.crossings += test::sign_in_doubles(*robot, to, mode) == -sign;
    for (int i = 1; i <= steps; ++i) {
      const Pose pose = pose_between(from, to, static_cast<double>(i) / steps);
      const InverseSolution solution = inverse(*robot, pose, mode);
      if (solution.status != InverseStatus::solved) return;
      const TrackedState& state = tracker.update(1e-3 * i, solution.q + noise(encoders.noise));
      if (!state.followed()) return;
      ++counts.followed;
      if (state.determinant_sign != test::sign_in_doubles(*robot, pose, mode)) {
        ++counts.wrong;
        first_wrong = to_string(mode) + " from " + to_string(robot->task_space(), from) + " to " +
                      to_string(robot->task_space(), to) + " in " + std::to_string(steps) + " steps";
        return;
      }
    }
  }

  JointVector noise(double size) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    JointVector result(static_cast<Eigen::Index>(robot->leg_count()));
    for (std::size_t j = 0; j < robot->leg_count(); ++j)
      result[static_cast<Eigen::Index>(j)] =
          size * uniform(random) * (robot->leg(j).actuated_by_angle() ? 1.0 : robot->size());
    return result;
  }

  Counts run(double bend, const Encoders& encoders = {}, int segments = 1500) {
    test::PosePairs pairs(robot, 20261121);
    Counts counts;
    for (int i = 0; i < test::thinned(segments); ++i) {
      const WorkingMode mode = pairs.mode();
      const auto from = pairs.reached(mode);
      if (!from) continue;
      const auto to = pairs.nearby(*from, mode);
      if (to) move(*from, *to, mode, i % 3 == 0 ? 50 : i % 3 == 1 ? 200 : 800, bend, encoders, counts);
    }
    return counts;
  }

  std::shared_ptr<const Manipulator> robot = GetParam().make();
  std::mt19937 random{20261122};
  std::string first_wrong;
};

TEST_P(SmoothMotion, IsNeverFollowedThroughAParallelSingularity) {
  const Counts counts = run(SampleOptions().path_bend);
  EXPECT_EQ(counts.wrong, 0) << first_wrong;
  EXPECT_GT(counts.crossings, test::thinned(40));
  EXPECT_GT(counts.followed, test::thinned(10000));
}

TEST_P(SmoothMotion, IsNotByNoisyEncodersEither) {
  const double noise = SampleOptions().encoder_noise;
  const Counts counts = run(SampleOptions().path_bend, {noise, noise});
  EXPECT_EQ(counts.wrong, 0) << first_wrong;
  EXPECT_GT(counts.crossings, test::thinned(40));
  EXPECT_GT(counts.followed, test::thinned(5000));
}

// What the allowance for bent paths is there for: chords alone miss the fold.
class StraightPaths : public SmoothMotion {};

TEST_P(StraightPaths, MissTheFold) { EXPECT_GT(run(0.0).wrong, 0); }

// And that for noise.
class UnknownNoise : public SmoothMotion {};

TEST_P(UnknownNoise, HidesTheFold) {
  if (test::is_sanitized) GTEST_SKIP() << "rare: so few segments need not show it";
  EXPECT_GT(run(SampleOptions().path_bend, {SampleOptions().encoder_noise, 0.0}, 6000).wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, SmoothMotion,
                         testing::Values(Case{"five_bar", test::five_bar}, Case{"three_rpr", test::three_rpr},
                                         Case{"three_rrr", test::three_rrr}, Case{"delta", test::delta},
                                         Case{"spherical", test::spherical_three_rrr},
                                         Case{"stewart", test::stewart}),
                         [](const auto& robot) { return std::string(robot.param.name); });
INSTANTIATE_TEST_SUITE_P(ThreeRpr, StraightPaths, testing::Values(Case{"three_rpr", test::three_rpr}),
                         [](const auto& robot) { return std::string(robot.param.name); });

INSTANTIATE_TEST_SUITE_P(FiveBar, UnknownNoise, testing::Values(Case{"five_bar", test::five_bar}),
                         [](const auto& robot) { return std::string(robot.param.name); });

}  // namespace
}  // namespace parallel_aspects
