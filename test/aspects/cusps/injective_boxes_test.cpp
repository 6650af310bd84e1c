// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_search.h"
#include "aspects/cusps/planar_held_slice.h"
#include "aspects/cusps/strut_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::uniform;

constexpr int points_of_face = 400;

Robot random_planar_struts(std::mt19937_64& random) {
  test::Points base, anchors;
  for (int j = 0; j < 3; ++j) {
    base.emplace_back(uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0), 0.0);
    anchors.emplace_back(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), 0.0);
  }
  return test::manipulator("random_planar_struts", TaskSpace::SE2, test::struts(base, anchors));
}

// D by central differences of half the squared lengths, which shares nothing with the jets.
double determinant(const StrutSlice& slice, const std::array<double, 2>& at) {
  constexpr double step = 1e-5;
  const auto g = [&slice](std::size_t i, double a, double phi) {
    return slice.half_square<0>(i, SliceTurns(std::array<double, 2>{a, phi})).value().lower();
  };
  const auto slope = [&](std::size_t i, std::size_t axis) {
    const double da = axis == 0 ? step : 0.0, dphi = axis == 1 ? step : 0.0;
    return (g(i, at[0] + da, at[1] + dphi) - g(i, at[0] - da, at[1] - dphi)) / (2.0 * step);
  };
  return slope(0, 0) * slope(1, 1) - slope(0, 1) * slope(1, 0);
}

/// Whether the curve D = 0 passes a point of the face at one end of an axis.
bool is_passed(const StrutSlice& slice, const Box& box, std::size_t axis, bool upper) {
  int positive = 0;
  for (int i = 0; i <= points_of_face; ++i) {
    std::array<double, 2> at{};
    at[axis] = upper ? box.upper[axis] : box.lower[axis];
    at[1 - axis] = box.lower[1 - axis] + box.width(1 - axis) * i / points_of_face;
    positive += determinant(slice, at) > 0.0 ? 1 : 0;
  }
  return positive != 0 && positive != points_of_face + 1;
}

bool is_graph_over_an_edge(const StrutSlice& slice, const Box& box) {
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
    if (!is_passed(slice, box, axis, false) && !is_passed(slice, box, axis, true)) return true;
  return false;
}

// A box about a cusp in which the curve is a graph: it leaves through two opposite faces alone.
TEST(InjectiveBoxes, AboutCuspsAreLeftThroughTwoOppositeFacesAlone) {
  std::mt19937_64 random(31);
  std::size_t seen = 0;
  for (int robots = 0; robots < 60; ++robots) {
    const Robot robot = random_planar_struts(random);
    const MapSlice slice =
        test::slice_of(robot, {{robot->leg(random() % 3).actuated_joint, uniform(random, 0.5, 2.0)}});
    const RoundingUpward rounding;
    const StrutSlice struts(*robot, slice);
    std::vector<Box> cusps;
    for (const CuspBox& cusp : find_cusp_boxes(PlanarHeldSlice(*robot, *slice.joint), {}).cusps)
      cusps.push_back(cusp.box);
    const InjectiveBoxes injective(struts, cusps);
    for (const Box& box : injective.about_cusps()) {
      EXPECT_TRUE(is_graph_over_an_edge(struts, box)) << "robot " << robots;
      ++seen;
    }
  }
  EXPECT_GT(seen, 60U);
}

}  // namespace
}  // namespace parallel_aspects
