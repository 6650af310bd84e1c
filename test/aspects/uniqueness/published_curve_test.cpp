// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include <array>
#include <cmath>
#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// A slice of a 3-RPR against the exact curve of its actuated values where direct solutions meet, and against
// the regions that this curve divides the plane into, as published by Breiding, Cobb, Englander, Farnsworth,
// Hauenstein, Henriksson, Johnson, Lopez Garcia and Mundayur, Elimination Without Eliminating
// (arXiv:2601.04383). test/data/three_rpr_curve.txt has the curve, and where it is from.

namespace parallel_aspects {
namespace {

using Number = boost::multiprecision::cpp_bin_float_50;
using Values = std::array<double, 2>;

/// h over the squared lengths of legs 1 and 2, which double precision does not resolve near its singular
/// points.
class Curve {
 public:
  Curve() {
    std::istringstream file(test::source_file("test/data/three_rpr_curve.txt"));
    for (std::string line; std::getline(file, line);) {
      if (line.empty() || line.front() == '#') continue;
      std::istringstream words(line);
      Term term;
      std::string coefficient;
      words >> term.powers[0] >> term.powers[1] >> coefficient;
      term.coefficient = Number(coefficient);
      terms_.push_back(term);
    }
  }

  std::size_t size() const { return terms_.size(); }

  /// The derivative that is taken `times` by each of the squared lengths, at these lengths of legs 1 and 2.
  Number derivative(const std::array<int, 2>& times, const JointVector& lengths) const {
    Number sum = 0;
    for (const Term& term : terms_) {
      Number product = term.coefficient;
      for (std::size_t i = 0; i < 2; ++i) {
        const Number length = lengths[static_cast<Eigen::Index>(i)];
        for (int k = 0; k < term.powers[i]; ++k)
          product *= k < times[i] ? Number(term.powers[i] - k) : length * length;
        if (term.powers[i] < times[i]) product = 0;
      }
      sum += product;
    }
    return sum;
  }

 private:
  struct Term {
    std::array<int, 2> powers{};
    Number coefficient;
  };
  std::vector<Term> terms_;
};

/// What there is of h near a point, in units of the norm of its Hessian.
struct LocalCurve {
  double value, slope, determinant;

  LocalCurve(const Curve& curve, const JointVector& lengths) {
    const auto at = [&](int first, int second) { return curve.derivative({first, second}, lengths); };
    const Number xx = at(2, 0), xy = at(1, 1), yy = at(0, 2), norm = sqrt(xx * xx + 2 * xy * xy + yy * yy);
    value = static_cast<double>(abs(at(0, 0)) / norm);
    slope = static_cast<double>((abs(at(1, 0)) + abs(at(0, 1))) / norm);
    determinant = static_cast<double>((xx * yy - xy * xy) / (norm * norm));
  }
};

/// Of points of the curve that are off by less than 1e-13.
void expect_singular(const LocalCurve& there) {
  EXPECT_LT(there.value, 1e-26);
  EXPECT_LT(there.slope, 1e-13);
}

test::Robot robot_with_limits(const JointLimits& limits) {
  std::vector<Leg> legs = test::struts({{0.0, 0.0, 0.0}, {1.6, 0.0, 0.0}, {0.9, 0.6, 0.0}},
                                       {{0.0, 0.0, 0.0}, {1.4, 0.0, 0.0}, {0.7, 1.0, 0.0}});
  for (Leg& leg : legs) leg.limits = limits;
  return test::manipulator("three_rpr_of_curve", TaskSpace::SE2, legs);
}

class PublishedCurve : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    robot = robot_with_limits(JointLimits{});
    UniquenessOptions options;
    options.slice = test::slice_of(robot, {{robot->leg(2).actuated_joint, 1.0}});
    found = test::uniqueness_of(robot, options);
    ASSERT_TRUE(found);
  }

  static void TearDownTestSuite() {
    found.reset();
    robot.reset();
  }

  static test::Robot robot;
  static std::shared_ptr<const Uniqueness> found;
};

test::Robot PublishedCurve::robot;
std::shared_ptr<const Uniqueness> PublishedCurve::found;

template <class Point>
void expect_squared_lengths(const std::vector<Point>& points, const std::vector<Values>& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const double length = points[i].actuated[static_cast<Eigen::Index>(k)];
      EXPECT_NEAR(length * length, expected[i][k], 1e-13);
    }
}

// The discriminant of h by c2 is a constant times c1^2 P Q^3 R^2 with polynomials of c1 that are irreducible:
// P of degree 4, whose zeros are tangents; Q of degree 24, with six real zeros, all of them cusps; and R of
// degree 24, with eight real zeros, at two of which c1 or c2 is negative. By exact arithmetic, so that these
// are all.
TEST_F(PublishedCurve, HasTheseCuspsAndNodesAlone) {
  EXPECT_TRUE(found->cusps_complete);
  EXPECT_TRUE(found->nodes_complete);
  expect_squared_lengths(found->cusps, {{0.0886922054063661, 0.4921531907475189},
                                        {0.7490498405053696, 0.1299415356358096},
                                        {1.2953246205137084, 2.8992514218504105},
                                        {1.7083217815204723, 5.0395088999119507},
                                        {2.9750212193600899, 1.6877259450317849},
                                        {5.7798363887557391, 1.3160535398059543}});
  expect_squared_lengths(found->nodes, {{0.2291101456324551, 1.4171670288558810},
                                        {0.4063054303239526, 0.3336737052239636},
                                        {0.4479937622653044, 0.7599028317708196},
                                        {0.6848791000347983, 0.2504645586627589},
                                        {0.7485816855821692, 0.2339307270514314},
                                        {1.5804057130065754, 0.0783222772321705}});
}

