// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Basic regions and uniqueness domains of slices of legs of any kind, against the complete direct solver and
// against steps between poses.

namespace parallel_aspects {
namespace {

using test::Robot;

/// A robot with a joint held at a value, and what is known of its slice.
struct Slice {
  Robot robot;
  HeldJoint held;
  std::shared_ptr<const Uniqueness> found;

  Slice(const Robot& of, std::size_t leg, double value)
      : robot(of),
        held{leg, value, of->leg(leg).actuated_by_angle()},
        found(test::uniqueness_of_slice(robot, leg, value)) {}

  Pose random_pose(test::RandomRobots& random) const {
    return circle_of_anchor(*robot, held).pose(random.uniform(-pi, pi), random.uniform(-pi, pi));
  }

  std::string text(const Pose& pose) const {
    return robot->name() + ", joint " + std::to_string(held.leg + 1) + " at " + std::to_string(held.value) +
           ": " + to_string(robot->task_space(), pose);
  }

 private:
  static constexpr double pi = 3.14159265358979324;
};

std::vector<Slice> computed_slices() {
  std::vector<Slice> result;
  const Robot three_rrr = test::three_rrr()->with_constraints({});
  result.emplace_back(three_rrr, 0, 0.3);
  if (!test::is_sanitized) result.emplace_back(three_rrr, 1, 1.7);
  result.emplace_back(test::shipped("three_prr")->manipulator()->with_constraints({}), 2, 0.3);
  std::vector<Leg> legs(three_rrr->legs().begin(), three_rrr->legs().end());
  legs[1].limits = JointLimits{2.5, 4.0};
  legs[2].limits = JointLimits{-1.0, 1.0};
  result.emplace_back(test::manipulator("limited", TaskSpace::SE2, legs), 0, 1.2);
  return result;
}

const std::vector<Slice>& slices() {
  static const std::vector<Slice> all = computed_slices();
  return all;
}

/// The value that is held, with rounding: of the leg whose joint is held it is that of the slice.
std::optional<JointVector> actuated_at(const Slice& slice, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution found = inverse(*slice.robot, pose, mode);
  if (!found || !slice.robot->within_limits(found.q)) return std::nullopt;
  JointVector q = found.q;
  const auto held = static_cast<Eigen::Index>(slice.held.leg);
  if (std::abs(std::remainder(q[held] - slice.held.value,
                              slice.held.is_angle ? 2.0 * 3.14159265358979324 : 1e9)) > 1e-9)
    return std::nullopt;
  q[held] = slice.held.value;
  return q;
}

struct Solution {
  Pose pose;
  WorkingMode mode;
  std::size_t region = 0;
};

/// Those whose region is known, of the direct solutions of the values of a pose.
std::vector<Solution> located_solutions(const Slice& slice, const JointVector& q) {
  std::vector<Solution> result;
  const DirectResult all = direct(*slice.robot, q);
  for (const AssemblyMode& each : all.solutions) {
    const auto mode = working_mode(*slice.robot, each.pose, q);
    const auto region = mode ? slice.found->locate(each.pose, *mode) : std::nullopt;
    if (region) result.push_back({each.pose, *mode, *region});
  }
  return result;
}

void expect_apart(const Slice& slice, const Solution& a, const Solution& b) {
  const BasicRegion &one = slice.found->basic_regions[a.region],
                    &other = slice.found->basic_regions[b.region];
  EXPECT_FALSE(one.is_unique && a.region == b.region) << slice.text(a.pose);
  EXPECT_TRUE(a.mode != b.mode || one.over == other.over) << slice.text(a.pose);
  EXPECT_NE(slice.found->sharing(a.region, b.region), DomainSharing::shared) << slice.text(a.pose);
}

// No two solutions of the same values are in one region, nor in one domain.
TEST(SliceUniqueness, HoldsOneSolutionInARegionAndInADomain) {
  test::RandomRobots random(31);
  std::size_t poses = 0, located = 0, pairs = 0;
  for (const Slice& slice : slices()) {
    ASSERT_TRUE(slice.found && slice.found->has_domains);
    for (int n = 0; n < (test::is_sanitized ? 40 : 200); ++n) {
      const Pose pose = slice.random_pose(random);
      for (const WorkingMode& mode : working_modes(*slice.robot)) {
        const auto q = actuated_at(slice, pose, mode);
        if (!q) continue;
        ++poses;
        const std::vector<Solution> solutions = located_solutions(slice, *q);
        if (slice.found->locate(pose, mode)) ++located;
        for (std::size_t i = 0; i < solutions.size(); ++i) {
          const int aspect = slice.found->map->locate(solutions[i].pose, solutions[i].mode).aspect;
          const int listed = slice.found->basic_regions[solutions[i].region].aspect;
          EXPECT_TRUE(aspect == 0 || listed == 0 || aspect == listed) << slice.text(solutions[i].pose);
          for (std::size_t j = 0; j < i; ++j, ++pairs) expect_apart(slice, solutions[i], solutions[j]);
        }
      }
    }
  }
  RecordProperty("located", std::to_string(located) + " of " + std::to_string(poses));
  EXPECT_GT(10 * located, 7 * poses);
  EXPECT_GT(pairs, 20U);
}

/// Steps of a walk through the poses of one aspect.
struct Steps {
  std::size_t within = 0, across = 0, across_shared = 0, across_apart = 0;
};

Steps walk(const Slice& slice, test::RandomRobots& random) {
  Steps result;
  const AnchorCircle circle = circle_of_anchor(*slice.robot, slice.held);
  double a = random.uniform(-3.1, 3.1), phi = random.uniform(-3.1, 3.1);
  const double da = random.uniform(-2e-3, 2e-3), dphi = random.uniform(-2e-3, 2e-3);
  const auto modes = working_modes(*slice.robot);
  for (const WorkingMode& mode : modes) {
    int aspect = 0;
    std::optional<std::size_t> last;
    for (int k = 0; k < 200; ++k, a += da, phi += dphi) {
      const Pose pose = circle.pose(a, phi);
      const int now = slice.found->map->locate(pose, mode).aspect;
      if (now == 0 || (aspect != 0 && now != aspect) || !actuated_at(slice, pose, mode)) break;
      aspect = now;
      const auto region = slice.found->locate(pose, mode);
      if (region && last && *region != *last) {
        const DomainSharing sharing = slice.found->sharing(*last, *region);
        // From one region over a set to another over it a way leads through others.
        EXPECT_NE(slice.found->basic_regions[*last].over, slice.found->basic_regions[*region].over)
            << slice.text(pose);
        ++result.across;
        if (sharing == DomainSharing::shared) ++result.across_shared;
        if (sharing == DomainSharing::apart) ++result.across_apart;
      } else if (region && last) {
        ++result.within;
      }
      if (region) last = region;
    }
  }
  return result;
}

// From region to region of an aspect, in small steps: mostly the next one is in a domain with it.
TEST(SliceUniqueness, JoinsRegionsThatAWalkLeadsThrough) {
  test::RandomRobots random(32);
  for (const Slice& slice : slices()) {
    Steps all;
    for (int n = 0; n < (test::is_sanitized ? 4 : 16); ++n) {
      const Steps steps = walk(slice, random);
      all.within += steps.within;
      all.across += steps.across;
      all.across_shared += steps.across_shared;
      all.across_apart += steps.across_apart;
    }
    RecordProperty(slice.robot->name(), std::to_string(all.within) + " within, " +
                                            std::to_string(all.across) + " across, shared " +
                                            std::to_string(all.across_shared));
    EXPECT_EQ(all.across_apart, 0U) << slice.robot->name();
    EXPECT_GE(10 * all.across_shared, 8 * all.across) << slice.robot->name();
  }
}

}  // namespace
}  // namespace parallel_aspects
