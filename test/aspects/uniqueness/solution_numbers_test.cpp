// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/held_slice.h"
#include "aspects/solutions/joint_ranges.h"
#include "aspects/solutions/slice_equations.h"
#include "aspects/solutions/value_grid.h"
#include "aspects/solutions/value_strips.h"
#include "interval/scalar_range.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using test::ActuationKind;
using test::Robot;
using Values = std::array<double, 2>;

/// A robot with a joint held, and its slice.
struct Held {
  Robot robot;
  HeldJoint joint;
  std::unique_ptr<const HeldSlice> slice;
  JointRanges ranges;

  Held(const Robot& of, std::size_t leg, double value)
      : robot(of),
        joint{leg, value, of->leg(leg).actuated_by_angle()},
        slice(slice_of(*robot, joint)),
        ranges(ranges_of(*robot, joint, *slice)) {}

  static std::unique_ptr<const HeldSlice> slice_of(const Manipulator& robot, const HeldJoint& joint) {
    const RoundingUpward rounding;
    return make_held_slice(robot, joint);
  }

  static JointRanges ranges_of(const Manipulator& robot, const HeldJoint& joint, const HeldSlice& slice) {
    const RoundingUpward rounding;
    return {robot, joint, slice};
  }

  std::string text(const Values& at) const {
    return robot->name() + ", joint " + std::to_string(joint.leg + 1) + " at " + std::to_string(joint.value) +
           ", others at " + std::to_string(at[0]) + ", " + std::to_string(at[1]);
  }
};

/// Robots with legs of every kind, and one of three kinds, held where a random pose has them.
std::vector<Held> held_robots(TaskSpace space, test::RandomRobots& random, std::size_t of_each_kind) {
  std::vector<Held> result;
  for (std::size_t i = 0; i < of_each_kind; ++i) {
    std::vector<Robot> robots;
    for (const ActuationKind kind : {ActuationKind::strut, ActuationKind::revolute, ActuationKind::prismatic})
      robots.push_back(random.robot(space, kind));
    robots.push_back(
        test::manipulator("mixed", space, {robots[0]->leg(0), robots[1]->leg(1), robots[2]->leg(2)}));
    for (const Robot& robot : robots)
      for (int tries = 0; tries < 1000; ++tries) {
        const InverseSolution found = inverse(*robot, random.pose(space), working_modes(*robot).front());
        if (!found) continue;
        result.emplace_back(robot, i % 3, found.q[static_cast<Eigen::Index>(i % 3)]);
        break;
      }
  }
  return result;
}

Values random_values(const Held& held, test::RandomRobots& random) {
  const Box& box = held.ranges.values();
  return {random.uniform(box.lower[0], box.upper[0]), random.uniform(box.lower[1], box.upper[1])};
}

Values random_point(test::RandomRobots& random) {
  return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}

/// Both joint values at a pose; not numbers where a leg does not reach.
Values values_at(const Held& held, const Pose& pose, const SlicePosture& posture) {
  Values q{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Leg& leg = held.robot->leg(held.slice->leg(i));
    const Eigen::Vector3d anchor = pose.transform(leg.anchor);
    q[i] = squared_inverse_entry(leg, anchor) > 0.0 ? joint_value(leg, anchor, posture[i]) : std::nan("");
  }
  return q;
}

class SlicesIn : public testing::TestWithParam<TaskSpace> {};

INSTANTIATE_TEST_SUITE_P(TaskSpaces, SlicesIn, testing::Values(TaskSpace::SE2, TaskSpace::SO3));

