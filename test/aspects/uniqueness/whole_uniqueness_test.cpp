// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <variant>
#include <vector>

// All poses of robots with three struts, against the direct solver and integration.

namespace parallel_aspects {
namespace {

using test::Robot;
using test::uniform;

constexpr std::size_t few_cells = 24000;

std::shared_ptr<const Uniqueness> computed(const Robot& robot, std::size_t cells) {
  UniquenessOptions options;
  options.most_cells = cells;
  return test::uniqueness_of(robot, options);
}

/// Of the 3-RPR, computed once.
const Uniqueness& whole() {
  static const std::shared_ptr<const Uniqueness> uniqueness = computed(test::three_rpr(), few_cells);
  return *uniqueness;
}

const Manipulator& robot_of(const Uniqueness& uniqueness) { return *uniqueness.map->manipulator(); }

JointVector random_values(const Manipulator& robot, std::mt19937_64& random) {
  JointVector q(3);
  for (std::size_t j = 0; j < 3; ++j) {
    const JointLimits& limits = robot.leg(j).limits;
    q[static_cast<Eigen::Index>(j)] = uniform(random, limits.lower, limits.upper);
  }
  return q;
}

double volume_of_values(const Manipulator& robot) {
  double product = 1.0;
  for (const Leg& leg : robot.legs()) product *= leg.limits.upper - leg.limits.lower;
  return product;
}

/// Random struts, with lengths that begin anywhere and grow either way with the joint.
Robot random_struts(std::mt19937_64& random) {
  test::Points base, anchors;
  for (int j = 0; j < 3; ++j) {
    base.emplace_back(uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0), 0.0);
    anchors.emplace_back(uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0), 0.0);
  }
  std::vector<Leg> legs = test::struts(base, anchors);
  for (Leg& leg : legs) {
    auto& strut = std::get<StrutActuation>(leg.actuation);
    strut.sense = uniform(random, -1.0, 1.0) > 0.0 ? 1.0 : -1.0;
    strut.length_at_zero = strut.sense > 0.0 ? 0.25 : 4.0;
    leg.limits = strut.sense > 0.0 ? JointLimits{0.25, 3.25} : JointLimits{0.5, 3.5};
  }
  return test::manipulator("random_struts", TaskSpace::SE2, legs);
}

/// How many solutions have det A of a sign.
std::size_t count_of_sign(const DirectResult& found, int sign) {
  std::size_t count = 0;
  for (const AssemblyMode& mode : found.solutions) count += mode.determinant * sign > 0.0 ? 1 : 0;
  return count;
}

/// The same of a basic component; nothing where the map does not tell all aspects.
std::optional<std::size_t> count_of_sign(const Uniqueness& uniqueness, const BasicComponent& component,
                                         int sign) {
  std::size_t count = 0;
  for (const int id : component.aspects) {
    if (id == 0) return std::nullopt;
    count += uniqueness.map->aspects()[static_cast<std::size_t>(id - 1)].determinant_sign == sign ? 1 : 0;
  }
  return count;
}

/// Compares numbers at random values; returns at how many they are known.
int compare_numbers(const Uniqueness& uniqueness, std::mt19937_64& random, int samples) {
  const Manipulator& robot = robot_of(uniqueness);
  int known = 0;
  for (int i = 0; i < samples; ++i) {
    const JointVector q = random_values(robot, random);
    const auto index = uniqueness.component_at(q);
    if (!index) continue;
    ++known;
    const BasicComponent& component = uniqueness.basic_components[*index];
    const DirectResult found = direct(robot, q);
    EXPECT_EQ(component.solutions.size(), found.solutions.size()) << q.transpose();
    for (const int sign : {1, -1}) {
      const auto count = count_of_sign(uniqueness, component, sign);
      EXPECT_TRUE(!count || *count == count_of_sign(found, sign)) << q.transpose();
    }
  }
  return known;
}

TEST(WholeUniqueness, HasTheNumbersOfTheDirectProblemInEachAspect) {
  std::mt19937_64 random(31);
  const int samples = test::thinned(5000);
  EXPECT_GT(compare_numbers(whole(), random, samples), 0.9 * samples);
  for (const BasicComponent& component : whole().basic_components)
    EXPECT_TRUE(component.measure_lower < 1.0 || count_of_sign(whole(), component, 1));
}

