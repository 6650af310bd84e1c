// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <vector>

// P. R. McAree and R. W. Daniel, An explanation of never-special assembly changing motions for 3-3 parallel
// manipulators (1999): with similar triangles of platform and base a 3-RPR has no such motions. The formulas
// here are those of docs/theory/uniqueness.md, "Against a theorem".

namespace parallel_aspects {
namespace {

using Plane = std::complex<double>;

/// A 3-RPR of which the platform is the triangle of the base times `scale`.
struct SimilarTriangles {
  std::array<Plane, 3> base;
  double scale = 0.5;

  Plane circumcenter() const {
    const Plane u = base[1] - base[0], v = base[2] - base[0];
    return base[0] + (u * std::norm(v) - v * std::norm(u)) / (u * std::conj(v) - v * std::conj(u));
  }

  double circumradius() const { return std::abs(base[0] - circumcenter()); }

  /// How far a point of unit scale is moved by turning it to phi = 0 or 180 degrees, and scaling it.
  std::array<double, 2> moves() const { return {std::abs(1.0 - scale), 1.0 + scale}; }

  /// An offset of one anchor ends the similarity; `mirrored` is at its line y = 0.
  test::Robot robot(const JointLimits& limits = {}, const Plane& offset = {}, bool mirrored = false) const {
    test::Points centers, anchors;
    for (const Plane& each : base) {
      centers.emplace_back(each.real(), each.imag(), 0.0);
      anchors.emplace_back(scale * each.real(), (mirrored ? -scale : scale) * each.imag(), 0.0);
    }
    anchors[1] += Eigen::Vector3d(offset.real(), offset.imag(), 0.0);
    std::vector<Leg> legs = test::struts(centers, anchors);
    for (Leg& leg : legs) leg.limits = limits;
    return test::manipulator("similar_triangles", TaskSpace::SE2, legs);
  }
};

/// Coordinates in sixteenths, so that the triangles are similar without rounding.
SimilarTriangles random_triangles(std::mt19937_64& random, double scale) {
  SimilarTriangles result;
  result.scale = scale;
  const auto coordinate = [&] { return std::round(test::uniform(random, -20.0, 20.0)) / 16.0; };
  do
    for (Plane& each : result.base) each = {coordinate(), coordinate()};
  while (!(result.circumradius() < 2.0));
  return result;
}

/// Lengths of all legs where both factors of det A vanish, with that of leg 1 held.
std::vector<Eigen::Vector3d> crossings(const SimilarTriangles& of, double held) {
  std::vector<Eigen::Vector3d> result;
  const Plane center = of.circumcenter(), first = of.base[0] - center;
  for (const double move : of.moves()) {
    const double half_chord = held / (2.0 * move * of.circumradius());
    if (half_chord >= 1.0) continue;
    for (const double side : {-2.0, 2.0}) {
      const Plane at = center + first * std::polar(1.0, side * std::asin(half_chord));
      result.emplace_back(held, move * std::abs(of.base[1] - at), move * std::abs(of.base[2] - at));
    }
  }
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  return result;
}

/// The number of direct solutions, by two quadratic equations.
std::size_t count_solutions(const SimilarTriangles& of, const JointVector& lengths) {
  Eigen::Matrix3d rows;
  for (int j = 0; j < 3; ++j) {
    const Plane c = of.base[static_cast<std::size_t>(j)] - of.circumcenter();
    rows.row(j) << 1.0, 2.0 * c.real(), -2.0 * c.imag();
  }
  const Eigen::Vector3d u_w = rows.inverse() * lengths.cwiseAbs2();
  const double radius = of.circumradius(), u = u_w[0], w = u_w.tail<2>().norm();
  const double discriminant = u * u - 4.0 * radius * radius * w * w;
  if (!(discriminant > 0.0)) return 0;
  std::size_t count = 0;
  for (const double sign : {-1.0, 1.0}) {
    const double v = (u + sign * std::sqrt(discriminant)) / (2.0 * radius * radius);
    const auto [least, most] = of.moves();
    if (v > least * least && v < most * most) count += 2;
  }
  return count;
}

std::shared_ptr<const Uniqueness> uniqueness_of(const test::Robot& robot,
                                                const std::optional<double>& held = {}) {
  UniquenessOptions options;
  options.most_cells = 30000;
  return held ? test::uniqueness_of_slice(robot, 0, *held, options) : test::uniqueness_of(robot, options);
}

/// No two solutions of a basic component lie in one connected set of the map, be sets that it does not prove
/// apart one aspect or not.
void expect_no_two_together(const Uniqueness& found) {
  EXPECT_FALSE(found.basic_components.empty());
  for (const BasicComponent& component : found.basic_components) {
    std::set<int> aspects;
    for (const Pose& pose : component.solutions) {
      const int aspect = found.map->locate(pose, found.map->aspects().front().mode).aspect;
      if (aspect != 0) {
        EXPECT_TRUE(aspects.insert(aspect).second) << component.inside.transpose();
      }
    }
  }
}

/// All of this is proved, without the theorem.
void expect_unique(const Uniqueness& found) {
  expect_no_two_together(found);
  for (const Aspect& aspect : found.map->aspects()) EXPECT_TRUE(aspect.unresolved_with.empty());
  for (const BasicComponent& component : found.basic_components) {
    const std::set<int> aspects(component.aspects.begin(), component.aspects.end());
    EXPECT_EQ(aspects.size(), component.aspects.size());
    EXPECT_EQ(aspects.count(0), 0U);
  }
  EXPECT_FALSE(found.basic_regions.empty());
  for (const BasicRegion& region : found.basic_regions) EXPECT_TRUE(region.is_unique);
}

/// Each region of an aspect is in its one domain.
void expect_one_domain_each(const Uniqueness& found) {
  EXPECT_EQ(found.domains.size(), found.map->aspects().size());
  for (const UniquenessDomain& domain : found.domains)
    for (std::size_t i = 0; i < found.basic_regions.size(); ++i)
      if (found.basic_regions[i].aspect == domain.aspect) {
        EXPECT_EQ(std::count(domain.basic_regions.begin(), domain.basic_regions.end(), i), 1);
      }
}

std::size_t compare_numbers(const SimilarTriangles& of, const Uniqueness& found, std::mt19937_64& random) {
  std::size_t compared = 0;
  for (int k = 0; k < 2000; ++k) {
    JointVector q = found.basic_components.front().inside;
    for (int i = 1; i < 3; ++i) q[i] = test::uniform(random, 0.0, q[0] + 4.0 * of.circumradius());
    const auto component = found.component_at(q);
    if (!component) continue;
    ++compared;
    EXPECT_EQ(found.basic_components[*component].solutions.size(), count_solutions(of, q)) << q.transpose();
  }
  return compared;
}

// Leg 1 is longer than the diameters of both circumcircles together: there the second factor of det A does
// not vanish.
TEST(SimilarTriangles, HaveNoCuspsWhereALegIsLong) {
  std::mt19937_64 random(7);
  for (const double scale : {0.3, 0.5, 0.9, 1.5}) {
    const SimilarTriangles triangles = random_triangles(random, scale);
    const double held = 2.1 * triangles.circumradius() * (1.0 + scale);
    EXPECT_TRUE(crossings(triangles, held).empty());
    const auto found = uniqueness_of(triangles.robot(), held);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->cusps.empty() && found->cusps_complete);
    EXPECT_TRUE(found->nodes.empty() && found->nodes_complete);
    expect_unique(*found);
  }
}

// Where four solutions meet, the gradient of det A vanishes. That is no ordinary cusp, and stays undecided.
TEST(SimilarTriangles, ListNoCuspWhereFourSolutionsMeet) {
  std::mt19937_64 random(8);
  const SimilarTriangles triangles = random_triangles(random, 0.75);
  const double held = 0.5 * triangles.circumradius() * (1.0 + triangles.scale);
  EXPECT_FALSE(crossings(triangles, held).empty());
  const auto found = uniqueness_of(triangles.robot(), held);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->cusps.empty());
  EXPECT_FALSE(found->cusps_complete);
  EXPECT_FALSE(found->nodes_complete);
  expect_no_two_together(*found);
  EXPECT_GT(compare_numbers(triangles, *found, random), 100U);
}

