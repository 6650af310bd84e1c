// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/segment_proof.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/sign_at.h"
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr int robots_of_crossings = 30, paths_of_a_robot = 400, points_of_a_path = 200;

/// Straight paths in the plane of random five-bars, and what single points of them say.
class CrossingProofs : public testing::Test {
 protected:
  void next_robot() {
    robot = random.robot(TaskSpace::T2, test::ActuationKind::revolute);
    modes = working_modes(*robot);
    classifier = make_box_classifier(*robot, modes);
    region = *classifier->reachable_positions();
  }

  CrossingPath path() {
    CrossingPath result;
    result.segments[0].dimension = 2;
    for (std::size_t i = 0; i < 2; ++i) {
      result.segments[0].from[i] = random.uniform(region.lower[i], region.upper[i]);
      result.segments[0].to[i] = random.uniform(region.lower[i], region.upper[i]);
    }
    return result;
  }

  static Pose pose_on(const CrossingPath& path, int point) {
    const CrossingSegment& segment = path.segments[0];
    const double share = static_cast<double>(point) / points_of_a_path;
    return Pose::planar(segment.from[0] + share * (segment.to[0] - segment.from[0]),
                        segment.from[1] + share * (segment.to[1] - segment.from[1]));
  }

  std::optional<int> sign(const Pose& pose, std::size_t mode) const {
    return test::sign_at(*robot, pose, modes[mode]);
  }

  bool reaches(const Pose& pose, std::size_t leg) const {
    return squared_inverse_entry(robot->leg(leg), pose.transform(robot->leg(leg).anchor)) > 0.0;
  }

  /// The mode that differs in this leg.
  std::size_t flipped(std::size_t mode, std::size_t leg) const {
    WorkingMode other = modes[mode];
    other.set_sign(leg, -other.sign(leg));
    return static_cast<std::size_t>(std::find(modes.begin(), modes.end(), other) - modes.begin());
  }

  test::RandomRobots random{20261128};
  std::shared_ptr<const Manipulator> robot;
  std::vector<WorkingMode> modes;
  std::unique_ptr<const BoxClassifier> classifier;
  Box region;
};

// In both modes, up to where the leg reaches no more.
TEST_F(CrossingProofs, OfSerialSingularitiesKeepTheSignBeforeThem) {
  int proofs = 0;
  for (int i = 0; i < robots_of_crossings; ++i) {
    next_robot();
    for (int k = 0; k < paths_of_a_robot; ++k) {
      const CrossingPath tried = path();
      const std::size_t leg = k % 2 == 0 ? 0 : 1, mode = static_cast<std::size_t>(k / 2) % modes.size();
      const int expected = sign(pose_on(tried, 0), mode).value_or(0);
      if (expected == 0) continue;
      const std::size_t other = flipped(mode, leg);
      {
        const RoundingUpward rounding;
        if (!crosses_serial_singularity(*classifier, tried, mode, other, leg, expected)) continue;
      }
      ++proofs;
      EXPECT_FALSE(reaches(pose_on(tried, points_of_a_path), leg));
      for (int point = 0; reaches(pose_on(tried, point), leg); ++point)
        for (const std::size_t each : {mode, other})
          ASSERT_EQ(sign(pose_on(tried, point), each).value_or(expected), expected)
              << "robot " << i << ", path " << k << ", point " << point << ", mode "
              << to_string(modes[each]);
    }
  }
  EXPECT_GT(proofs, 200);
}

// From where det A is positive to where it is negative, and never back.
TEST_F(CrossingProofs, OfParallelSingularitiesChangeTheSignOnce) {
  int proofs = 0;
  for (int i = 0; i < robots_of_crossings; ++i) {
    next_robot();
    for (int k = 0; k < paths_of_a_robot; ++k) {
      const CrossingPath tried = path();
      const std::size_t mode = static_cast<std::size_t>(k) % modes.size();
      if (sign(pose_on(tried, 0), mode) != 1 || sign(pose_on(tried, points_of_a_path), mode) != -1) continue;
      {
        const RoundingUpward rounding;
        if (!crosses_parallel_singularity(*classifier, tried, mode)) continue;
      }
      ++proofs;
      int last = 1;
      for (int point = 0; point <= points_of_a_path; ++point) {
        const int here = sign(pose_on(tried, point), mode).value_or(last);
        ASSERT_TRUE(here == last || (here == -1 && last == 1))
            << "robot " << i << ", path " << k << ", point " << point << ", mode " << to_string(modes[mode]);
        last = here;
      }
    }
  }
  EXPECT_GT(proofs, 100);
}

}  // namespace
}  // namespace parallel_aspects
