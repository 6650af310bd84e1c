// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/star_sets/star_finder.h"

#include "aspects/star_sets/fold_flood.h"
#include "aspects/tree/pose_space.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/robots.h"
#include "support/sign_at.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

struct Case {
  const char* name;
  std::function<std::shared_ptr<const Manipulator>()> robot;
  int boxes;                 // that are tried
  int least_stars;           // found in them
  int least_empty;           // and boxes that are proved to have nothing of the set
  int least_samples;         // poses of the set in boxes with stars
  bool about_folds = false;  // whether the boxes lie where a leg folds, not at any boundary
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.name; }

/// How many times the boxes are tried: more where somebody asks for a longer campaign.
int campaign() {
  const char* asked = std::getenv("PARALLEL_ASPECTS_STARS");
  return asked == nullptr ? 1 : std::atoi(asked);
}

/// A 3-RRR with cranks that turn by more than half a turn, not by all of one: one of two conditions is
/// enough.
std::shared_ptr<const Manipulator> limited_three_rrr() {
  ManipulatorDescription description = test::three_rrr()->description();
  for (Leg& leg : description.legs) leg.limits = JointLimits{-2.2, 2.4};
  return std::make_shared<const Manipulator>(description);
}

/// With limits of pitch and roll close to where the cranks turn back.
std::shared_ptr<const Manipulator> limited_ankle() {
  ManipulatorDescription description = test::ankle()->description();
  description.constraints.hinge_limits = {{"pitch", 0, {-0.3, 0.5}}, {"roll", 1, {-2.9, 0.9}}};
  return std::make_shared<const Manipulator>(description);
}

std::shared_ptr<const Manipulator> shipped_three_prr() { return models::three_prr()->mapped_manipulator(); }

std::shared_ptr<const Manipulator> shipped_linear_delta() {
  return models::linear_delta()->mapped_manipulator();
}

class StarFinderTest : public testing::TestWithParam<Case> {
 protected:
  int sign(const MapPosition& at) const {
    return keeps_chain(at) ? test::sign_in_doubles(*robot, space->pose(at), modes[mode]) : 0;
  }

  /// Whether the joints of the chain that holds the platform are within their limits.
  bool keeps_chain(const MapPosition& at) const {
    const std::vector<HingeLimit>& limits = robot->constraints().hinge_limits;
    return std::all_of(limits.begin(), limits.end(), [&at](const HingeLimit& each) {
      const double angle = M_PI * at.point[each.hinge];
      return angle > each.limits.lower && angle < each.limits.upper;
    });
  }

  double height(const MapPosition& at, std::size_t leg) const {
    const Leg& each = robot->leg(leg);
    const double squared = squared_inverse_entry(each, space->pose(at).transform(each.anchor));
    return std::sqrt(std::max(0.0, squared));
  }

  /// A pose of the set next to its boundary, and one beyond it.
  std::optional<std::array<MapPosition, 2>> ends(int wanted) {
    return GetParam().about_folds ? fold(wanted) : boundary(wanted);
  }

  /// A pose of the set where a leg is nearly folded, and the opposite one.
  std::optional<std::array<MapPosition, 2>> fold(int wanted) {
    const Leg& leg = robot->leg(static_cast<std::size_t>(pairs->uniform(0.0, 3.0)));
    test::FoldPose at{std::pow(10.0, pairs->uniform(-4.0, 0.0)), pairs->uniform(-M_PI, M_PI),
                      pairs->uniform(-3.0, 3.0)};
    const MapPosition here = position(test::from_fold(leg, at));
    at.direction += M_PI;
    const MapPosition opposite = position(test::from_fold(leg, at));
    if (!region.contains(here.point) || !region.contains(opposite.point) || sign(here) != wanted)
      return std::nullopt;
    return std::array<MapPosition, 2>{here, opposite};
  }

  static MapPosition position(const Eigen::Vector3d& at) { return {0, {at[0], at[1], at[2] / M_PI}}; }
  static Eigen::Vector3d coordinates(const MapPosition& at) {
    return {at.point[0], at.point[1], at.point[2] * M_PI};
  }

  std::optional<std::array<MapPosition, 2>> boundary(int wanted) {
    const auto inside = pairs->reached(modes[mode]), other = pairs->reached(modes[pairs_mode()]);
    if (!inside || !other) return std::nullopt;
    MapPosition in = space->position(*inside), out = space->position(*other);
    if (in.root != out.root || sign(in) != wanted || sign(out) == wanted) return std::nullopt;
    for (int i = 0; i < 50; ++i) {
      MapPosition middle = in;
      for (std::size_t k = 0; k < size; ++k) middle.point[k] = 0.5 * (in.point[k] + out.point[k]);
      (sign(middle) == wanted ? in : out) = middle;
    }
    return std::array<MapPosition, 2>{in, out};
  }

  std::size_t pairs_mode() {
    return static_cast<std::size_t>(pairs->uniform(0.0, static_cast<double>(modes.size())));
  }