// (phi^2 - a)^2 = b becomes phi^4 - 2 a phi^2 + e phi = b - a^2, which has one cusp, with phi^3 = e / 8.
TEST(SimilarTriangles, HaveACuspBesideEachSuchPlaceOnceTheyAreNotSimilar) {
  std::mt19937_64 random(9);
  for (const double scale : {0.3, 0.5, 0.9, 1.5}) {
    const SimilarTriangles triangles = random_triangles(random, scale);
    const auto robot = triangles.robot({}, {1e-6, 0.7e-6});
    const double diameter = 2.0 * triangles.circumradius();
    const auto [least, most] = triangles.moves();
    for (const double held : {0.2 * least * diameter, 0.6 * most * diameter, 1.1 * most * diameter}) {
      const std::vector<Eigen::Vector3d> expected = crossings(triangles, held);
      const CuspList found = find_cusps(*robot, HeldJoint{0, held});
      EXPECT_TRUE(found.complete);
      ASSERT_EQ(found.cusps.size(), expected.size()) << "scale " << scale << ", held " << held;
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_LT((found.cusps[i].actuated - expected[i]).norm(), 1e-2);
    }
  }
}

class SimilarTrianglesWithin : public testing::Test {
 protected:
  // Both factors vanish within these, but nowhere at once.
  const JointLimits limits{0.9, 2.1};
  const SimilarTriangles triangles{{Plane{1.0, 0.0}, Plane{-0.5, 0.875}, Plane{-0.5, -0.875}}, 0.5};
  const test::Robot robot = triangles.robot(limits);
};

TEST_F(SimilarTrianglesWithin, HaveNoCusps) {
  for (std::size_t leg = 0; leg < 3; ++leg) {
    const CuspCurves found = find_cusp_curves(*robot, {leg, limits.lower, limits.upper});
    EXPECT_TRUE(found.curves.empty() && found.complete);
  }
}

TEST_F(SimilarTrianglesWithin, HaveAUniquenessDomainForEachAspect) {
  for (const std::optional<double>& held : {std::optional<double>(), std::optional<double>(1.0)}) {
    const auto found = uniqueness_of(robot, held);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->map->aspects().size(), 4U);
    EXPECT_EQ(found->regions.back().solutions, 4U);
    expect_unique(*found);
    expect_one_domain_each(*found);
  }
}

// The platform is turned over: these triangles are similar, too, but only as mirror images.
TEST_F(SimilarTrianglesWithin, HaveCuspsOnceOneIsMirrored) {
  const CuspList found = find_cusps(*triangles.robot({}, {}, true), HeldJoint{0, 1.0});
  EXPECT_TRUE(found.complete);
  EXPECT_FALSE(found.cusps.empty());
}

}  // namespace
}  // namespace parallel_aspects
