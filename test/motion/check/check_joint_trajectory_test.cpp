// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/newton_platform.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::advance;
using test::halvings;
using test::JointWaypoints;
using test::never;
using test::Number;
using test::Numbers;
using test::Platform;
using test::Seen;
using test::values_at;
using test::watch;

// Of each robot: as many as CHECKED_TRAJECTORIES says, or `few`; in SE3 a tenth of these, since the test's
// own way takes long there.
int trajectories(int few, bool is_se3) {
  const char* wanted = std::getenv("CHECKED_TRAJECTORIES");
  if (wanted != nullptr) return static_cast<int>(std::strtoul(wanted, nullptr, 10));
  return test::thinned(is_se3 ? few / 10 : few);
}

bool in_a_bracket(const TrajectoryCheck& check, Number time) {
  return std::any_of(check.crossings.begin(), check.crossings.end(), [time](const TrajectoryCrossing& each) {
    return each.after <= time && time <= each.before;
  });
}

// Changed by each crossing of the leg, and by nothing else.
Number expected_sign(const TrajectoryCheck& check, std::size_t leg, Number time) {
  Number sign = 1;
  for (const TrajectoryCrossing& each : check.crossings)
    if (each.leg == leg && each.before < time) sign = -sign;
  return sign;
}

// The signs of B_jj and of det A at every sample up to where the trajectory was followed. How often one of
// B_jj changes.
std::size_t compare_crossings(const TrajectoryCheck& check, const Manipulator& robot,
                              const JointWaypoints& waypoints, const Pose& start, int samples) {
  Platform platform(robot, start);
  std::vector<Number> entries;
  std::vector<Number> last;
  std::size_t changes = 0;
  Number determinant = 0;
  if (!begin(platform, waypoints.front())) return changes;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
    for (int k = 0; k <= samples; ++k) {
      const JointWaypoint &from = waypoints[i], &to = waypoints[i + 1];
      const double length = to.time - from.time, time = from.time + length * k / samples;
      if (time > check.followed_until) return changes;
      const double before = from.time + length * std::max(0, k - 1) / samples;
      const Numbers q = values_at(from, to, time);
      if (!advance(platform, from, to, before, time, halvings)) return changes;
      if (entries.empty()) determinant = platform.determinant(q);
      EXPECT_GT(platform.determinant(q) * determinant, 0) << time;
      for (std::size_t j = 0; j < robot.leg_count(); ++j) {
        const Number entry = platform.entry(j, q[static_cast<Eigen::Index>(j)]);
        if (entries.size() < robot.leg_count()) entries.push_back(entry);
        if (last.size() < robot.leg_count()) last.push_back(entry);
        if (last[j] * entry < 0) ++changes;
        last[j] = entry;
        if (!in_a_bracket(check, time)) {
          EXPECT_GT(entry * entries[j] * expected_sign(check, j, time), 0) << time << " leg " << j;
        }
      }
    }
  return changes;
}

// By differences of samples, which are mean speeds.
void compare_speeds(const TrajectoryCheck& check, const JointWaypoints& waypoints, int samples) {
  if (check.speeds.empty()) return;
  std::vector<Number> fastest(check.speeds.size(), 0);
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const JointWaypoint &from = waypoints[i], &to = waypoints[i + 1];
    const Number step = (Number(to.time) - from.time) / samples;
    for (int k = 1; k <= samples && from.time + step * k <= check.free_until; ++k) {
      const Numbers change =
          values_at(from, to, from.time + step * k) - values_at(from, to, from.time + step * (k - 1));
      for (std::size_t j = 0; j < fastest.size(); ++j)
        fastest[j] = std::max(fastest[j], std::abs(change[static_cast<Eigen::Index>(j)]) / step);
    }
  }
  for (std::size_t j = 0; j < fastest.size(); ++j) {
    EXPECT_GE(check.speeds[j].bound * (1 + 1e-12), fastest[j]) << j;
    EXPECT_LE(check.speeds[j].value, check.speeds[j].bound) << j;
    EXPECT_GE(check.speeds[j].value * 1.002, fastest[j]) << j;
  }
}