  Box box_about(const MapPosition& at) {
    Box box{size, {}, {}};
    const double share = std::pow(10.0, pairs->uniform(-3.0, -1.5));
    for (std::size_t i = 0; i < size; ++i) {
      const double width = share * region.width(i), below = pairs->uniform(0.0, width);
      box.lower[i] = std::max(region.lower[i], at.point[i] - below);
      box.upper[i] = std::min(region.upper[i], box.lower[i] + width);
    }
    return box;
  }

  MapPosition random_in(RootIndex root, const Box& box) {
    MapPosition result{root, {}};
    for (std::size_t i = 0; i < size; ++i) result.point[i] = pairs->uniform(box.lower[i], box.upper[i]);
    return result;
  }

  /// Whether a way from one pose to another stays in the set, by steps in double precision: straight, but
  /// that the coordinates `replaced` are what brings the heights of `legs` straight to those of the end.
  bool is_joined(const MapPosition& from, const MapPosition& to, const std::vector<std::size_t>& legs,
                 const std::vector<std::size_t>& replaced) const {
    constexpr int steps = 200;
    MapPosition at = from;
    const int wanted = sign(from);
    for (int step = 1; step <= steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      for (std::size_t i = 0; i < size; ++i)
        if (std::find(replaced.begin(), replaced.end(), i) == replaced.end())
          at.point[i] = from.point[i] + share * (to.point[i] - from.point[i]);
      if (!adjust_heights(at, from, to, share, legs, replaced) || sign(at) != wanted) return false;
    }
    double distance = 0.0;
    for (std::size_t i = 0; i < size; ++i) distance += std::abs(at.point[i] - to.point[i]) / region.width(i);
    return distance < 1e-6;
  }

  bool adjust_heights(MapPosition& at, const MapPosition& from, const MapPosition& to, double share,
                      const std::vector<std::size_t>& legs, const std::vector<std::size_t>& replaced) const {
    const auto count = static_cast<Eigen::Index>(legs.size());
    for (int i = 0; i < 20 && count > 0; ++i) {
      Eigen::VectorXd missing(count);
      Eigen::MatrixXd slopes(count, count);
      for (Eigen::Index k = 0; k < count; ++k) {
        const std::size_t leg = legs[static_cast<std::size_t>(k)];
        const double height_wanted = height(from, leg) + share * (height(to, leg) - height(from, leg));
        missing[k] = height_wanted * height_wanted - square(at, leg);
        for (Eigen::Index m = 0; m < count; ++m)
          slopes(k, m) = slope(at, leg, replaced[static_cast<std::size_t>(m)]);
      }
      const Eigen::VectorXd step = slopes.fullPivLu().solve(missing);
      for (Eigen::Index m = 0; m < count; ++m) at.point[replaced[static_cast<std::size_t>(m)]] += step[m];
      if (!step.allFinite()) return false;
    }
    return true;
  }

  double square(const MapPosition& at, std::size_t leg) const {
    return squared_inverse_entry(robot->leg(leg), space->pose(at).transform(robot->leg(leg).anchor));
  }

  double slope(const MapPosition& at, std::size_t leg, std::size_t coordinate) const {
    const double step = 1e-6 * region.width(coordinate);
    MapPosition below = at, above = at;
    below.point[coordinate] -= step;
    above.point[coordinate] += step;
    return (square(above, leg) - square(below, leg)) / (2.0 * step);
  }

  /// In poses, or with the heights of any one or two legs in place of any coordinates.
  bool is_joined(const MapPosition& from, const MapPosition& to) const {
    if (is_joined(from, to, {}, {})) return true;
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t i = 0; i < size; ++i) {
        if (is_joined(from, to, {j}, {i})) return true;
        for (std::size_t k = j + 1; k < size; ++k)
          for (std::size_t m = i + 1; m < size; ++m)
            if (is_joined(from, to, {j, k}, {i, m})) return true;
      }
    return GetParam().about_folds && is_joined_about_fold(from, to);
  }

  bool is_joined_about_fold(const MapPosition& from, const MapPosition& to) const {
    const int wanted = sign(from);
    const auto is_in_set = [&](const Eigen::Vector3d& at) { return sign(position(at)) == wanted; };
    const auto joins = [&](const Leg& leg) {
      return test::FoldFlood(leg, is_in_set).joins(coordinates(from), coordinates(to));
    };
    return std::any_of(robot->legs().begin(), robot->legs().end(), joins);
  }

  void check(RootIndex root, const Box& box, const Stars& stars, int wanted) {
    for (std::size_t i = 0; i < stars.count; ++i) {
      ASSERT_EQ(sign({root, stars.poses[i]}), wanted);
      ASSERT_TRUE(region.contains(stars.poses[i]));
    }
    for (int i = 0; i < 40; ++i) {
      const MapPosition sample = random_in(root, box);
      if (!keeps_chain(sample) || test::sign_at(*robot, space->pose(sample), modes[mode]) != wanted) continue;
      ASSERT_GT(stars.count, 0U) << testing::PrintToString(sample.point);
      if (++samples > 1500) continue;
      bool joined = false;
      for (std::size_t k = 0; k < stars.count && !joined; ++k)
        joined = is_joined(sample, {root, stars.poses[k]});
      ASSERT_TRUE(joined) << testing::PrintToString(sample.point) << " of "
                          << testing::PrintToString(box.lower) << " to " << testing::PrintToString(box.upper)
                          << " in " << to_string(modes[mode]);
    }
  }

  std::shared_ptr<const Manipulator> robot = GetParam().robot();
  std::size_t size = robot->leg_count();  // coordinates of a pose, too
  std::vector<WorkingMode> modes = working_modes(*robot);
  std::unique_ptr<const StarFinder> finder = make_star_finder(*robot, modes);
  std::unique_ptr<test::PosePairs> pairs = std::make_unique<test::PosePairs>(robot, 20261125);
  std::shared_ptr<const PoseSpace> space;
  Box region;
  std::size_t mode = 0;
  int samples = 0;
};