// Half the residual of the model, and differences of it.
TEST_P(SlicesIn, HaveTheEquationsOfTheModel) {
  test::RandomRobots random(11);
  for (const Held& held : held_robots(GetParam(), random, 5))
    for (int n = 0; n < 20; ++n) {
      const Values x = random_point(random), q = random_values(held, random);
      const Pose pose = held.slice->pose(x);
      const RoundingUpward rounding;
      const SliceTurns turns = SlicePlace(x).over();
      for (std::size_t i = 0; i < 2; ++i) {
        const HeldSlice::LegAt at = held.slice->leg_at(i, q[i]);
        const Leg& leg = held.robot->leg(held.slice->leg(i));
        const double residual = leg.residual(pose, q[i]), h = 1e-5, scale = 1.0 + std::abs(residual);
        const double slope = (leg.residual(pose, q[i] + h) - leg.residual(pose, q[i] - h)) / (4.0 * h);
        EXPECT_NEAR(middle_of(at.equation.jet<0>(turns).value()), 0.5 * residual, 1e-9 * scale)
            << held.text(q);
        EXPECT_NEAR(middle_of(at.slope.jet<0>(turns).value()), slope, 1e-6 * scale) << held.text(q);
      }
    }
}

// Over a box joint values are in the range, up to whole turns, where there is one.
TEST_P(SlicesIn, EncloseTheJointValuesOfTheInverseProblem) {
  test::RandomRobots random(12);
  int compared = 0;
  for (const Held& held : held_robots(GetParam(), random, 5))
    for (int n = 0; n < 100; ++n) {
      const Values x = random_point(random);
      const double width = std::pow(10.0, random.uniform(-4.0, -1.0));
      const Values y{x[0] + width * random.uniform(-0.5, 0.5), x[1] + width * random.uniform(-0.5, 0.5)};
      const Box box{
          2, {x[0] - 0.5 * width, x[1] - 0.5 * width, 0.0}, {x[0] + 0.5 * width, x[1] + 0.5 * width, 0.0}};
      for (const SlicePosture& posture : held.slice->postures()) {
        const Values q = values_at(held, held.slice->pose(y), posture);
        const RoundingUpward rounding;
        for (std::size_t i = 0; i < 2; ++i) {
          const auto range = held.slice->joint_value(i, posture[i], held.slice->place(box));
          if (!range || std::isnan(q[i])) continue;
          const double far = std::abs(held.robot->leg(held.slice->leg(i)).actuated_by_angle()
                                          ? std::remainder(q[i] - middle_of(*range), 2.0 * EIGEN_PI)
                                          : q[i] - middle_of(*range));
          EXPECT_LE(far, range->upper() - middle_of(*range) + 1e-9) << held.text(q);
          ++compared;
        }
      }
    }
  EXPECT_GT(compared, 1000);
}

TEST_P(SlicesIn, HaveTheSolutionsOfTheDirectProblem) {
  test::RandomRobots random(13);
  std::size_t compared = 0;
  for (const Held& held : held_robots(GetParam(), random, 6))
    for (int n = 0; n < 40; ++n) {
      const Values q = random_values(held, random);
      const DirectResult expected = direct(*held.robot, held.ranges.actuated(q));
      const RoundingUpward rounding;
      const auto found = find_slice_solutions(*held.slice, q);
      if (!found || !expected) continue;
      EXPECT_EQ(found->size(), expected.solutions.size()) << held.text(q);
      compared += found->size();
    }
  EXPECT_GT(compared, 300U);
}

/// The determinant of the Jacobian of both equations at a pose of a posture; not a number where a leg does
/// not reach.
double determinant_at(const Held& held, const Values& x, const SlicePosture& posture) {
  const RoundingUpward rounding;
  const SlicePlace place(x);
  const auto first = held.slice->leg_over(0, posture[0], place),
             second = held.slice->leg_over(1, posture[1], place);
  if (!first || !second || first->reaches != Verdict::holds || second->reaches != Verdict::holds)
    return std::nan("");
  return middle_of(
      bracket(first->equation.jet<1>(place.over()), second->equation.jet<1>(place.over())).value());
}