class RandomJoints : public testing::TestWithParam<const char*> {
 protected:
  JointVector noise(const JointVector& scale, double share) {
    JointVector values(scale.size());
    for (Eigen::Index j = 0; j < scale.size(); ++j) values[j] = scale[j] * pairs.uniform(-share, share);
    return values;
  }

  // Towards joint values of nearby poses, some of them in a neighbouring mode, with each interpolation.
  JointWaypoints draw(const Pose& start, const WorkingMode& mode, int kind) {
    JointWaypoints waypoints{{pairs.uniform(-1.0, 1.0), inverse(*robot, start, mode).q, {}, {}}};
    for (int i = 0; i < 2; ++i) {
      WorkingMode next = mode;
      const std::size_t leg =
          static_cast<std::size_t>(pairs.uniform(0.0, 1.0) * 0.999 * double(robot->leg_count()));
      if (pairs.uniform(0.0, 1.0) < 0.3 && robot->leg(leg).has_branch(-mode.sign(leg)))
        next.set_sign(leg, -mode.sign(leg));
      const auto pose = pairs.nearby(start, mode);
      const JointVector target = inverse(*robot, pose.value_or(start), next).q;
      const JointVector change = target - waypoints.back().q;
      waypoints.push_back({waypoints.back().time + pairs.uniform(0.5, 2.0), target, {}, {}});
      const JointVector scale = JointVector::Constant(change.size(), change.cwiseAbs().maxCoeff());
      for (JointWaypoint* each : {&waypoints[waypoints.size() - 2], &waypoints.back()}) {
        if (kind > 0) each->velocity = noise(scale, 0.5);
        if (kind > 1) each->acceleration = noise(scale, 1.0);
      }
    }
    return waypoints;
  }

  std::shared_ptr<const Manipulator> robot = test::with_actuated_limits(GetParam());
  SegmentCertifier certifier{robot};
  test::PosePairs pairs{robot, 20261124};
};

void compare(const TrajectoryCheck& check, const Seen& seen) {
  const double first = std::min(seen.violation, seen.lost);
  EXPECT_GE(first, check.free_until) << check.reason;
  if (check.answer != TrajectoryAnswer::unsafe) return;
  ASSERT_TRUE(check.violation);
  EXPECT_LE(check.violation->after, check.violation->before);
}

std::string text(const Manipulator& robot, const JointWaypoints& waypoints, const Pose& start) {
  std::string result = robot.name() + " from " + to_string(robot.task_space(), start);
  for (const JointWaypoint& waypoint : waypoints)
    for (const JointVector& values : {waypoint.q, waypoint.velocity, waypoint.acceleration})
      for (Eigen::Index j = 0; j < values.size(); ++j) {
        char digits[40];
        std::snprintf(digits, sizeof digits, ", %.17g", values[j]);
        result += (j == 0 ? "\n" + std::to_string(waypoint.time) : "") + digits;
      }
  return result;
}

TEST_P(RandomJoints, AreAnsweredAsNewtonsMethodInExtendedPrecisionSees) {
  int answers[3] = {0, 0, 0}, seen_at[2] = {0, 0}, tight = 0;
  std::size_t crossings = 0, changes = 0;
  const bool is_se3 = robot->task_space() == TaskSpace::SE3;
  const int samples = is_se3 ? 60 : test::thinned(300);
  for (int i = 0; i < trajectories(70, is_se3); ++i) {
    const WorkingMode mode = pairs.mode();
    const auto start = pairs.reached(mode);
    if (!start) continue;
    const JointWaypoints waypoints = draw(*start, mode, i % 3);
    SCOPED_TRACE(text(*robot, waypoints, *start));
    const TrajectoryCheck check = check_trajectory(certifier, waypoints, {*start, 0});
    Seen seen = watch(*robot, waypoints, *start, samples);
    // Newton's method may slip to another assembly mode where steps are too long.
    if (std::min(seen.violation, seen.lost) < check.free_until)
      seen = watch(*robot, waypoints, *start, 30 * samples);
    const double interval = 2.0 / samples;
    compare(check, seen);
    changes += compare_crossings(check, *robot, waypoints, *start, samples);
    compare_speeds(check, waypoints, samples);
    for (const TrajectoryCrossing& each : check.crossings) crossings += each.leg ? 1 : 0;
    if (check.answer == TrajectoryAnswer::safe) {
      EXPECT_EQ(std::min(seen.violation, seen.lost), never);
    }
    ++answers[static_cast<int>(check.answer)];
    if (check.violation && check.violation->before - check.violation->after <= interval) ++tight;
    // Where unsafe, the sample after the bracket or the one that follows sees it.
    if (check.answer == TrajectoryAnswer::unsafe &&
        std::min(seen.violation, seen.lost) <= check.violation->before + interval)
      ++seen_at[0];
    if (check.answer == TrajectoryAnswer::unknown && std::min(seen.violation, seen.lost) < never)
      ++seen_at[1];
  }
  std::cout << GetParam() << ": safe " << answers[0] << ", unsafe " << answers[1] << " (seen within a sample "
            << seen_at[0] << ", bracket that short " << tight << "), unknown " << answers[2]
            << " (violated or lost " << seen_at[1] << "), changes of B_jj " << crossings << " (sampled "
            << changes << ")\n";
  EXPECT_TRUE(test::is_sanitized || is_se3 || answers[0] > 0);
  EXPECT_GE(20 * seen_at[0], 19 * answers[1]);
  EXPECT_LE(20 * crossings, 24 * changes + 100);  // samples miss short pairs
  EXPECT_GE(10 * tight, 9 * answers[1]);          // of others, what is met first is not decided
}

