// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/actuated_space.h"

#include "aspects/enclosures/strut_images.h"
#include "aspects/solutions/solution_regions.h"
#include "aspects/solutions/strut_solutions.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::uniform;

constexpr double pi = EIGEN_PI;

/// A slice that holds strut 1, with the plane of lengths 2 and 3.
struct Slice {
  Robot robot;
  MapSlice held;
  StrutSlice struts;
  StrutImages images;
  ActuatedSpace space;
  std::vector<SolutionSet> sets;

  Slice(const Robot& made, double value)
      : robot(made),
        held(test::slice_of(made, {{made->leg(0).actuated_joint, value}})),
        struts(*made, held),
        images(struts),
        space(images, 1e-4, {}),
        sets(find_solution_sets(
            [this](const ActuatedValues& values) { return find_all_solutions(struts, values); }, space, {})) {
  }

  /// By piece; nothing where the number is not proved.
  std::map<PieceIndex, std::optional<std::size_t>> numbers() {
    std::map<PieceIndex, std::optional<std::size_t>> result;
    for (const SolutionSet& set : sets)
      for (const PieceIndex piece : set.pieces)
        result[piece] = set.solutions ? std::optional<std::size_t>(set.solutions->size()) : std::nullopt;
    return result;
  }
};

Slice slice_of(const Robot& robot, double value) { return made_under_upward_rounding<Slice>(robot, value); }

Robot random_struts(std::mt19937_64& random) {
  test::Points base, anchors;
  for (int j = 0; j < 3; ++j) {
    base.emplace_back(uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0), 0.0);
    anchors.emplace_back(uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0), 0.0);
  }
  return test::manipulator("random_struts", TaskSpace::SE2, test::struts(base, anchors));
}

Robot unlimited_three_rpr() { return test::three_rpr()->with_constraints({}); }

std::optional<PieceIndex> piece_of(const Slice& slice, const std::array<double, 2>& lengths) {
  const RoundingUpward rounding;
  return slice.space.find({lengths[0], lengths[1], 0.0});
}

void compare_with_direct_problem(Slice& slice, std::mt19937_64& random, int samples) {
  const auto numbers = slice.numbers();
  const Box& all = slice.space.cells()[0].box;
  int compared = 0;
  for (int i = 0; i < samples; ++i) {
    const std::array<double, 2> lengths{uniform(random, all.lower[0], all.upper[0]),
                                        uniform(random, all.lower[1], all.upper[1])};
    const auto piece = piece_of(slice, lengths);
    if (!piece || !numbers.at(*piece)) continue;
    ++compared;
    const JointVector q = Eigen::Vector3d(slice.held.joint->value, lengths[0], lengths[1]);
    const DirectResult found = direct(*slice.robot, q);
    ASSERT_EQ(found.solutions.size(), *numbers.at(*piece)) << slice.robot->name() << ": " << q.transpose();
  }
  EXPECT_GT(compared, 0.99 * samples);
}

// The number of solutions of random actuated values, by the direct solver.
TEST(ActuatedSpace, HasTheNumbersOfTheDirectProblem) {
  std::mt19937_64 random(21);
  const int samples = test::thinned(5000);
  Slice slice = slice_of(unlimited_three_rpr(), 14.98);
  compare_with_direct_problem(slice, random, samples);
  for (int robots = 0; robots < 3; ++robots) {
    Slice other = slice_of(random_struts(random), uniform(random, 0.5, 3.0));
    compare_with_direct_problem(other, random, samples);
  }
}

/// All three lengths, within limits.
struct Family {
  Robot robot;
  StrutSlice struts;
  StrutImages images;
  ActuatedSpace space;

  explicit Family(const Robot& made)
      : robot(made), struts(*made, 0), images(struts), space(images, 1e-2, {}, 8000) {}
};

Robot within(const Robot& robot, double least, double most) {
  std::vector<Leg> legs = robot->legs();
  for (Leg& leg : legs) leg.limits = JointLimits{least, most};
  return test::manipulator("limited", TaskSpace::SE2, legs);
}

/// det A and the lengths at a point of the slice [rad].
struct At {
  double determinant;
  std::array<double, 2> lengths;
};

At at(const Slice& slice, double a, double phi) {
  const Pose pose = circle_of_anchor(*slice.robot, *slice.held.joint).pose(a, phi);
  const auto q = inverse(*slice.robot, pose, working_modes(*slice.robot).front()).q;
  return {direct_determinant(*slice.robot, pose, q), {q[1], q[2]}};
}

