// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/check_trajectory.h"

#include "motion/check/check_text.h"

#include <gtest/gtest.h>

#include "support/configuration_at.h"
#include "support/pose_pairs.h"
#include "support/robots/constrained_robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Waypoints = std::vector<PoseWaypoint>;

// What dense sampling in extended precision says of a trajectory, by formulas of the test.
class Truth {
 public:
  Truth(const Manipulator& robot, const Waypoints& waypoints, const WorkingMode& mode)
      : robot_(robot), waypoints_(waypoints), mode_(mode) {
    sign_ = At(robot_, waypoints_.front().pose, mode_).parallel() > 0 ? 1.0L : -1.0L;
  }

  double end() const { return waypoints_.back().time; }

  // Not positive where a singularity is passed, a leg cannot reach or a limit is left.
  long double clearance(double time) const {
    const At at(robot_, pose(time), mode_);
    return at.reaches() ? std::min({at.squared_serial(), at.within_limits(), sign_ * at.parallel()})
                        : at.squared_serial();
  }

  // Whether every leg reaches and det A has the sign that the crossings leave it, at samples up to where the
  // trajectory was followed. Where they do not, the time.
  double first_wrong_sign(const TrajectoryCheck& check, double interval) const {
    for (double time = waypoints_.front().time; time < check.followed_until; time += interval) {
      long double sign = sign_;
      bool is_open = false;
      for (const TrajectoryCrossing& each : check.crossings) {
        if (each.before < time) sign = -sign;
        is_open = is_open || (each.after <= time && time <= each.before);
      }
      const At at(robot_, pose(time), mode_);
      if (!is_open && !(at.reaches() && sign * at.parallel() > 0)) return time;
    }
    return std::numeric_limits<double>::infinity();
  }

  // Of samples at even times; infinite where there is none.
  double first_violation(double interval) const {
    for (double time = waypoints_.front().time; time < waypoints_.back().time; time += interval)
      if (clearance(time) < -1e-15L) return time;
    return std::numeric_limits<double>::infinity();
  }

 private:
  using At = test::ConfigurationAt<long double>;

  Pose pose(double time) const {
    std::size_t i = 1;
    while (i + 1 < waypoints_.size() && waypoints_[i].time < time) ++i;
    const PoseWaypoint &from = waypoints_[i - 1], &to = waypoints_[i];
    const double share = std::clamp((time - from.time) / (to.time - from.time), 0.0, 1.0);
    Pose result;
    result.position = (1.0 - share) * from.pose.position + share * to.pose.position;
    const Eigen::Vector4d first = from.pose.orientation.coeffs(), last = to.pose.orientation.coeffs();
    const Eigen::Vector4d mixed = (1.0 - share) * first + share * (first.dot(last) < 0.0 ? -last : last);
    result.orientation.coeffs() = mixed.normalized();
    return result;
  }

  const Manipulator& robot_;
  const Waypoints& waypoints_;
  WorkingMode mode_;
  long double sign_ = 1;
};

// Of each robot.
int trajectories() {
  const char* wanted = std::getenv("CHECKED_TRAJECTORIES");
  return wanted != nullptr ? static_cast<int>(std::strtoul(wanted, nullptr, 10)) : test::thinned(300);
}

struct Tally {
  int safe = 0, unsafe = 0, unknown = 0;
  std::size_t crossings = 0;
};

class RandomPaths : public testing::TestWithParam<const char*> {
 protected:
  Waypoints draw(const WorkingMode& mode) {
    Waypoints waypoints;
    const auto start = pairs.reached(mode);
    if (!start) return {};
    waypoints.push_back({pairs.uniform(-1.0, 1.0), *start});
    for (int i = 0; i < 3; ++i) {
      const auto next = pairs.nearby(waypoints.back().pose, mode);
      if (next) waypoints.push_back({waypoints.back().time + pairs.uniform(0.1, 2.0), *next});
    }
    return waypoints;
  }

  std::string text(const Waypoints& waypoints, const WorkingMode& mode) const {
    std::string result = robot->name() + " in " + to_string(mode);
    for (const PoseWaypoint& waypoint : waypoints) {
      result += "\n" + std::to_string(waypoint.time);
      const PoseCoordinates coordinates = pose_coordinates(robot->task_space(), waypoint.pose);
      for (Eigen::Index i = 0; i < coordinates.size(); ++i) {
        char digits[40];
        std::snprintf(digits, sizeof digits, ", %.17g", coordinates[i]);
        result += digits;
      }
    }
    return result;
  }