TEST_P(StarFinderTest, WhatIsProvedHoldsForRandomPoses) {
  const auto classifier = make_box_classifier(*robot, modes);
  const auto positions = classifier->reachable_positions();
  ASSERT_TRUE(positions);
  space = make_pose_space(robot->motions(), *positions, robot->characteristic_length());
  region = space->region();
  int found = 0, empty = 0;
  for (int i = 0; i < campaign() * GetParam().boxes; ++i) {
    mode = pairs_mode();
    const int wanted = pairs->uniform(0.0, 1.0) < 0.5 ? 1 : -1;
    const auto ends = this->ends(wanted);
    if (!ends) continue;
    const Box box = box_about((*ends)[0]);
    const Stars stars = [&] {
      const RoundingUpward rounding;
      return finder->find((*ends)[0].root, box, region, mode, wanted);
    }();
    // The same box holds poses of the set, so that the other sign shows what is empty.
    ASSERT_FALSE(stars.is_known && stars.count == 0) << testing::PrintToString(box.lower);
    if (stars.is_known) check((*ends)[0].root, box, stars, wanted);
    if (HasFatalFailure()) return;
    found += stars.is_known;
    const Box beyond = box_about((*ends)[1]);
    const Stars others = [&] {
      const RoundingUpward rounding;
      return finder->find((*ends)[1].root, beyond, region, mode, wanted);
    }();
    if (others.is_known) check((*ends)[1].root, beyond, others, wanted);
    if (HasFatalFailure()) return;
    empty += others.is_known && others.count == 0;
  }
  EXPECT_GE(found, GetParam().least_stars);
  EXPECT_GE(empty, GetParam().least_empty);
  EXPECT_GE(samples, GetParam().least_samples);
}

/// Where a turn begins, next to a pose at which det A touches a serial singularity. The angle tells the
/// height best, but has no room to grow in.
TEST(StarFinder, FindsStarsWhereATurnBegins) {
  constexpr std::size_t size = 3;
  const auto robot = models::three_rrr()->mapped_manipulator();
  const std::vector<WorkingMode> modes = working_modes(*robot);
  const auto finder = make_star_finder(*robot, modes);
  const auto positions = make_box_classifier(*robot, modes)->reachable_positions();
  ASSERT_TRUE(positions);
  const Box region =
      make_pose_space(robot->task_space(), *positions, robot->characteristic_length())->region();
  const Box box{size,
                {3.42130875175645, 1.18649914081471, -1.0},
                {3.42133736199321, 1.18653170129983, -0.999998092651367}};
  const auto mode = std::find_if(modes.begin(), modes.end(), [](const WorkingMode& each) {
    return each.sign(0) < 0 && each.sign(1) > 0 && each.sign(2) > 0;
  });
  const RoundingUpward rounding;
  const Stars stars = finder->find(0, box, region, static_cast<std::size_t>(mode - modes.begin()), 1);
  EXPECT_TRUE(stars.is_known);
  EXPECT_GT(stars.count, 0U);
}

INSTANTIATE_TEST_SUITE_P(Robots, StarFinderTest,
                         testing::Values(Case{"three_rpr", test::three_rpr, 400, 50, 0, 300},
                                         Case{"three_prr", shipped_three_prr, 400, 20, 0, 100},
                                         Case{"three_rrr", test::three_rrr, 400, 20, 0, 100},
                                         Case{"folds_of_three_rrr", test::three_rrr, 1000, 100, 0, 500, true},
                                         Case{"limited_three_rrr", limited_three_rrr, 400, 20, 0, 100},
                                         Case{"ankle", test::ankle, 1000, 100, 0, 300},
                                         Case{"limited_ankle", limited_ankle, 1000, 60, 0, 300},
                                         Case{"linear_delta", shipped_linear_delta, 400, 20, 0, 100},
                                         Case{"delta", test::delta, 400, 20, 0, 100},
                                         Case{"spherical_3rrr", test::spherical_three_rrr, 2400, 10, 0, 50}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace parallel_aspects
