// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/choose_working_mode.h"

#include <gtest/gtest.h>

#include "support/path_samples.h"
#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::path_text;
using test::side;
using test::Waypoints;
using At = test::ConfigurationAt<long double>;

// Poses at even times, by formulas of the test.
std::vector<PoseWaypoint> dense(const Waypoints& waypoints, int count) {
  std::vector<PoseWaypoint> poses;
  for (std::size_t i = 1; i < waypoints.size(); ++i)
    for (int k = 0; k <= count; ++k) {
      const double share = static_cast<double>(k) / count;
      const PoseWaypoint &from = waypoints[i - 1], &to = waypoints[i];
      poses.push_back(
          {(1.0 - share) * from.time + share * to.time, test::mixed_pose(from.pose, to.pose, share)});
    }
  return poses;
}

// The first time that the path is seen to leave its aspect, with room for rounding; infinite where it is not.
double first_failure(const Manipulator& robot, const Waypoints& samples, const WorkingMode& mode) {
  const long double sign = At(robot, samples.front().pose, mode).parallel() > 0 ? 1 : -1;
  for (const PoseWaypoint& sample : samples) {
    const At at(robot, sample.pose, mode);
    if (at.squared_serial() < -1e-15L || (at.reaches() && sign * at.parallel() < -1e-15L)) return sample.time;
  }
  return std::numeric_limits<double>::infinity();
}

class RandomToolPaths : public testing::TestWithParam<const char*> {
 protected:
  Waypoints draw() {
    const WorkingMode mode = pairs.mode();
    Waypoints waypoints;
    if (const auto start = pairs.reached(mode)) waypoints.push_back({0.0, *start});
    for (int i = 0; i < 3 && !waypoints.empty(); ++i)
      if (const auto next = pairs.nearby(waypoints.back().pose, mode))
        waypoints.push_back({waypoints.back().time + pairs.uniform(0.1, 2.0), *next});
    return waypoints;
  }

  // Of random poses as near as the clearance says no singularity separates any from the path.
  void expect_clear(const ModeOnPath& found, const Waypoints& samples) {
    const int sign = side(*robot, samples.front().pose, found.mode);
    const bool turns = has_rotation(robot->task_space());
    for (int i = 0; i < test::thinned(200); ++i) {
      const PoseWaypoint& near = samples[engine() % samples.size()];
      TaskVector twist = TaskVector::Zero(static_cast<Eigen::Index>(robot->leg_count()));
      for (double& entry : twist) entry = pairs.uniform(-1.0, 1.0);
      if (turns) twist[0] = 0.0;
      const double reach = 0.999 * std::min(found.clearance->lower, 10.0 * robot->size());
      const Pose pose = displaced(robot->motions(), near.pose, twist / twist.norm() * reach);
      EXPECT_EQ(side(*robot, pose, found.mode), sign) << to_string(found.mode);
    }
  }

  std::shared_ptr<const Manipulator> robot =
      test::shipped(GetParam())->manipulator()->with_constraints(ConstraintKinds{});
  SegmentCertifier certifier{robot};
  test::PosePairs pairs{robot, 20261123};
  std::mt19937_64 engine{7};
};