/// A pose with D = 0 between two random poses, by bisection.
std::optional<Values> random_singular_point(const Held& held, const SlicePosture& posture,
                                            test::RandomRobots& random) {
  Values a = random_point(random), b = random_point(random);
  const double sign = determinant_at(held, a, posture);
  if (!(sign * determinant_at(held, b, posture) < 0.0)) return std::nullopt;
  for (int k = 0; k < 60; ++k) {
    const Values middle{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
    const double value = determinant_at(held, middle, posture);
    if (std::isnan(value)) return std::nullopt;
    (value * sign > 0.0 ? a : b) = middle;
  }
  return a;
}

// No image of a singular pose that bisection finds is in a set of the grid.
TEST_P(SlicesIn, HaveNoImageOfASingularPoseInASet) {
  test::RandomRobots random(14);
  int found = 0;
  for (const Held& held : held_robots(GetParam(), random, test::is_sanitized ? 1 : 2)) {
    ValueGrid grid(held.ranges, 128);
    {
      const RoundingUpward rounding;
      const double step = std::min(grid.steps()[0], grid.steps()[1]);
      enclose_parallel_singularities(*held.slice, held.ranges, {0.25 * step, step}, {},
                                     [&](const ValueStrip& strip) { return grid.mark(strip); });
      grid.join(1);
    }
    for (int n = 0; n < 400; ++n)
      for (const SlicePosture& posture : held.slice->postures()) {
        const auto x = random_singular_point(held, posture, random);
        if (!x) continue;
        const Values q = values_at(held, held.slice->pose(*x), posture);
        const Values in_range = held.ranges.values_of(held.ranges.actuated(q));
        EXPECT_FALSE(grid.set_of(in_range)) << held.text(q);
        ++found;
      }
  }
  EXPECT_GT(found, test::is_sanitized ? 100 : 500);
}

/// Of aspects that the map tells, with how many of the poses are in each; empty where it can not tell of one.
std::map<int, int> numbers_by_aspect(const Uniqueness& found, const JointVector& q,
                                     const DirectResult& solutions) {
  std::map<int, int> result;
  for (const AssemblyMode& each : solutions.solutions) {
    const auto mode = working_mode(*found.map->manipulator(), each.pose, q);
    const int aspect = mode ? found.map->locate(each.pose, *mode).aspect : 0;
    if (aspect == 0) return {};
    ++result[aspect];
  }
  return result;
}

struct Comparison {
  std::size_t compared = 0, by_aspect = 0;
  std::size_t unlisted = 0;                  // with solutions, but in no component
  std::map<std::size_t, std::size_t> drawn;  // by number of solutions
};

Comparison compare_with_direct(const Robot& robot, const Held& held, const Uniqueness& found, int samples) {
  test::RandomRobots random(15);
  Comparison result;
  for (int n = 0; n < samples; ++n) {
    const Values values = random_values(held, random);
    const JointVector q = held.ranges.actuated(values);
    const DirectResult solutions = direct(*robot, q);
    if (!solutions) continue;
    ++result.drawn[solutions.solutions.size()];
    const auto component = found.component_at(q);
    if (!component && !solutions.solutions.empty()) ++result.unlisted;
    if (!component) continue;
    const BasicComponent& listed = found.basic_components[*component];
    EXPECT_EQ(listed.solutions.size(), solutions.solutions.size()) << held.text(values);
    ++result.compared;
    std::map<int, int> expected;
    for (const int aspect : listed.aspects) ++expected[aspect];
    const auto numbers = numbers_by_aspect(found, q, solutions);
    if (numbers.empty() || expected.count(0) > 0) continue;
    EXPECT_EQ(numbers, expected) << held.text(values);
    ++result.by_aspect;
  }
  return result;
}

// Within five standard deviations of what is drawn. So is what has solutions, but no number that is proved.
void expect_measures(const Held& held, const Uniqueness& found, const Comparison& comparison, int samples) {
  const double whole = held.ranges.values().measure();
  const double unlisted = static_cast<double>(comparison.unlisted) / samples;
  EXPECT_LE(whole * (unlisted - 5.0 * std::sqrt(std::max(unlisted, 1.0 / samples) / samples)),
            found.measure_unknown);
  for (const SolutionRegion& region : found.regions) {
    const auto drawn = comparison.drawn.find(region.solutions);
    const double share = drawn == comparison.drawn.end() ? 0.0 : static_cast<double>(drawn->second) / samples;
    const double error = whole * 5.0 * std::sqrt(std::max(share, 1.0 / samples) / samples);
    EXPECT_NEAR(whole * share, region.measure, error) << region.solutions;
    EXPECT_LE(region.measure_lower, whole * share + error);
    EXPECT_GE(region.measure_upper, whole * share - error);
  }
}

void expect_numbers_of_direct_problem(const Robot& robot, std::size_t leg, double value, int samples) {
  const Held held(robot, leg, value);
  const auto found = test::uniqueness_of_slice(robot, leg, value);
  ASSERT_TRUE(found && found->has_regions);
  EXPECT_LT(found->measure_unknown, 0.1 * held.ranges.values().measure());
  const Comparison comparison = compare_with_direct(robot, held, *found, samples);
  EXPECT_GT(comparison.compared, 50U);
  EXPECT_GT(2 * comparison.by_aspect, comparison.compared);
  expect_measures(held, *found, comparison, samples);
}

TEST(SolutionNumbers, AreThoseOfTheDirectProblemInEachAspect) {
  const Robot three_rrr = test::three_rrr()->with_constraints({});
  expect_numbers_of_direct_problem(three_rrr, 0, 0.3, 20000);
  if (!test::is_sanitized) expect_numbers_of_direct_problem(three_rrr, 1, 1.7, 20000);
  expect_numbers_of_direct_problem(test::shipped("three_prr")->manipulator()->with_constraints({}), 2, 0.3,
                                   20000);
}

// One of which is beyond half a turn.
TEST(SolutionNumbers, AreThoseWithinLimits) {
  const Robot free = test::three_rrr();
  std::vector<Leg> legs(free->legs().begin(), free->legs().end());
  legs[1].limits = JointLimits{2.5, 4.0};
  legs[2].limits = JointLimits{-1.0, 1.0};
  const Robot robot = test::manipulator("limited", TaskSpace::SE2, legs);
  const Held held(robot, 0, 1.2);
  EXPECT_NEAR(held.ranges.values().measure(), 3.0, 1e-12);
  expect_numbers_of_direct_problem(robot, 0, 1.2, 4000);
}

TEST(SolutionNumbers, AreThoseOfOtherRobots) {
  test::RandomRobots random(16);
  for (const Held& held : held_robots(TaskSpace::SE2, random, 1))
    if (!std::all_of(held.robot->legs().begin(), held.robot->legs().end(),
                     [](const Leg& leg) { return leg.kind().type == LegType::strut; }))
      expect_numbers_of_direct_problem(held.robot, held.joint.leg, held.joint.value, 4000);
}

// There without aspects.
TEST(SolutionNumbers, AreThoseOfTheDirectProblemInSO3) {
  if (test::is_sanitized) GTEST_SKIP() << "takes minutes, and runs what the others do";
  const Robot robot = test::spherical_three_rrr();
  const Held held(robot, 0, 0.3);
  const SolutionNumbers found = count_direct_solutions(*robot, held.joint);
  ASSERT_TRUE(found.has_regions);
  EXPECT_EQ(found.region_unit, "rad^2");
  EXPECT_LT(found.measure_unknown, 0.1 * held.ranges.values().measure());
  test::RandomRobots random(17);
  int compared = 0;
  for (int n = 0; n < 4000; ++n) {
    const Values values = random_values(held, random);
    const DirectResult solutions = direct(*robot, held.ranges.actuated(values));
    const auto component = found.component_at(held.ranges.actuated(values));
    if (!component || !solutions) continue;
    EXPECT_EQ(found.basic_components[*component].solutions.size(), solutions.solutions.size())
        << held.text(values);
    ++compared;
  }
  EXPECT_GT(compared, 2000);
}

// Its platform can stay with all anchors on the axes of the cranks, whatever these do.
TEST(SolutionNumbers, AreNotKnownOfTheAgileEye) {
  const Robot robot = test::agile_eye();
  const Held held(robot, 0, 0.3);
  const SolutionNumbers found = count_direct_solutions(*robot, held.joint);
  ASSERT_TRUE(found.has_regions);
  EXPECT_TRUE(found.regions.empty());
  EXPECT_GE(found.measure_unknown, 4.0 * EIGEN_PI * EIGEN_PI);
}

}  // namespace
}  // namespace parallel_aspects