TEST(WholeUniqueness, HasTheNumbersOfOtherRobots) {
  std::mt19937_64 random(32);
  const int samples = test::thinned(2000);
  for (int robots = 0; robots < (test::is_sanitized ? 1 : 3); ++robots) {
    const auto found = computed(random_struts(random), few_cells / 3);
    EXPECT_GT(compare_numbers(*found, random, samples), 0.1 * samples);
  }
}

// Bounds of measures, against counting.
TEST(WholeUniqueness, HasTheMeasuresOfTheDirectProblem) {
  std::mt19937_64 random(33);
  const int samples = test::thinned(20000);
  const double volume = volume_of_values(robot_of(whole()));
  std::map<std::size_t, int> counts;
  for (int i = 0; i < samples; ++i)
    ++counts[direct(robot_of(whole()), random_values(robot_of(whole()), random)).solutions.size()];
  ASSERT_EQ(whole().regions.size(), 3U);
  for (const SolutionRegion& region : whole().regions) {
    const double share = static_cast<double>(counts[region.solutions]) / samples;
    const double deviation = 4.0 * std::sqrt(share * (1.0 - share) / samples);
    EXPECT_LT(region.measure_lower, (share + deviation) * volume);
    EXPECT_GT(region.measure_upper, (share - deviation) * volume);
    EXPECT_NEAR(region.measure, share * volume, deviation * volume + 0.01 * region.measure);
  }
}

// Every pose within limits is one solution: measures times numbers are the integral over poses of the
// determinant of the Jacobian of actuated values, which is det A over the product of the lengths.
TEST(WholeUniqueness, HasMeasuresThatAddUpToThePoses) {
  double sum = 0.0;
  for (const SolutionRegion& region : whole().regions)
    sum += static_cast<double>(region.solutions) * region.measure;
  const Manipulator& robot = robot_of(whole());
  const WorkingMode mode = working_modes(robot).front();
  std::mt19937_64 random(34);
  const int samples = 400000;
  const double reach = robot.leg(0).limits.upper, pi = EIGEN_PI;
  double integral = 0.0;
  for (int i = 0; i < samples; ++i) {
    const Pose pose = Pose::planar(uniform(random, -reach, reach), uniform(random, -reach, reach),
                                   uniform(random, -pi, pi));
    const JointVector q = inverse(robot, pose, mode).q;
    bool within = true;
    for (std::size_t j = 0; j < 3; ++j)
      within = within && robot.leg(j).limits.contain(q[static_cast<Eigen::Index>(j)]);
    if (within) integral += std::abs(direct_determinant(robot, pose, q)) / q.prod();
  }
  integral *= 4.0 * reach * reach * 2.0 * pi / samples;
  EXPECT_NEAR(sum, integral, 0.02 * integral);
}

// No two solutions of the same values are in one region that is said to be unique, and all of them are over
// the same set.
TEST(WholeUniqueness, HasOneSolutionInEachRegion) {
  std::mt19937_64 random(35);
  const int samples = test::thinned(3000);
  int located = 0, solutions = 0;
  for (int i = 0; i < samples; ++i) {
    const JointVector q = random_values(robot_of(whole()), random);
    std::map<std::size_t, int> seen;
    std::optional<std::size_t> over;
    for (const AssemblyMode& mode : direct(robot_of(whole()), q).solutions) {
      ++solutions;
      const auto region = whole().locate(mode.pose);
      if (!region) continue;
      ++located;
      const BasicRegion& found = whole().basic_regions[*region];
      EXPECT_TRUE(!found.is_unique || ++seen[*region] == 1) << q.transpose();
      EXPECT_TRUE(!over || *over == found.over) << q.transpose();
      over = found.over;
      if (found.aspect == 0) continue;
      const int sign = whole().map->aspects()[static_cast<std::size_t>(found.aspect - 1)].determinant_sign;
      EXPECT_GT(mode.determinant * sign, 0.0) << q.transpose();
    }
  }
  EXPECT_GT(located, 0.7 * solutions);
}