// Of singular poses, found by bisection, none is in a piece.
TEST(ActuatedSpace, HasNoImageOfASingularPoseInAPiece) {
  std::mt19937_64 random(22);
  for (int robots = 0; robots < 4; ++robots) {
    const Robot robot = robots == 0 ? unlimited_three_rpr() : random_struts(random);
    const Slice slice = slice_of(robot, robots == 0 ? 14.98 : uniform(random, 0.5, 3.0));
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
      const double phi = uniform(random, -pi, pi);
      double from = uniform(random, -pi, pi), to = from + 0.5;
      const bool positive = at(slice, from, phi).determinant > 0.0;
      if (positive == (at(slice, to, phi).determinant > 0.0)) continue;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (from + to);
        (positive == (at(slice, middle, phi).determinant > 0.0) ? from : to) = middle;
      }
      ++found;
      const auto lengths = at(slice, from, phi).lengths;
      EXPECT_FALSE(piece_of(slice, lengths)) << robots << ": " << lengths[0] << ' ' << lengths[1];
    }
    EXPECT_GT(found, 100);
  }
}

// The same of all three lengths, with singular poses anywhere within limits.
TEST(ActuatedSpace, HasNoImageOfASingularPoseInAPieceOfTheWhole) {
  std::mt19937_64 random(23);
  for (int robots = 0; robots < 3; ++robots) {
    const Robot robot = robots == 0 ? test::three_rpr() : within(random_struts(random), 0.5, 3.0);
    const Family family = made_under_upward_rounding<Family>(robot);
    const double reach = robot->leg(0).limits.upper;
    const auto values = [&](double x, double y, double phi) {
      return inverse(*robot, Pose::planar(x, y, phi), working_modes(*robot).front()).q;
    };
    const auto determinant = [&](double x, double y, double phi) {
      return direct_determinant(*robot, Pose::planar(x, y, phi), values(x, y, phi));
    };
    int found = 0;
    for (int i = 0; i < 50000; ++i) {
      const double phi = uniform(random, -pi, pi), y = uniform(random, -reach, reach);
      double from = uniform(random, -reach, reach), to = from + 0.1 * reach;
      const bool positive = determinant(from, y, phi) > 0.0;
      if (positive == (determinant(to, y, phi) > 0.0)) continue;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (from + to);
        (positive == (determinant(middle, y, phi) > 0.0) ? from : to) = middle;
      }
      const JointVector q = values(from, y, phi);
      found +=
          (q.array() > robot->leg(0).limits.lower && q.array() < robot->leg(0).limits.upper).all() ? 1 : 0;
      const RoundingUpward rounding;
      EXPECT_FALSE(family.space.find({q[1], q[2], q[0]})) << robots << ": " << q.transpose();
    }
    EXPECT_GT(found, 50);
  }
}

// Areas of the plane of both lengths by number of solutions, by brute force: 79.7, 255.8 and 954.4.
TEST(ActuatedSpace, HasTheAreasOfTheThreeRpr) {
  Slice slice = slice_of(unlimited_three_rpr(), 14.98);
  std::map<std::size_t, double> areas;
  for (const SolutionSet& set : slice.sets)
    if (set.solutions) areas[set.solutions->size()] += set.estimate;
  EXPECT_NEAR(areas[6], 79.7, 0.01 * 79.7);
  EXPECT_NEAR(areas[4], 255.8, 0.01 * 255.8);
  EXPECT_NEAR(areas[2], 954.4, 0.01 * 954.4);
  EXPECT_EQ(areas.size(), 4U);  // and none
  EXPECT_LT(slice.space.unknown(), 0.5);
}

// Every pose of the slice is one solution: areas times numbers are the integral of |det J| over the slice,
// which is taken by differences of the inverse problem.
TEST(ActuatedSpace, HasAreasThatAddUpToTheSlice) {
  Slice slice = slice_of(unlimited_three_rpr(), 14.98);
  double sum = 0.0;
  for (const SolutionSet& set : slice.sets)
    if (set.solutions) sum += static_cast<double>(set.solutions->size()) * set.estimate;
  const int cells = 400;
  const double width = 2.0 * pi / cells, step = 1e-5;
  double integral = 0.0;
  for (int i = 0; i < cells; ++i)
    for (int k = 0; k < cells; ++k) {
      const double a = -pi + (i + 0.5) * width, phi = -pi + (k + 0.5) * width;
      const auto right = at(slice, a + step, phi).lengths, left = at(slice, a - step, phi).lengths;
      const auto above = at(slice, a, phi + step).lengths, below = at(slice, a, phi - step).lengths;
      integral += std::abs((right[0] - left[0]) * (above[1] - below[1]) -
                           (right[1] - left[1]) * (above[0] - below[0])) /
                  (4.0 * step * step) * width * width;
    }
  EXPECT_NEAR(sum, integral, 2e-3 * integral);
}

}  // namespace
}  // namespace parallel_aspects
