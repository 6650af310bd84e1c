// SPDX-License-Identifier: BSD-3-Clause
#include "interval/path_form.h"

#include "aspects/roadmap/pose_segment.h"

#include <gtest/gtest.h>

#include "support/random_robots.h"
#include <array>
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

using Real = long double;

// Long doubles carry 64 bits; theirs is the rounding that is allowed here.
constexpr Real allowed = 1e-17L;

bool holds(const Interval& interval, Real value) {
  const Real allowance = allowed * (1.0L + std::abs(value));
  return interval.lower() - allowance <= value && value <= interval.upper() + allowance;
}

Interval widened(const Interval& slope, double s) {
  return slope * Interval(std::min(s, 0.0), std::max(s, 0.0));
}

// A value at s lies in the range, and in the cone that the slope allows from the center.
void expect_enclosed(const PathForm& form, Real at_center, Real at_s, double s) {
  ASSERT_TRUE(holds(form.center, at_center));
  ASSERT_TRUE(holds(form.range, at_s));
  ASSERT_TRUE(holds(form.center + widened(form.slope, s), at_s));
}

template <class Scalar>
Scalar expression(const Scalar& t, const std::array<double, 6>& c) {
  using std::sqrt;
  const Scalar p = Scalar(c[0]) + Scalar(c[1]) * t, q = square(t - Scalar(c[2])) + Scalar(1.5);
  const Scalar r = reciprocal(q) * p - square(p) * Scalar(c[3]);
  return square_root(square(r) + Scalar(0.25)) * t - Scalar(c[4]) * r + Scalar(c[5]);
}

struct Plain {
  Real value;
  explicit Plain(Real x) : value(x) {}
  friend Plain operator+(Plain a, Plain b) { return Plain(a.value + b.value); }
  friend Plain operator-(Plain a, Plain b) { return Plain(a.value - b.value); }
  friend Plain operator*(Plain a, Plain b) { return Plain(a.value * b.value); }
  friend Plain square(Plain a) { return a * a; }
  friend Plain reciprocal(Plain a) { return Plain(1.0L / a.value); }
  friend Plain square_root(Plain a) { return Plain(std::sqrt(a.value)); }
};

TEST(PathForm, EnclosesValuesAndSlopesOfRandomExpressions) {
  test::RandomRobots random(11);
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 6> c{};
    for (double& each : c) each = random.uniform(-2.0, 2.0);
    const double begin = random.uniform(-1.0, 1.0), end = begin + std::pow(10.0, random.uniform(-12.0, 0.0));
    const double middle = 0.5 * (begin + end), share = random.uniform(0.0, 1.0);
    const double t = std::min(end, begin + share * (end - begin));
    const Real center = expression(Plain(middle), c).value, there = expression(Plain(t), c).value;
    const RoundingUpward rounding;
    const PathForm parameter = PathForm::parameter(begin, middle, end);
    const double half = parameter.slope.upper(), s = (t - middle) / half;
    ASSERT_NO_FATAL_FAILURE(expect_enclosed(expression(parameter, c), center, there,
                                            std::clamp(s + (s < 0.0 ? -1e-9 : 1e-9), -1.0, 1.0)))
        << i << ": " << begin << " to " << end << " at " << t;
  }
}

// Ranges are tight to the second order: halving the part divides their excess by about four.
TEST(PathForm, RangesAreTightToTheSecondOrder) {
  const std::array<double, 6> c{0.3, -1.2, 0.4, 0.8, -0.5, 1.1};
  double before = 0.0;
  for (int level = 2; level < 12; ++level) {
    const double half = std::ldexp(1.0, -level);
    Real lowest = HUGE_VALL, highest = -HUGE_VALL;
    for (int i = 0; i <= 1000; ++i) {
      const Real value = expression(Plain(0.2 + half * (i / 500.0 - 1.0)), c).value;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    const RoundingUpward rounding;
    const Interval range = expression(PathForm::parameter(0.2 - half, 0.2, 0.2 + half), c).range;
    const double excess = static_cast<double>(lowest - range.lower() + (range.upper() - highest));
    if (level > 4) {
      EXPECT_LT(excess, 0.35 * before) << level;
    }
    before = excess;
  }
}

TEST(PoseSegment, PlacementsHoldThePosesOfTheSegment) {
  test::RandomRobots random(12);
  for (int i = 0; i < 20000; ++i) {
    const Pose from = random.pose(TaskSpace::SE3), to = random.pose(TaskSpace::SE3);
    const double begin = random.uniform(0.0, 1.0);
    const double end = std::min(1.0, begin + std::pow(10.0, random.uniform(-9.0, 0.0)));
    const double t = std::min(end, begin + random.uniform(0.0, 1.0) * (end - begin));
    const Pose pose = pose_between(from, to, t);
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    const RoundingUpward rounding;
    PoseSegment::Placement placement;
    const double middle = 0.5 * (begin + end);
    if (!PoseSegment(from, to).place(PathForm::parameter(begin, middle, end), placement)) continue;
    for (Eigen::Index row = 0; row < 3; ++row) {
      const auto at = static_cast<std::size_t>(row);
      // `pose_between` rounds: a few units in the last place.
      const auto holds_nearly = [](const Interval& interval, double value) {
        return interval.lower() - 1e-14 <= value && value <= interval.upper() + 1e-14;
      };
      ASSERT_TRUE(holds_nearly(placement.position[at].range, pose.position[row])) << i;
      for (Eigen::Index column = 0; column < 3; ++column)
        ASSERT_TRUE(holds_nearly(placement.rotation[at][static_cast<std::size_t>(column)].range,
                                 rotation(row, column)))
            << i;
    }
  }
}

// The exact ends are in the enclosure of every part that holds them.
TEST(PoseSegment, EndsAreThePosesThemselves) {
  test::RandomRobots random(13);
  for (int i = 0; i < 100; ++i) {
    const Pose from = random.pose(TaskSpace::SE3), to = random.pose(TaskSpace::SE3);
    EXPECT_LT((pose_between(from, to, 0.0).position - from.position).norm(), 1e-15);
    EXPECT_LT((pose_between(from, to, 1.0).position - to.position).norm(), 1e-15);
    EXPECT_LT(pose_between(from, to, 1.0).orientation.angularDistance(to.orientation), 1e-7);
    const RoundingUpward rounding;
    PoseSegment::Placement placement;
    ASSERT_TRUE(PoseSegment(from, to).place(PathForm::parameter(1.0, 1.0, 1.0), placement));
    for (std::size_t k = 0; k < 3; ++k) {
      const double end = to.position[static_cast<Eigen::Index>(k)];
      EXPECT_LE(placement.position[k].range.lower(), end);
      EXPECT_GE(placement.position[k].range.upper(), end);
    }
  }
}

}  // namespace
}  // namespace parallel_aspects