INSTANTIATE_TEST_SUITE_P(Robots, RandomJoints,
                         testing::Values("five_bar", "bipod", "three_rpr", "three_rrr", "three_prr", "delta",
                                         "linear_delta", "spherical_3rrr", "stewart", "hexa"),
                         [](const auto& each) { return std::string(each.param); });

class FiveBarJoints : public testing::Test {
 protected:
  JointVector joints(double x, double y) const { return inverse(*robot, Pose::planar(x, y), mode).q; }

  std::shared_ptr<const Manipulator> robot = test::with_actuated_limits("five_bar");
  SegmentCertifier certifier{robot};
  WorkingMode mode = *WorkingMode::from_signs({-1, 1});
  Pose pose = Pose::planar(4.5, 8.0);
};

TEST_F(FiveBarJoints, AnAmbiguousStartIsSaid) {
  const JointWaypoints waypoints{{0.0, joints(4.5, 8.0), {}, {}}, {1.0, joints(4.6, 8.0), {}, {}}};
  const TrajectoryCheck ambiguous = check_trajectory(certifier, waypoints, {});
  EXPECT_EQ(ambiguous.answer, TrajectoryAnswer::unknown);
  EXPECT_TRUE(ambiguous.refused);
  ASSERT_EQ(ambiguous.possible_starts.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(telling_sign(ambiguous.possible_starts, i), ambiguous.possible_starts[i].determinant_sign);
    EXPECT_FALSE(check_trajectory(certifier, waypoints, {ambiguous.possible_starts[i].pose, 0}).refused);
  }
  EXPECT_NE(ambiguous.reason.find("2 assembly modes"), std::string::npos) << ambiguous.reason;
  EXPECT_EQ(check_trajectory(certifier, waypoints, {pose, 0}).answer, TrajectoryAnswer::safe);
  EXPECT_EQ(check_trajectory(certifier, waypoints, {{}, 1}).answer, TrajectoryAnswer::safe);
  EXPECT_EQ(check_trajectory(certifier, waypoints, {{}, -1}).answer, TrajectoryAnswer::safe);
}

TEST_F(FiveBarJoints, BadInputIsSaidInOneSentenceEach) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const JointVector q = joints(4.5, 8.0), few = JointVector::Zero(1);
  const JointWaypoint good{0.0, q, {}, {}};
  EXPECT_TRUE(problems_of(*robot, {good}, {pose, 0}).empty());
  EXPECT_EQ(problems_of(*robot, JointWaypoints{}, TrajectoryStart{}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, good}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {nan, q, {}, {}}}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {1.0, few, {}, {}}}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {1.0, q, few, {}}}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {1.0, q, {}, q}}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good}, {Pose::planar(4.9, 8.0), 0}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good}, {Pose::planar(nan, 8.0), 0}).size(), 1U);
}

}  // namespace
}  // namespace parallel_aspects