  std::shared_ptr<const Manipulator> robot = test::with_actuated_limits(GetParam());
  SegmentCertifier certifier{robot};
  test::PosePairs pairs{robot, 20261123};
};

void compare_violation(const TrajectoryCheck& check, const Truth& truth, double interval) {
  ASSERT_TRUE(check.violation);
  const TrajectoryViolation& found = *check.violation;
  ASSERT_LE(found.after, found.before);
  const double seen = truth.first_violation(interval);
  EXPECT_GE(seen, found.after);
  // What cannot be decided, such as a determinant that touches zero, makes the bracket wide.
  if (found.before - found.after > interval) {
    EXPECT_LE(std::abs(truth.clearance(found.after)), 1e-6L);
  }
  // What lasts for less than an interval may be missed by samples, but not here.
  const double room = std::min(found.before - found.after, interval);
  long double least = std::numeric_limits<long double>::infinity();
  for (int i = -50; i <= 50; ++i) least = std::min(least, truth.clearance(found.before + room * i / 50.0));
  EXPECT_LE(least, 1e-13L);
  if (found.before + interval < truth.end() && truth.clearance(found.before + interval) < -1e-15L) {
    EXPECT_LE(seen, found.before + interval);
  }
}

TEST_P(RandomPaths, AreAnsweredAsDenseSamplesInExtendedPrecisionSay) {
  Tally tally;
  for (int i = 0; i < trajectories(); ++i) {
    const WorkingMode mode = pairs.mode();
    const Waypoints waypoints = draw(mode);
    if (waypoints.size() < 2) continue;
    SCOPED_TRACE(text(waypoints, mode));
    const TrajectoryCheck check = check_trajectory(certifier, waypoints, mode);
    const Truth truth(*robot, waypoints, mode);
    const double interval = (waypoints.back().time - waypoints.front().time) / test::thinned(1000);
    EXPECT_EQ(truth.first_wrong_sign(check, interval), std::numeric_limits<double>::infinity());
    tally.crossings += check.crossings.size();
    if (check.answer == TrajectoryAnswer::safe) {
      EXPECT_EQ(truth.first_violation(interval), std::numeric_limits<double>::infinity());
    }
    if (check.answer == TrajectoryAnswer::unsafe) compare_violation(check, truth, interval);
    if (check.answer == TrajectoryAnswer::unknown) {
      EXPECT_GE(truth.first_violation(interval), check.free_until);
    }
    ++(check.answer == TrajectoryAnswer::safe     ? tally.safe
       : check.answer == TrajectoryAnswer::unsafe ? tally.unsafe
                                                  : tally.unknown);
  }
  std::cout << GetParam() << ": safe " << tally.safe << ", unsafe " << tally.unsafe << ", unknown "
            << tally.unknown << ", crossings " << tally.crossings << '\n';
  EXPECT_GT(tally.safe, 0);
  if (robot->name() != "agile_eye") {
    EXPECT_GT(tally.unsafe, 0);
  }  // it has no surface of singular poses
  EXPECT_LE(20 * tally.unknown, tally.safe + tally.unsafe);
}

INSTANTIATE_TEST_SUITE_P(Robots, RandomPaths,
                         testing::Values("five_bar", "bipod", "three_rpr", "three_rrr", "three_prr", "delta",
                                         "linear_delta", "agile_eye", "spherical_3rrr"),
                         [](const auto& each) { return std::string(each.param); });

class FiveBarPaths : public testing::Test {
 protected:
  TrajectoryCheck check(const Waypoints& waypoints) const {
    return check_trajectory(certifier, waypoints, mode);
  }

  std::shared_ptr<const Manipulator> robot = test::with_actuated_limits("five_bar");
  SegmentCertifier certifier{robot};
  WorkingMode mode = *WorkingMode::from_signs({-1, 1});
};

