// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/mode_uniqueness.h"

#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// All poses of robots with legs of any kind, by working mode, against the complete direct solver and against
// singular poses that bisection finds.

namespace parallel_aspects {
namespace {

using test::ActuationKind;
using test::Robot;

constexpr double turn = 6.28318530717958648;
constexpr std::size_t cells_of_test = 8000;

struct Whole {
  Robot robot;
  std::shared_ptr<const Uniqueness> found;

  explicit Whole(const Robot& of) : robot(of) {
    UniquenessOptions options;
    options.most_cells = cells_of_test;
    found = test::uniqueness_of(robot, options);
  }

  std::string text(const JointVector& q) const {
    std::ostringstream text;
    text << robot->name() << " at " << q.transpose();
    return text.str();
  }

  /// All angles of a joint without limits.
  JointVector random_values(test::RandomRobots& random) const {
    JointVector q(3);
    for (std::size_t j = 0; j < 3; ++j) {
      const JointLimits& limits = robot->leg(j).limits;
      const bool is_free = !std::isfinite(limits.upper - limits.lower);
      q[static_cast<Eigen::Index>(j)] =
          is_free ? random.uniform(-0.5 * turn, 0.5 * turn) : random.uniform(limits.lower, limits.upper);
    }
    return q;
  }

  /// Where it is no singularity that bisection comes to.
  bool is_at_limit(const JointVector& q) const {
    for (std::size_t j = 0; j < 3; ++j) {
      const JointLimits& limits = robot->leg(j).limits;
      const double value = q[static_cast<Eigen::Index>(j)];
      if (value - limits.lower < 1e-9 || limits.upper - value < 1e-9) return true;
    }
    return false;
  }

