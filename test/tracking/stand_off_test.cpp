// SPDX-License-Identifier: BSD-3-Clause
//
// How near det A = 0 a robot that stands still is followed by encoders that are noisy.
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include "support/tracking_campaign.h"
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

struct Path {
  Pose from, singular;
  WorkingMode mode;
  double length = 0.0;  // [m]
};

SampleOptions with_noise(double noise) {
  SampleOptions options;
  options.encoder_noise = noise;
  return options;
}

class StandOffOf : public testing::TestWithParam<const char*> {
 protected:
  // From a random configuration to the nearest pose with det A = 0 that was found.
  std::optional<Path> path() {
    for (int i = 0; i < 100; ++i) {
      const WorkingMode mode = pairs_.mode();
      const auto pose = pairs_.reached(mode);
      if (!pose) continue;
      const BoundaryDistance nearest = meter_.measure(*pose, mode).parallel;
      if (std::isfinite(nearest.upper) && nearest.upper > 0.02 * robot_->size())
        return Path{*pose, nearest.witness, mode, anchor_distance(*robot_, *pose, nearest.witness)};
    }
    return std::nullopt;
  }

  // Whether a robot that stands still so far from the singular pose is followed; actuated joints are anywhere
  // in their noise, and every other time at its ends.
  bool follows(const Path& path, double distance, double noise, int samples) {
    const Pose pose = pose_between(path.from, path.singular, 1.0 - distance / path.length);
    TrackerOptions options;
    options.samples = with_noise(noise);
    options.samples.check_velocity = false;
    Tracker tracker(robot_, options);
    const JointVector q = inverse(*robot_, pose, path.mode).q;
    if (!tracker.start_near(0.0, q, pose, 1e-3 * robot_->size())) return false;
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 1; i <= samples; ++i) {
      JointVector noisy = q;
      for (Eigen::Index j = 0; j < q.size(); ++j) {
        const double unit =
            robot_->leg(static_cast<std::size_t>(j)).actuated_by_angle() ? 1.0 : robot_->size();
        const double share = uniform(random_);
        noisy[j] += noise * unit * (i % 2 == 0 ? share : std::copysign(1.0, share));
      }
      if (!tracker.update(1e-3 * i, noisy).followed()) return false;
    }
    return true;
  }

  const std::shared_ptr<const Manipulator> robot_ = test::shipped(GetParam())->manipulator();
  test::PosePairs pairs_{robot_, 20261122};
  BoundaryDistanceMeter meter_{robot_};
  std::mt19937 random_{7};
};

TEST_P(StandOffOf, IsWhereARobotThatStandsStillIsFollowed) {
  constexpr double noise = 1e-5;
  int tried = 0, lost_inside = 0;
  for (int i = 0; i < test::thinned(20); ++i) {
    const auto tested = path();
    if (!tested) continue;
    const double stand_off =
        StandOff(robot_, with_noise(noise)).along_path(tested->from, tested->singular, tested->mode);
    ASSERT_GE(stand_off, 0.0);
    if (!(1.01 * stand_off < tested->length)) continue;
    ++tried;
    EXPECT_TRUE(follows(*tested, 1.01 * stand_off, noise, test::thinned(1000)))
        << stand_off << " to " << to_string(robot_->task_space(), tested->singular);
    lost_inside += !follows(*tested, 0.25 * stand_off, noise, 1000);
  }
  EXPECT_GE(2 * lost_inside, tried) << "no farther than it must be";
}

// Not so where a leg is stretched or folded besides: there actuated joints hardly move the platform, and it
// is less.
TEST_P(StandOffOf, GrowsWithTheSquareRootOfTheNoise) {
  int tried = 0, grown = 0;
  for (int i = 0; i < test::thinned(20); ++i) {
    const auto tested = path();
    if (!tested || !(meter_.measure(tested->singular, tested->mode).serial.lower > 0.02 * robot_->size()))
      continue;
    const auto at = [&](double noise) {
      return StandOff(robot_, with_noise(noise)).along_path(tested->from, tested->singular, tested->mode);
    };
    const double little = at(1e-8), more = at(1e-6);
    if (!(more < 0.2 * tested->length)) continue;
    ++tried;
    grown += std::abs(more / little - 10.0) < 2.0;
  }
  EXPECT_GE(grown, 0.7 * tried) << tried;
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, StandOffOf, testing::ValuesIn(test::campaign_robots),
                         [](const testing::TestParamInfo<const char*>& tested) {
                           return std::string(tested.param);
                         });

TEST(EstimateStandOff, IsTheLargestThatWasFound) {
  const auto robot = test::shipped("five_bar")->manipulator();
  const StandOffEstimate few = estimate_stand_off(robot, with_noise(1e-4), 10);
  const StandOffEstimate more = estimate_stand_off(robot, with_noise(1e-4), 100);
  EXPECT_EQ(few.poses, 10);
  EXPECT_EQ(more.poses, 100);
  EXPECT_GT(few.largest, 0.0);
  EXPECT_GE(more.largest, few.largest);
  EXPECT_LT(estimate_stand_off(robot, with_noise(1e-6), 100).largest, more.largest);
}

}  // namespace
}  // namespace parallel_aspects