TEST_P(RandomToolPaths, AreAnsweredInEveryWorkingModeAsBruteForceSays) {
  int safe = 0, unsafe = 0, unknown = 0, several = 0;
  PathChoiceOptions options;
  options.measures = 60;
  for (int i = 0; i < test::thinned(100); ++i) {
    const Waypoints waypoints = draw();
    if (waypoints.size() < 2) continue;
    SCOPED_TRACE(path_text(*robot, waypoints));
    const Waypoints samples = dense(waypoints, test::thinned(500));
    const PathChoice choice = choose_working_mode(certifier, waypoints, options);
    ASSERT_EQ(choice.modes.size(), working_modes(*robot).size());
    int safe_here = 0;
    for (const ModeOnPath& mode : choice.modes) {
      const double failure = first_failure(*robot, samples, mode.mode);
      const double step = 2.0 * waypoints.back().time / test::thinned(500);
      switch (mode.check.answer) {
        case TrajectoryAnswer::safe:
          ++safe_here;
          EXPECT_EQ(failure, std::numeric_limits<double>::infinity()) << to_string(mode.mode);
          EXPECT_EQ(mode.determinant_sign, side(*robot, waypoints.front().pose, mode.mode));
          expect_clear(mode, samples);
          EXPECT_LE(mode.clearance->lower, mode.clearance->measured);
          break;
        case TrajectoryAnswer::unsafe:
          ++unsafe;
          EXPECT_GE(failure, mode.check.violation->after) << to_string(mode.mode);
          // What lasts for less than a step may be missed, and what cannot be decided makes the bracket wide.
          if (failure < waypoints.back().time &&
              mode.check.violation->before - mode.check.violation->after < step) {
            EXPECT_LE(mode.check.violation->before, failure + step) << to_string(mode.mode);
          }
          break;
        case TrajectoryAnswer::unknown:
          ++unknown;
          EXPECT_GE(failure, mode.check.free_until) << to_string(mode.mode);
          break;
      }
    }
    safe += safe_here;
    several += safe_here > 1 ? 1 : 0;
    EXPECT_EQ(choice.answer == TrajectoryAnswer::safe, safe_here > 0);
    for (int k = 1; k < safe_here; ++k) {
      const auto at = static_cast<std::size_t>(k);
      EXPECT_GE(choice.modes[at - 1].clearance->lower, choice.modes[at].clearance->lower);
    }
  }
  std::cout << GetParam() << ": safe " << safe << ", unsafe " << unsafe << ", unknown " << unknown
            << ", paths with several safe modes " << several << '\n';
  EXPECT_GT(safe, 0);
  EXPECT_GT(unsafe, 0);
  EXPECT_GT(several, 0);
  EXPECT_LE(20 * unknown, safe + unsafe);
}

INSTANTIATE_TEST_SUITE_P(Robots, RandomToolPaths, testing::Values("five_bar", "three_rrr", "delta"),
                         [](const auto& each) { return std::string(each.param); });

class FiveBarPath : public testing::Test {
 protected:
  PathChoice choose(Preference preference) const {
    PathChoiceOptions options;
    options.preference = preference;
    return choose_working_mode(certifier, path, options);
  }

  // Joint angles of both cranks by the law of cosines, whose lengths the test reads from the robot.
  std::vector<double> angles(const Pose& pose, const WorkingMode& mode) const {
    std::vector<double> result;
    for (std::size_t j = 0; j < 2; ++j) {
      const Leg& leg = robot->leg(j);
      const auto& crank = std::get<RevoluteActuation>(leg.actuation);
      const Eigen::Vector3d d = pose.position + leg.anchor - crank.center;
      const double r = d.norm(), l = crank.radius;
      const double bend = std::acos((l * l + r * r - leg.rod_length * leg.rod_length) / (2.0 * l * r));
      result.push_back(std::atan2(d.y(), d.x()) - mode.sign(j) * bend);
    }
    return result;
  }

  std::shared_ptr<const Manipulator> robot =
      test::shipped("five_bar")->manipulator()->with_constraints(ConstraintKinds{});
  SegmentCertifier certifier{robot};
  Waypoints path{{0.0, Pose::planar(3.0, 6.0)}, {1.0, Pose::planar(5.0, 7.0)}, {2.0, Pose::planar(6.0, 5.0)}};
};

TEST_F(FiveBarPath, TravelAndTimeAreThoseOfTheCranks) {
  const PathChoice choice = choose(Preference::clear);
  const Waypoints samples = dense(path, 2000);
  for (const ModeOnPath& mode : choice.modes) {
    if (mode.check.answer != TrajectoryAnswer::safe) continue;
    double travel = 0.0, time = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const auto a = angles(samples[i - 1].pose, mode.mode), b = angles(samples[i].pose, mode.mode);
      double longest = 0.0;
      for (std::size_t j = 0; j < 2; ++j) {
        const double change = std::abs(std::remainder(b[j] - a[j], 2.0 * EIGEN_PI));
        travel += change;
        longest = std::max(longest, change / robot->leg(j).limits.velocity);
      }
      time += longest;
    }
    EXPECT_NEAR(mode.total_travel(), travel, 1e-3 * travel) << to_string(mode.mode);
    EXPECT_NEAR(mode.least_time, time, 1e-3 * time) << to_string(mode.mode);
  }
}

