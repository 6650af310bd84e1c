// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/strut_slice.h"

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::uniform;

// Half the squared length of a leg by the inverse problem, at a direction and an angle [half turns].
double half_square(const Robot& robot, const MapSlice& slice, std::size_t leg, double a, double phi) {
  const Pose pose = circle_of_anchor(*robot, *slice.joint).pose(test::pi * a, test::pi * phi);
  const double q = inverse(*robot, pose, working_modes(*robot).front()).q[static_cast<Eigen::Index>(leg)];
  return 0.5 * robot->leg(leg).squared_distance(q);
}

Robot random_struts(std::mt19937_64& random) {
  test::Points base, anchors;
  for (int j = 0; j < 3; ++j) {
    const double height = uniform(random, -0.3, 0.3);
    base.emplace_back(uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0), height);
    anchors.emplace_back(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), 0.0);
  }
  return test::manipulator("random_struts", TaskSpace::SE2, test::struts(base, anchors));
}

MapSlice slice_of(const Robot& robot, std::mt19937_64& random) {
  const std::size_t held = random() % 3;
  return test::slice_of(robot, {{robot->leg(held).actuated_joint, uniform(random, 0.8, 2.0)}});
}

TEST(StrutSlice, HasTheLengthsOfTheInverseProblem) {
  std::mt19937_64 random(7);
  for (int robots = 0; robots < 50; ++robots) {
    const Robot robot = random_struts(random);
    const MapSlice slice = slice_of(robot, random);
    const auto struts = made_under_upward_rounding<StrutSlice>(*robot, slice);
    for (int poses = 0; poses < 20; ++poses) {
      const double a = uniform(random, -1.0, 1.0), phi = uniform(random, -1.0, 1.0);
      for (std::size_t i = 0; i < 2; ++i) {
        const double expected = half_square(robot, slice, struts.leg(i), a, phi);
        const RoundingUpward rounding;
        const Interval found = struts.half_square<0>(i, SliceTurns(SliceRanges{a, phi})).value();
        EXPECT_NEAR(found.lower(), expected, 1e-11) << robots;
        EXPECT_NEAR(found.upper(), expected, 1e-11) << robots;
        EXPECT_LE(found.upper(), struts.largest_half_square(i));
      }
    }
  }
}

// Each derivative against differences of the one before.
TEST(StrutSlice, HasDerivativesThatAreDifferences) {
  std::mt19937_64 random(8);
  const double step = 1e-4;
  for (int robots = 0; robots < 50; ++robots) {
    const Robot robot = random_struts(random);
    const MapSlice slice = slice_of(robot, random);
    const RoundingUpward rounding;
    const StrutSlice struts(*robot, slice);
    const double a = uniform(random, -1.0, 1.0), phi = uniform(random, -1.0, 1.0);
    const auto jet = [&](double x, double y) {
      return struts.half_square<3>(0, SliceTurns(std::array<double, 2>{x, y}));
    };
    const auto at = jet(a, phi);
    const std::array<Jet<3>, 2> after{jet(a + step / test::pi, phi), jet(a, phi + step / test::pi)};
    const std::array<Jet<3>, 2> before{jet(a - step / test::pi, phi), jet(a, phi - step / test::pi)};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; i + k < 3; ++k)
        for (std::size_t axis = 0; axis < 2; ++axis) {
          const double difference =
              (after[axis].at(i, k).upper() - before[axis].at(i, k).upper()) / (2.0 * step);
          const Interval& slope = axis == 0 ? at.at(i + 1, k) : at.at(i, k + 1);
          EXPECT_NEAR(slope.upper(), difference, 1e-6) << robots << ' ' << i << ' ' << k;
        }
  }
}

TEST(StrutSlice, EnclosesWhatIsInBoxes) {
  std::mt19937_64 random(9);
  for (int boxes = 0; boxes < 500; ++boxes) {
    const Robot robot = random_struts(random);
    const MapSlice slice = slice_of(robot, random);
    const RoundingUpward rounding;
    const StrutSlice struts(*robot, slice);
    Box box{2, {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
      box.lower[i] = uniform(random, -1.2, 1.0);
      box.upper[i] = box.lower[i] + std::pow(10.0, uniform(random, -6.0, -0.7));
    }
    const auto over = struts.half_square<3>(1, SliceTurns(ranges_of(box)));
    const SliceRanges point{uniform(random, box.lower[0], box.upper[0]),
                            uniform(random, box.lower[1], box.upper[1])};
    const auto at = struts.half_square<3>(1, SliceTurns(point));
    for (std::size_t i = 0; i <= 3; ++i)
      for (std::size_t k = 0; i + k <= 3; ++k) {
        EXPECT_LE(over.at(i, k).lower(), at.at(i, k).upper()) << boxes;
        EXPECT_GE(over.at(i, k).upper(), at.at(i, k).lower()) << boxes;
      }
  }
}

}  // namespace
}  // namespace parallel_aspects
