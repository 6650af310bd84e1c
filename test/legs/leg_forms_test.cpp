// SPDX-License-Identifier: BSD-3-Clause
// Legs over enclosures, at single poses, against the legs of the model in plain numbers.
#include "interval/interval.h"
#include "legs/planar_leg.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/model/manipulator.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include <cmath>
#include <type_traits>
#include <variant>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double tolerance = 1e-9;

/// A leg that closes at the joint value q.
struct ClosedLeg {
  Leg leg;
  double q = 0.0;
  Vector3d u, d;       // from the proximal point, and from the base point, to the anchor
  double entry = 0.0;  // B_jj
};

/// In the plane, the anchor is above the base.
ClosedLeg closed_leg(test::RandomRobots& random, test::ActuationKind kind, bool planar) {
  ClosedLeg result;
  Leg& leg = result.leg;
  leg = test::named_leg(0);
  leg.actuation = random.actuation(kind, planar);
  auto* revolute = std::get_if<RevoluteActuation>(&leg.actuation);
  if (revolute != nullptr && random.uniform(-1.0, 1.0) < 0.0) revolute->axis = -revolute->axis;
  leg.anchor.z() = planar ? random.uniform(-0.3, 0.3) : 0.0;
  leg.rod_length = random.uniform(0.8, 2.0);
  const auto* strut = std::get_if<StrutActuation>(&leg.actuation);
  result.q = strut == nullptr ? random.uniform(-3.0, 3.0)
                              : strut->sense * (random.uniform(0.4, 2.0) - strut->length_at_zero);
  const double height = leg.anchor.z(), left = leg.squared_distance(result.q) - height * height;
  if (left < 0.01) return closed_leg(random, kind, planar);
  const Vector3d direction = random.vector(planar).normalized();
  result.u = std::sqrt(left) * direction + Vector3d(0.0, 0.0, height);
  result.d = leg.proximal_point(result.q) + result.u - leg.base_point();
  result.entry =
      result.u.dot(leg.proximal_point_derivative(result.q)) + 0.5 * leg.squared_distance_derivative(result.q);
  return result;
}

template <class Form>
constexpr bool planar = std::is_same_v<Form, PlanarLeg>;

template <class Form>
auto enclosed(const Vector3d& v) {
  if constexpr (planar<Form>)
    return Planar<Interval>{v.x(), v.y()};
  else
    return Spatial<Interval>{v.x(), v.y(), v.z()};
}

template <class Vector>
Vector3d middle(const Vector& v, std::size_t dimension) {
  Vector3d result = Vector3d::Zero();
  for (std::size_t i = 0; i < dimension; ++i)
    result[static_cast<Eigen::Index>(i)] = 0.5 * (v[i].lower() + v[i].upper());
  return result;
}

template <class Form, class Check>
void for_random_legs(const Check& check) {
  test::RandomRobots random(20261125);
  for (const test::ActuationKind kind : test::all_actuation_kinds)
    for (int i = 0; i < 500; ++i) {
      SCOPED_TRACE("kind " + std::to_string(static_cast<int>(kind)) + ", trial " + std::to_string(i));
      const ClosedLeg closed = closed_leg(random, kind, planar<Form>);
      if (std::abs(closed.entry) < 0.05) continue;  // the two branches are close to each other
      ASSERT_NO_FATAL_FAILURE(check(random, closed));
    }
}

template <class Form>
void expect_entries_and_directions() {
  for_random_legs<Form>([](test::RandomRobots&, const ClosedLeg& closed) {
    const RoundingUpward rounding;
    const auto form = Form(closed.leg).form(enclosed<Form>(closed.d));
    ASSERT_NEAR(form.squared_b_entry.lower(), closed.entry * closed.entry, tolerance);
    ASSERT_NEAR(form.squared_b_entry.upper(), closed.entry * closed.entry, tolerance);
    constexpr std::size_t dimension = planar<Form> ? 2 : 3;
    Vector3d u = closed.u;
    if (planar<Form>) u.z() = 0.0;
    const Vector3d found = middle(form.fixed, dimension) + closed.entry * middle(form.turned, dimension);
    ASSERT_LT(u.cross(found).norm(), tolerance);
    ASSERT_GT(u.dot(found), 0.0);
  });
}

TEST(PlanarLeg, HasTheEntriesAndDirectionsOfTheModel) { expect_entries_and_directions<PlanarLeg>(); }
TEST(SpatialLeg, HasTheEntriesAndDirectionsOfTheModel) { expect_entries_and_directions<SpatialLeg>(); }

bool contains(const ClosedLeg& closed) {
  if (!closed.leg.actuated_by_angle()) return closed.leg.limits.contain(closed.q);
  bool any = false;
  for (int turns = -3; turns <= 3; ++turns)
    any = any || closed.leg.limits.contain(closed.q + turns * 2.0 * EIGEN_PI);
  return any;
}

template <class Form>
void expect_limits() {
  int inside = 0, outside = 0;
  for_random_legs<Form>([&](test::RandomRobots& random, ClosedLeg closed) {
    JointLimits& limits = closed.leg.limits;
    limits.lower = closed.q + random.uniform(-2.0, 2.0);
    limits.upper = limits.lower + random.uniform(0.1, 4.0);
    const bool held = contains(closed);
    ++(held ? inside : outside);
    const RoundingUpward rounding;
    const auto functions =
        Form(closed.leg)
            .limits(enclosed<Form>(closed.d), Interval(std::abs(closed.entry)), closed.entry > 0.0 ? 1 : -1);
    ASSERT_EQ(verdict(functions), held ? Verdict::holds : Verdict::fails)
        << closed.q << " in " << limits.lower << " to " << limits.upper;
  });
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100);
}

TEST(PlanarLeg, HasTheLimitsOfTheModel) { expect_limits<PlanarLeg>(); }
TEST(SpatialLeg, HasTheLimitsOfTheModel) { expect_limits<SpatialLeg>(); }

template <class Form>
void expect_link_points() {
  for_random_legs<Form>([](test::RandomRobots&, const ClosedLeg& closed) {
    if (!closed.leg.kind().has_straight_rod) return;
    const RoundingUpward rounding;
    const auto points = Form(closed.leg)
                            .link_points(enclosed<Form>(closed.d), Interval(std::abs(closed.entry)),
                                         closed.entry > 0.0 ? 1 : -1);
    ASSERT_TRUE(points);
    constexpr std::size_t dimension = planar<Form> ? 2 : 3;
    const auto is_near = [](Vector3d expected, const Vector3d& found) {
      if (planar<Form>) expected.z() = 0.0;
      return (expected - found).norm() < tolerance;
    };
    ASSERT_TRUE(is_near(closed.leg.base_point(), middle(points->base, dimension)));
    ASSERT_TRUE(is_near(closed.leg.proximal_point(closed.q), middle(points->joint, dimension)));
    ASSERT_TRUE(is_near(closed.leg.base_point() + closed.d, middle(points->anchor, dimension)));
    ASSERT_NEAR(points->length.upper(), closed.u.norm(), tolerance);
  });
}

TEST(PlanarLeg, HasTheLinksOfTheModel) { expect_link_points<PlanarLeg>(); }
TEST(SpatialLeg, HasTheLinksOfTheModel) { expect_link_points<SpatialLeg>(); }

}  // namespace
}  // namespace parallel_aspects