TEST_F(FiveBarPath, TheBestIsBestByWhatIsPreferred) {
  const PathChoice clear = choose(Preference::clear), travel = choose(Preference::travel),
                   fast = choose(Preference::fast);
  ASSERT_EQ(clear.answer, TrajectoryAnswer::safe);
  for (const ModeOnPath& mode : clear.modes) {
    if (mode.check.answer != TrajectoryAnswer::safe) continue;
    EXPECT_LE(mode.clearance->lower, clear.modes.front().clearance->lower);
    EXPECT_GE(mode.total_travel(), travel.modes.front().total_travel());
    EXPECT_GE(mode.least_time, fast.modes.front().least_time);
  }
  EXPECT_NE(clear.modes.front().mode, travel.modes.front().mode);
}

TEST_F(FiveBarPath, AnAspectIsReportedWhereThereIsAMap) {
  const auto map = compute_aspect_map(robot).map;
  PathChoiceOptions options;
  options.map = map.get();
  for (const ModeOnPath& mode : choose_working_mode(certifier, path, options).modes) {
    ASSERT_GT(mode.aspect, 0);
    const Aspect& aspect = map->aspects()[static_cast<std::size_t>(mode.aspect - 1)];
    EXPECT_EQ(aspect.mode, mode.mode);
    EXPECT_EQ(aspect.determinant_sign, mode.determinant_sign);
  }
}

TEST_F(FiveBarPath, WhatIsCancelledIsUnknown) {
  const std::atomic<bool> cancelled{true};
  PathChoiceOptions options;
  options.control.cancelled = &cancelled;
  const PathChoice choice = choose_working_mode(certifier, path, options);
  EXPECT_EQ(choice.answer, TrajectoryAnswer::unknown);
  EXPECT_NE(choice.modes.front().check.reason.find("cancelled"), std::string::npos);
}

TEST_F(FiveBarPath, AStartOutOfReachRulesOutAModeAndNotTheQuestion) {
  const Waypoints far{{0.0, Pose::planar(4.5, 90.0)}, {1.0, Pose::planar(4.5, 8.0)}};
  EXPECT_TRUE(problems_of(*robot, far, Preference::clear).empty());
  const PathChoice choice = choose_working_mode(certifier, far);
  EXPECT_EQ(choice.answer, TrajectoryAnswer::unsafe);
  for (const ModeOnPath& mode : choice.modes) {
    ASSERT_TRUE(mode.check.violation);
    EXPECT_EQ(mode.check.violation->kind, Violation::out_of_reach);
    EXPECT_EQ(mode.check.violation->before, 0.0);
  }
}

TEST_F(FiveBarPath, BadInputIsSaidInOneSentenceEach) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PoseWaypoint good = path[0], far{1.5, Pose::planar(4.5, 90.0)};
  const auto count = [&](const Waypoints& waypoints) {
    return problems_of(*robot, waypoints, Preference::clear).size();
  };
  EXPECT_EQ(count(path), 0U);
  EXPECT_EQ(count({good}), 0U);
  EXPECT_EQ(count({}), 1U);
  EXPECT_EQ(count({path[1], path[0]}), 1U);
  EXPECT_EQ(count({far, path[1]}), 1U);
  EXPECT_EQ(count({{nan, far.pose}, path[1]}), 1U);
  EXPECT_EQ(count({far, {2.0, Pose::planar(nan, 0.0)}}), 1U);
  EXPECT_EQ(problems_of(*robot, path, Preference::fast).size(), 0U);
}

TEST(FastWithoutLimits, IsRefused) {
  ManipulatorDescription description = test::shipped("five_bar")->manipulator()->description();
  for (Leg& leg : description.legs) leg.limits.velocity = std::numeric_limits<double>::infinity();
  const Manipulator robot(description);
  const Waypoints path{{0.0, Pose::planar(3.0, 6.0)}};
  EXPECT_EQ(problems_of(robot, path, Preference::fast).size(), 1U);
  EXPECT_EQ(problems_of(robot, path, Preference::clear).size(), 0U);
}

}  // namespace
}  // namespace parallel_aspects