/// The solution nearest to a pose, by position and angle; nothing where another is not much farther.
std::optional<Pose> nearest(const DirectResult& found, const Pose& pose) {
  std::vector<std::pair<double, Pose>> by_distance;
  for (const AssemblyMode& mode : found.solutions)
    by_distance.emplace_back((mode.pose.position - pose.position).norm() +
                                 20.0 * mode.pose.orientation.angularDistance(pose.orientation),
                             mode.pose);
  std::sort(by_distance.begin(), by_distance.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  if (by_distance.empty() || (by_distance.size() > 1 && by_distance[1].first < 10.0 * by_distance[0].first))
    return std::nullopt;
  return by_distance[0].second;
}

// Walks of small steps, on which the solution is the nearest one, keep the region as long as they keep its
// set: also where they come back to a set, unless they left it in between.
TEST(WholeUniqueness, KeepsItsRegionOnWalks) {
  std::mt19937_64 random(36);
  const Manipulator& robot = robot_of(whole());
  int steps = 0;
  for (int walks = 0; walks < test::thinned(60); ++walks) {
    JointVector q = random_values(robot, random);
    const DirectResult start = direct(robot, q);
    if (start.solutions.size() < 4) continue;
    std::optional<Pose> pose = start.solutions[start.solutions.size() / 2].pose;
    std::optional<std::size_t> region = whole().locate(*pose);
    Eigen::Vector3d velocity(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0),
                             uniform(random, -1.0, 1.0));
    for (int k = 0; k < 300 && pose && region; ++k) {
      velocity += 0.3 * Eigen::Vector3d(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0),
                                        uniform(random, -1.0, 1.0));
      const JointVector next = q + 0.03 * velocity.normalized();
      const auto component = whole().component_at(next);
      if (!component || component != whole().component_at(q)) {
        velocity = -velocity;
        continue;
      }
      q = next;
      pose = nearest(direct(robot, q), *pose);
      if (!pose) break;
      const auto found = whole().locate(*pose);
      if (!found || whole().basic_regions[*found].over != whole().basic_regions[*region].over) continue;
      ++steps;
      EXPECT_EQ(*found, *region) << q.transpose();
    }
  }
  EXPECT_GT(steps, test::thinned(2000));
}

TEST(WholeUniqueness, SaysWhichRegionsShareADomain) {
  const auto& regions = whole().basic_regions;
  ASSERT_FALSE(regions.empty());
  int shared = 0, apart = 0;
  for (std::size_t a = 0; a < regions.size(); ++a)
    for (std::size_t b = 0; b < regions.size(); ++b) {
      const DomainSharing sharing = whole().sharing(a, b);
      EXPECT_EQ(sharing, whole().sharing(b, a));
      shared += sharing == DomainSharing::shared ? 1 : 0;
      apart += sharing == DomainSharing::apart ? 1 : 0;
      const bool one_set = a != b && regions[a].over == regions[b].over;
      const bool same = a == b && regions[a].is_unique;
      EXPECT_TRUE(!same || sharing == DomainSharing::shared) << a;
      EXPECT_TRUE(!one_set || sharing == DomainSharing::apart) << a << ' ' << b;
      EXPECT_TRUE(regions[a].aspect == regions[b].aspect || sharing == DomainSharing::apart) << a << ' ' << b;
    }
  EXPECT_GT(shared, static_cast<int>(regions.size()));
  EXPECT_GT(apart, 0);
}

TEST(WholeUniqueness, KnowsNothingOutsideOfLimits) {
  EXPECT_FALSE(whole().component_at(Eigen::Vector3d(9.0, 20.0, 20.0)));
  EXPECT_FALSE(whole().component_at(Eigen::Vector3d(20.0, 20.0, 33.0)));
  EXPECT_FALSE(whole().locate(Pose::planar(100.0, 0.0, 0.0)));
  EXPECT_FALSE(whole().locate(Pose::planar(std::nan(""), 0.0, 0.0)));
}

TEST(WholeUniqueness, EndsSoonAfterItIsCancelled) {
  std::atomic<bool> cancelled{false};
  MapControl control;
  control.cancelled = &cancelled;
  double last = 0.0;
  control.progress = [&](double share) {
    EXPECT_LE(share, 1.0);
    last = std::max(last, share);
    cancelled = share > 0.15;
  };
  EXPECT_EQ(compute_uniqueness(test::three_rpr(), {}, control).status, MapStatus::cancelled);
  EXPECT_LT(last, 0.5);
}

}  // namespace
}  // namespace parallel_aspects
