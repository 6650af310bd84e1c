// SPDX-License-Identifier: BSD-3-Clause
// Rows about the centroid against those of the leg seen from its base point, which maps are proved with.
#include "distance/centered_leg.h"

#include "legs/leg_rows.h"
#include "legs/spatial_leg.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

Spatial<Interval> enclosed(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

void expect_same(const Interval& a, const Interval& b, double size) {
  EXPECT_LE(std::max(a.lower(), b.lower()), std::min(a.upper(), b.upper()));
  EXPECT_LT(a.upper() - a.lower(), 1e-12 * size);
}

class EveryKindOfLeg : public testing::TestWithParam<test::ActuationKind> {};

TEST_P(EveryKindOfLeg, HasTheRowsThatItHasFromItsBasePoint) {
  test::RandomRobots random(20261126);
  for (int i = 0; i < 200; ++i) {
    Leg leg = test::named_leg(0);
    leg.actuation = random.actuation(GetParam(), false);
    leg.rod_length = random.uniform(0.8, 2.0);
    const RoundingUpward rounding;
    const Spatial<Interval> b = enclosed(random.vector()), e = enclosed(random.vector());
    const LegRows<Interval, 6> rows = CenteredLeg(leg).rows(b, e, squared_norm(b), Interval(squared_norm(e)));
    const Spatial<Interval> d{b[0] + e[0], b[1] + e[1], b[2] + e[2]};
    const auto from_base = leg_rows<TaskSpace::SE3>(SpatialLeg(leg).form(d), b);
    const double size = 100.0;  // of fourth powers of a few metres
    expect_same(rows.squared_b_entry, from_base.squared_b_entry, size);
    for (std::size_t k = 0; k < 6; ++k) {
      expect_same(rows.fixed[k], from_base.fixed[k], size);
      expect_same(rows.turned[k], from_base.turned[k], size);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(CenteredLeg, EveryKindOfLeg, testing::ValuesIn(test::all_actuation_kinds));

}  // namespace
}  // namespace parallel_aspects
