// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_classifier.h"
#include "aspects/tree/slice_space.h"
#include "interval/interval.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace parallel_aspects {
namespace {

using test::Held;
using test::random_position;
using test::Robot;
using test::slice_of;
using test::uniform;

// Boxes that are small enough to be decided, of every orientation at one position.
TEST(SliceClassifier, NoOrientationContradictsItsBox) {
  const Robot robot = test::shipped("hexa")->manipulator();
  const MapSlice slice = slice_of(robot, {{"x", 0.05}, {"y", 0.0}, {"z", -0.6}});
  const auto modes = working_modes(*robot);
  const auto classifier = make_slice_classifier(*robot, modes, slice);
  const auto space = make_slice_space(slice, Box{}, 1.0);
  std::mt19937_64 random(12);
  int decided = 0;
  for (int i = 0; i < 1000; ++i) {
    const MapPosition corner = random_position(*space, random);
    Box box{3, corner.point, corner.point};
    for (double& upper : box.upper) upper += std::pow(2.0, uniform(random, -9.0, -5.0));
    std::vector<LeafState> states(modes.size());
    {
      const RoundingUpward rounding;
      classifier->classify(corner.root, box, ~ModeSet{0}, Detail::parts, states.data());
    }
    for (int k = 0; k < 3; ++k) {
      MapPosition at = corner;
      for (std::size_t j = 0; j < 3; ++j) at.point[j] = uniform(random, box.lower[j], box.upper[j]);
      for (std::size_t mode = 0; mode < modes.size(); ++mode) {
        const auto sign = test::sign_at(*robot, space->pose(at), modes[mode]);
        if (!sign) continue;
        decided += states[mode].is_inside();
        ASSERT_FALSE(states[mode].is_inside() ? !states[mode].is_inside(*sign)
                                              : *sign != 0 && !states[mode].may_be(*sign))
            << "trial " << i << ", mode " << to_string(modes[mode]);
      }
    }
  }
  EXPECT_GT(decided, 1000);
}

// The charts of slices take every leg in space; those of whole task spaces know what the space leaves out.
void expect_agreement(const Robot& robot, const Held& held, std::size_t held_axis, double at) {
  const auto modes = working_modes(*robot);
  const MapSlice slice = slice_of(robot, held);
  const auto whole = make_box_classifier(*robot, modes), sliced = make_slice_classifier(*robot, modes, slice);
  const Box region = *whole->reachable_positions();
  std::mt19937_64 random(10);
  std::map<std::pair<bool, bool>, int> decided;
  const RoundingUpward rounding;
  for (int i = 0; i < 5000; ++i) {
    const double width = std::pow(2.0, uniform(random, -9.0, -2.0)) * region.width(0);
    Box flat{3, {}, {}}, box{2, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      flat.lower[k] = box.lower[k] = uniform(random, region.lower[k], region.upper[k]);
      flat.upper[k] = box.upper[k] = box.lower[k] + width;
    }
    flat.lower[held_axis] = flat.upper[held_axis] = at;
    for (std::size_t mode = 0; mode < modes.size(); ++mode) {
      const LeafState one = whole->state(0, flat, mode), other = sliced->state(0, box, mode);
      ++decided[{one.is_undecided(), other.is_undecided()}];
      if (one.is_undecided() || other.is_undecided()) continue;
      ASSERT_EQ(one.is_inside(1), other.is_inside(1)) << robot->name() << ", trial " << i;
      ASSERT_EQ(one.is_inside(-1), other.is_inside(-1)) << robot->name() << ", trial " << i;
    }
  }
  const int both = decided[{false, false}], apart = decided[{true, false}] + decided[{false, true}];
  EXPECT_GT(both, 1000);
  EXPECT_LT(apart, both / 5);
}

TEST(SliceClassifier, AgreesWithThatOfAllPoses) {
  expect_agreement(test::three_rrr(), {{"phi", 0.0}}, 2, 0.0);
  expect_agreement(test::three_rrr_actuated_elbow(), {{"phi", 0.0}}, 2, 0.0);
  expect_agreement(test::three_rpr(), {{"phi", 0.0}}, 2, 0.0);
  expect_agreement(test::delta(), {{"z", -0.5}}, 2, -0.5);
}

}  // namespace
}  // namespace parallel_aspects
