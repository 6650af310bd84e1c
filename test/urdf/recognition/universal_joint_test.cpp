// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/passive_limits.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

struct Universal {
  UniversalAxis first, second;
  Vector3d rod;
};

class UniversalJoint : public testing::Test {
 protected:
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random);
  }

  // In some direction, at some elevation of the rod, on either side of the second axis, with zeros anywhere.
  Universal random_joint(double elevation_now) {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 1.0).normalized();
    Universal joint;
    joint.first = {"first", turn * Vector3d::UnitZ(), uniform(-3.0, 3.0), {}};
    joint.second = {
        "second", turn * Vector3d::UnitX() * (uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0), uniform(-3.0, 3.0), {}};
    const Vector3d across = turn * Vector3d::UnitY() * (uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
    joint.rod =
        uniform(0.2, 3.0) * (std::cos(elevation_now) * across + std::sin(elevation_now) * joint.first.axis);
    return joint;
  }

  static Vector3d rod_at(const Universal& joint, double first, double second) {
    return AngleAxisd(first - joint.first.value, joint.first.axis) *
           (AngleAxisd(second - joint.second.value, joint.second.axis) * joint.rod);
  }

  static double clearance(const std::vector<LimitedDirection>& cones, const Vector3d& rod) {
    double least = EIGEN_PI;
    for (const LimitedDirection& cone : cones)
      least = std::min(least, cone.angle - std::acos(std::clamp(rod.normalized().dot(cone.axis), -1.0, 1.0)));
    return least;
  }

  std::mt19937_64 random{20261122};
};

// What both joints allow is in all the cones, and what one of them forbids is outside of one.
TEST_F(UniversalJoint, AllowsWhatAllItsConesHold) {
  int inside = 0, outside = 0;
  for (int i = 0; i < 2000; ++i) {
    const double now = uniform(-1.0, 1.0);
    Universal joint = random_joint(now);
    // The elevation grows or falls with the second joint, and stays below a quarter of a turn.
    const double below = uniform(0.05, 0.5 * EIGEN_PI - std::abs(now)),
                 above = uniform(0.05, 0.5 * EIGEN_PI - std::abs(now));
    joint.second.limits = {joint.second.value - below, joint.second.value + above};
    const double back = uniform(0.0, 1.5), ahead = uniform(0.0, 1.5);
    if (i % 4 != 0) joint.first.limits = {joint.first.value - back, joint.first.value + ahead};
    const auto cones = limited_directions(joint.first, joint.second, joint.rod);
    ASSERT_TRUE(cones);
    ASSERT_EQ(cones->size(), i % 4 != 0 ? 4U : 2U);
    const auto margin = [](const JointLimits& limits, double q) {
      return std::min(q - limits.lower, limits.upper - q);
    };
    for (int k = 0; k < 100; ++k) {
      const double room = 0.5 * EIGEN_PI - std::abs(now);
      const double first = joint.first.value + uniform(-EIGEN_PI, EIGEN_PI),
                   second = joint.second.value + uniform(-room, room);
      const double within = std::min(margin(joint.first.limits, first), margin(joint.second.limits, second));
      const double found = clearance(*cones, rod_at(joint, first, second));
      if (std::abs(found) < 1e-7 || std::abs(within) < 1e-7) continue;
      ASSERT_EQ(found > 0.0, within > 0.0) << "joint " << i << " at " << first << ' ' << second;
      (found > 0.0 ? inside : outside) += 1;
    }
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(outside, 100000);
}

TEST_F(UniversalJoint, IsNotReportedWhereADirectionHasTwoPostures) {
  Universal joint = random_joint(0.2);
  const auto told = [&joint] { return limited_directions(joint.first, joint.second, joint.rod).has_value(); };
  const double q = joint.second.value, p = joint.first.value;
  joint.first.limits = {p - 0.5, p + 0.5};
  EXPECT_FALSE(told());
  joint.second.limits = {q - 0.5, q + 0.5};
  EXPECT_TRUE(told());
  joint.second.limits = {q - 2.0, q + 2.0};
  EXPECT_FALSE(told());
  joint.second.limits = {q - 0.5, q + 0.5};
  joint.first.limits = {p - 1.6, p + 1.6};
  EXPECT_FALSE(told());
  joint.first.limits = {};
  EXPECT_TRUE(told());
  joint.rod += 0.01 * joint.rod.norm() * joint.second.axis;
  EXPECT_FALSE(told());
  joint.rod -= joint.rod.dot(joint.second.axis) * joint.second.axis;
  EXPECT_TRUE(told());
  joint.second.axis = (joint.second.axis + 0.01 * joint.first.axis).normalized();
  EXPECT_FALSE(told());
}

}  // namespace
}  // namespace parallel_aspects