  double all_values() const {
    double product = 1.0;
    for (const Leg& leg : robot->legs())
      product *=
          std::isfinite(leg.limits.upper - leg.limits.lower) ? leg.limits.upper - leg.limits.lower : turn;
    return product;
  }
};

/// A leg of each kind, with limits; of the crank beyond half a turn.
Robot mixed_robot(unsigned seed) {
  test::RandomRobots random(seed);
  std::vector<Leg> legs;
  for (const ActuationKind kind : {ActuationKind::strut, ActuationKind::revolute, ActuationKind::prismatic})
    legs.push_back(random.robot(TaskSpace::SE2, kind)->leg(legs.size()));
  legs[0].limits = legs[0].has_branch(1) ? JointLimits{0.3, 2.0} : JointLimits{-2.0, -0.3};
  legs[1].limits = JointLimits{2.0, 5.5};
  legs[2].limits = JointLimits{-1.5, 1.5};
  return test::manipulator("mixed " + std::to_string(seed), TaskSpace::SE2, legs);
}

/// Cranks that are shorter than their rods, without limits.
Robot short_cranks() {
  return test::manipulator("short cranks", TaskSpace::SE2,
                           {test::planar_revolute_leg(0, {0.0, 0.0}, 0.5, 1.1, {-0.3, -0.2}),
                            test::planar_revolute_leg(1, {2.0, 0.1}, 0.45, 1.2, {0.35, -0.25}),
                            test::planar_revolute_leg(2, {0.9, 1.8}, 0.4, 1.0, {0.0, 0.4})});
}

const std::vector<Whole>& robots() {
  static const std::vector<Whole> all = [] {
    std::vector<Whole> result;
    result.emplace_back(test::shipped("three_prr")->manipulator());
    result.emplace_back(mixed_robot(3));
    if (!test::is_sanitized) result.emplace_back(short_cranks());
    return result;
  }();
  return all;
}

/// Direct solutions by working mode; nothing where not all are regular.
std::optional<std::map<std::size_t, std::vector<Pose>>> solutions_by_mode(const Robot& robot,
                                                                          const JointVector& q) {
  std::map<std::size_t, std::vector<Pose>> result;
  const DirectResult all = direct(*robot, q);
  for (const AssemblyMode& each : all.solutions) {
    const auto mode = working_mode(*robot, each.pose, q);
    if (!mode) return std::nullopt;
    result[mode->index()].push_back(each.pose);
  }
  return result;
}

std::map<int, int> numbers_of(const std::vector<int>& aspects) {
  std::map<int, int> result;
  for (const int aspect : aspects) ++result[aspect];
  return result;
}

struct Drawn {
  std::size_t compared = 0, unlisted = 0;
};

// What has solutions of a mode and no number is unlisted.
void compare(const Whole& of, const JointVector& q, const WorkingMode& mode, const std::vector<Pose>& poses,
             Drawn& drawn) {
  const auto component = of.found->component_at(q, mode);
  if (!component && !poses.empty()) ++drawn.unlisted;
  if (!component) return;
  const BasicComponent& listed = of.found->basic_components[*component];
  EXPECT_EQ(listed.mode, mode);
  EXPECT_EQ(listed.solutions.size(), poses.size()) << of.text(q) << ' ' << to_string(mode);
  ++drawn.compared;
  std::vector<int> aspects;
  for (const Pose& pose : poses) aspects.push_back(of.found->map->locate(pose, mode).aspect);
  const auto numbers = numbers_of(aspects), expected = numbers_of(listed.aspects);
  if (numbers.count(0) > 0 || expected.count(0) > 0) return;
  EXPECT_EQ(numbers, expected) << of.text(q) << ' ' << to_string(mode);
}

TEST(ModeUniqueness, HasTheNumbersOfTheDirectProblemInEachAspect) {
  test::RandomRobots random(41);
  for (const Whole& of : robots()) {
    ASSERT_TRUE(of.found && of.found->by_mode);
    const int samples = test::is_sanitized ? 1000 : 3000;
    Drawn drawn;
    for (int n = 0; n < samples; ++n) {
      const JointVector q = of.random_values(random);
      const auto solutions = solutions_by_mode(of.robot, q);
      if (!solutions) continue;
      for (const WorkingMode& mode : working_modes(*of.robot)) {
        const auto there = solutions->find(mode.index());
        compare(of, q, mode, there == solutions->end() ? std::vector<Pose>{} : there->second, drawn);
      }
    }
    EXPECT_GT(drawn.compared, 20U) << of.robot->name();
    const double unlisted = static_cast<double>(drawn.unlisted) / samples;
    EXPECT_LE(of.all_values() * (unlisted - 5.0 * std::sqrt(std::max(unlisted, 1.0 / samples) / samples)),
              of.found->measure_unknown);
  }
}

struct Located {
  WorkingMode mode;
  std::size_t region = 0;
};

// No two solutions of the same values are in one region, nor in one domain.
TEST(ModeUniqueness, HoldsOneSolutionInARegionAndInADomain) {
  test::RandomRobots random(42);
  for (const Whole& of : robots()) {
    std::size_t poses = 0, located = 0, pairs = 0;
    for (int n = 0; n < (test::is_sanitized ? 1000 : 3000); ++n) {
      const JointVector q = of.random_values(random);
      std::vector<Located> there;
      for (const AssemblyMode& each : direct(*of.robot, q).solutions) {
        const auto mode = working_mode(*of.robot, each.pose, q);
        if (!mode) continue;
        ++poses;
        const auto region = of.found->locate(each.pose, *mode);
        if (!region) continue;
        ++located;
        for (const Located& other : there) {
          const BasicRegion &a = of.found->basic_regions[*region], &b = of.found->basic_regions[other.region];
          EXPECT_FALSE(a.is_unique && *region == other.region) << of.text(q);
          EXPECT_TRUE(other.mode != *mode || a.over == b.over) << of.text(q);
          EXPECT_NE(of.found->sharing(*region, other.region), DomainSharing::shared) << of.text(q);
          ++pairs;
        }
        there.push_back({*mode, *region});
      }
    }
    RecordProperty(of.robot->name(), std::to_string(located) + " of " + std::to_string(poses));
    EXPECT_GT(pairs, 5U) << of.robot->name();
    EXPECT_GT(4 * located, poses) << of.robot->name();
  }
}

/// What a working mode knows of a pose: its values and det A; nothing out of reach.
struct Known {
  JointVector q;
  double determinant = 0.0;
};

std::optional<Known> known_at(const Robot& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution found = inverse(*robot, pose, mode);
  if (!found || !found.q.allFinite()) return std::nullopt;
  return Known{found.q, direct_determinant(*robot, pose, found.q)};
}

Pose between(const Pose& a, const Pose& b, double t) {
  return {(1.0 - t) * a.position + t * b.position, a.orientation.slerp(t, b.orientation)};
}

/// The last values before what is singular between two poses: where det A changes its sign, or a leg is
/// stretched or folded.
JointVector nearly_singular(const Robot& robot, const WorkingMode& mode, const Pose& from, const Pose& to) {
  double known = 0.0, beyond = 1.0;
  Known last = *known_at(robot, from, mode);
  for (int k = 0; k < 60; ++k) {
    const double t = 0.5 * (known + beyond);
    const auto there = known_at(robot, between(from, to, t), mode);
    const bool is_before = there && there->determinant * last.determinant > 0.0;
    (is_before ? known : beyond) = t;
    if (is_before) last = *there;
  }
  return last.q;
}

// The last values before it are as near as doubles tell, so that rounding may have them on either side.
TEST(ModeUniqueness, HasNoSetThatHoldsTheImageOfASingularPose) {
  test::RandomRobots random(43);
  for (const Whole& of : robots()) {
    const double size = of.robot->size();
    std::size_t found = 0;
    for (int n = 0; n < (test::is_sanitized ? 2000 : 10000); ++n) {
      const Pose from = random.pose(TaskSpace::SE2, size), to = random.pose(TaskSpace::SE2, size);
      for (const WorkingMode& mode : working_modes(*of.robot)) {
        const auto start = known_at(of.robot, from, mode), end = known_at(of.robot, to, mode);
        if (!start || (end && start->determinant * end->determinant > 0.0)) continue;
        const JointVector q = nearly_singular(of.robot, mode, from, to);
        if (of.is_at_limit(q)) continue;
        ++found;
        EXPECT_FALSE(of.found->component_at(q, mode)) << of.text(q) << ' ' << to_string(mode);
      }
    }
    EXPECT_GT(found, test::is_sanitized ? 5U : 50U) << of.robot->name();
  }
}

// Sets of angles go on where these begin again.
TEST(ModeUniqueness, JoinsSetsAcrossTheTurnOfAnAngle) {
  if (test::is_sanitized) GTEST_SKIP() << "takes long";
  const Whole& of = robots().back();
  test::RandomRobots random(44);
  std::size_t both = 0, same = 0;
  for (int n = 0; n < 4000; ++n) {
    JointVector before = of.random_values(random);
    const auto axis = static_cast<Eigen::Index>(n % 3);
    before[axis] = 0.5 * turn - 1e-6;
    JointVector behind = before;
    behind[axis] = -0.5 * turn + 1e-6;
    for (const WorkingMode& mode : working_modes(*of.robot)) {
      const auto a = of.found->component_at(before, mode), b = of.found->component_at(behind, mode);
      if (!a || !b) continue;
      ++both;
      same += *a == *b ? 1 : 0;
      JointVector turned = before;
      turned[axis] -= turn;
      EXPECT_EQ(of.found->component_at(turned, mode), a);
    }
  }
  EXPECT_GT(both, 100U);
  EXPECT_GT(100 * same, 99 * both);
}

}  // namespace
}  // namespace parallel_aspects