TEST_F(PublishedCurve, IsSingularThere) {
  const Curve curve;
  ASSERT_EQ(curve.size(), 91U);
  for (const Cusp& cusp : found->cusps) {
    const LocalCurve there(curve, cusp.actuated);
    expect_singular(there);
    EXPECT_LT(std::abs(there.determinant), 1e-12);
  }
  for (const SolutionNode& node : found->nodes) {
    const LocalCurve there(curve, node.actuated);
    expect_singular(there);
    EXPECT_LT(there.determinant, -1e-3);
  }
}

/// A published region: squared lengths of the legs in it, and how many direct solutions there are.
struct PublishedRegion {
  std::size_t solutions = 0;
  std::vector<std::array<double, 3>> points;
};

/// The basic component that holds all these points, with as many solutions; nothing where no number is
/// proved.
std::optional<std::size_t> component_of(const Uniqueness& found, const PublishedRegion& region) {
  std::set<std::optional<std::size_t>> components;
  for (const auto& [first, second, third] : region.points) {
    const JointVector q = Eigen::Vector3d(first, second, third).cwiseSqrt();
    EXPECT_EQ(direct(*found.map->manipulator(), q).solutions.size(), region.solutions) << q.transpose();
    components.insert(found.component_at(q));
    EXPECT_EQ(components.size(), 1U) << q.transpose();
  }
  const std::optional<std::size_t> result = *components.begin();
  if (result) {
    EXPECT_EQ(found.basic_components[*result].solutions.size(), region.solutions);
  }
  return result;
}

/// How many published regions have a basic component; no two have the same.
std::size_t count_components(const Uniqueness& found, const std::vector<PublishedRegion>& regions) {
  std::set<std::size_t> components;
  for (const PublishedRegion& region : regions)
    if (const auto component = component_of(found, region);
        component && !components.insert(*component).second)
      ADD_FAILURE() << "two regions are one component";
  return components.size();
}

// results/3RPRv0/routing_points.txt and connected_components.txt, rounded; the numbers of solutions are from
// Sturm's theorem. Three more points of the first region have negative squares.
TEST_F(PublishedCurve, DividesTheLengthsIntoThePublishedRegions) {
  const std::vector<PublishedRegion> regions{
      {0,
       {{3.176809, 10.583294, 1},
        {8.164630, 10.334862, 1},
        {11.423581, 3.050365, 1},
        {1.206299, 10.228032, 1}}},
      {4,
       {{4.396065, 1.305412, 1},
        {1.038851, 2.718499, 1},
        {3.533285, 1.790103, 1},
        {2.387257, 2.688155, 1},
        {1.158127, 3.267464, 1}}},
      {2, {{1.318923, 0.073482, 1}, {0.773145, 0.079133, 1}, {0.597916, 0.237005, 1}}},
      {6, {{2.076728, 1.747532, 1}}},
      {4, {{0.433014, 0.571844, 1}}},
      {2, {{0.213202, 1.109640, 1}, {0.237999, 0.411744, 1}, {0.054503, 0.495922, 1}}},
      {4, {{0.723326, 0.218020, 1}}},
      {2, {{6.282217, 0.963350, 1}, {4.802597, 4.431306, 1}, {7.198372, 1.311656, 1}}}};
  EXPECT_EQ(count_components(*found, regions), 7U);
}

// With leg 3 of any length: results/3RPRv1, likewise, of which these points are within limits. There are two
// more regions, one without solutions and one with two, which limits divide. 250,000 cells, which take ten
// times as long, prove numbers in all seven; these, in five.
TEST(PublishedRegions, OfAllLengthsAreBasicComponents) {
  const std::vector<PublishedRegion> regions{{4, {{0.800168, 1.726274, 0.541417}}},
                                             {4, {{1.297565, 0.663433, 0.287734}}},
                                             {4, {{0.981817, 1.574170, 2.425483}}},
                                             {4,
                                              {{3.948271, 0.985606, 1.730674},
                                               {1.071920, 3.537586, 2.221451},
                                               {2.760430, 1.994564, 4.393343},
                                               {3.795949, 3.370630, 0.158831},
                                               {4.453424, 1.415821, 0.897738},
                                               {4.124655, 1.053667, 4.401841},
                                               {1.356093, 4.328990, 1.238483}}},
                                             {4, {{4.479408, 4.054047, 2.830361}}},
                                             {4, {{1.155241, 0.335782, 1.499531}}},
                                             {6, {{2.221053, 2.252070, 1.580503}}}};
  UniquenessOptions options;
  options.most_cells = 30000;
  const auto found = test::uniqueness_of(robot_with_limits(JointLimits{0.3, 2.15}), options);
  ASSERT_TRUE(found);
  EXPECT_GE(count_components(*found, regions), 5U);
}

// All components but some that are left over beside the curve are among them.
TEST_F(PublishedCurve, LeavesNoOtherComponents) {
  double others = 0.0;
  for (std::size_t i = 7; i < found->basic_components.size(); ++i)
    others += found->basic_components[i].measure;
  EXPECT_LT(others, 1e-5);
}

// By the roots of h along 40,000 lines and Sturm's theorem between them [m^2].
TEST_F(PublishedCurve, HasTheseMeasures) {
  const std::vector<std::array<double, 2>> expected{{2, 5.15033}, {4, 1.31513}, {6, 0.372857}};
  ASSERT_EQ(found->regions.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(static_cast<double>(found->regions[i].solutions), expected[i][0]);
    EXPECT_LT(found->regions[i].measure_lower, expected[i][1]);
    EXPECT_GT(found->regions[i].measure_upper, expected[i][1]);
  }
}

}  // namespace
}  // namespace parallel_aspects