TEST_F(FiveBarPaths, OutOfReachNamesTheLegAndTheTime) {
  const TrajectoryCheck found = check({{0.0, Pose::planar(4.5, 8.0)}, {2.0, Pose::planar(4.5, 30.0)}});
  ASSERT_EQ(found.answer, TrajectoryAnswer::unsafe) << found.reason;
  EXPECT_EQ(found.violation->kind, Violation::out_of_reach);
  EXPECT_TRUE(found.violation->leg);
  EXPECT_LT(found.violation->before, 2.0);
  EXPECT_NEAR(found.violation->after, found.violation->before, 1e-5);
}

TEST_F(FiveBarPaths, IndicesAndSpeedsAreSampledOnTheWay) {
  const TrajectoryCheck found = check({{0.0, Pose::planar(4.5, 8.0)}, {0.01, Pose::planar(4.6, 8.0)}});
  ASSERT_EQ(found.answer, TrajectoryAnswer::safe) << found.reason;
  EXPECT_GT(found.parallel_index.value, 0.0);
  EXPECT_LT(found.parallel_index.value, 1.0);
  EXPECT_GT(found.serial_index.value, 0.0);
  ASSERT_EQ(found.speeds.size(), 2U);
  EXPECT_GT(found.speeds[0].value, 0.1);
  EXPECT_LE(found.speeds[0].bound, 1.01 * found.speeds[0].value);
}

TEST_F(FiveBarPaths, BadInputIsSaidInOneSentenceEach) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PoseWaypoint good{0.0, Pose::planar(4.5, 8.0)}, later{1.0, Pose::planar(4.6, 8.0)};
  EXPECT_TRUE(problems_of(*robot, {good, later}, mode).empty());
  EXPECT_EQ(problems_of(*robot, {}, mode).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {later, good}, mode).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, good}, mode).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {nan, good.pose}}, mode).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {2.0, Pose::planar(nan, 0.0)}}, mode).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good}, WorkingMode(3)).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {{0.0, Pose::planar(4.5, 90.0)}, later}, mode).size(), 1U);
  for (const double huge : {1e300, -1e308, 2e12}) {
    EXPECT_EQ(problems_of(*robot, {good, {2.0, Pose::planar(huge, 0.0)}}, mode).size(), 1U);
    EXPECT_EQ(problems_of(*robot, {{-std::abs(huge), good.pose}, {std::abs(huge), good.pose}}, mode).size(),
              2U);
  }
  EXPECT_EQ(problems_of(*robot, {good, {1e-12, later.pose}}, mode).size(), 1U);
  EXPECT_EQ(check({}).answer, TrajectoryAnswer::unknown);
  EXPECT_TRUE(check({}).refused);
  EXPECT_NE(check({}).reason, "");
}

TEST_F(FiveBarPaths, AStartBelowAMarginIsRefusedWithByHowMuch) {
  Constraints constraints;
  constraints.margins.parallel = 0.99;
  ConstraintKinds margins;
  margins[index_of(ConstraintKind::margins)] = true;
  const auto guarded = test::with(robot, constraints)->with_constraints(margins);
  const Waypoints waypoints{{0.0, Pose::planar(4.5, 8.0)}, {1.0, Pose::planar(4.6, 8.0)}};
  const TrajectoryCheck found = check_trajectory(SegmentCertifier(guarded), waypoints, mode);
  EXPECT_TRUE(found.refused);
  EXPECT_NE(found.reason.find("below the margin 0.99"), std::string::npos) << found.reason;
}

TEST_F(FiveBarPaths, BothEndsOfABracketDiffer) {
  const std::array<std::string, 2> close = bracket_text(4.875683006, 4.875683006 + 1e-14);
  EXPECT_NE(close[0], close[1]);
  EXPECT_EQ(bracket_text(1.0, 2.0)[0], "1");
  EXPECT_EQ(bracket_text(0.5, 0.5)[1], "0.5");
}

TEST_F(FiveBarPaths, WhatIsCancelledIsUnknown) {
  const std::atomic<bool> cancelled{true};
  TrajectoryCheckOptions options;
  options.control.cancelled = &cancelled;
  const Waypoints waypoints{{0.0, Pose::planar(4.5, 8.0)}, {1.0, Pose::planar(4.6, 8.0)}};
  EXPECT_EQ(check_trajectory(certifier, waypoints, mode, options).answer, TrajectoryAnswer::unknown);
}

}  // namespace
}  // namespace parallel_aspects
