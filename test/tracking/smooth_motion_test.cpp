// SPDX-License-Identifier: BSD-3-Clause
//
// Platforms that move smoothly through det A = 0: between samples the actuated joints then do not move
// straight.
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots.h"
#include "support/thoroughness.h"
#include <memory>
#include <ostream>
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

class SmoothMotion : public testing::TestWithParam<Case> {
 protected:
  // Along a segment of poses in `steps` samples: how often the tracker follows with another sign of det A
  // than the truth has.
  void move(const Pose& from, const Pose& to, const WorkingMode& mode, int steps, double bend,
            Counts& counts) {
    TrackerOptions options;
    options.samples.path_bend = bend;
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
      const TrackedState& state = tracker.update(1e-3 * i, solution.q);
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

  Counts run(double bend) {
    test::PosePairs pairs(robot, 20261121);
    Counts counts;
    for (int i = 0; i < test::thinned(1500); ++i) {
      const WorkingMode mode = pairs.mode();
      const auto from = pairs.reached(mode);
      if (!from) continue;
      const auto to = pairs.nearby(*from, mode);
      if (to) move(*from, *to, mode, i % 3 == 0 ? 50 : i % 3 == 1 ? 200 : 800, bend, counts);
    }
    return counts;
  }

  std::shared_ptr<const Manipulator> robot = GetParam().make();
  std::string first_wrong;
};

TEST_P(SmoothMotion, IsNeverFollowedThroughAParallelSingularity) {
  const Counts counts = run(SampleOptions().path_bend);
  EXPECT_EQ(counts.wrong, 0) << first_wrong;
  EXPECT_GT(counts.crossings, test::thinned(40));
  EXPECT_GT(counts.followed, test::thinned(10000));
}

// What the allowance for bent ways is there for: chords alone miss the fold.
class StraightPaths : public SmoothMotion {};

TEST_P(StraightPaths, MissTheFold) { EXPECT_GT(run(0.0).wrong, 0); }

INSTANTIATE_TEST_SUITE_P(Robots, SmoothMotion,
                         testing::Values(Case{"five_bar", test::five_bar}, Case{"three_rpr", test::three_rpr},
                                         Case{"three_rrr", test::three_rrr}, Case{"delta", test::delta},
                                         Case{"spherical", test::spherical_three_rrr},
                                         Case{"stewart", test::stewart}),
                         [](const auto& robot) { return std::string(robot.param.name); });
INSTANTIATE_TEST_SUITE_P(ThreeRpr, StraightPaths, testing::Values(Case{"three_rpr", test::three_rpr}),
                         [](const auto& robot) { return std::string(robot.param.name); });

}  // namespace
}  // namespace parallel_aspects
