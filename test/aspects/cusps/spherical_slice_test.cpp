// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/spherical_held_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/slices.h"
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

using test::ActuationKind;
using Robot = std::shared_ptr<const Manipulator>;
using Point2 = std::array<double, 2>;

/// A robot of SO3 with the joint of its second leg held where a random pose has it, and that pose.
struct Held {
  Robot robot;
  HeldJoint joint;
  Pose pose;

  SphericalHeldSlice slice() const {
    const RoundingUpward rounding;
    return {*robot, joint};
  }
};

std::vector<Held> held_robots(test::RandomRobots& random, int of_each_kind) {
  std::vector<Robot> robots{test::spherical_three_rrr(), test::agile_eye()};
  for (int i = 0; i < of_each_kind; ++i)
    for (const ActuationKind kind : test::all_actuation_kinds)
      if (kind != ActuationKind::elbow) robots.push_back(random.robot(TaskSpace::SO3, kind));
  std::vector<Held> result;
  for (const Robot& robot : robots)
    for (int tries = 0; tries < 1000; ++tries) {
      const Pose pose = random.pose(TaskSpace::SO3);
      const InverseSolution found = inverse(*robot, pose, working_modes(*robot).front());
      if (!found) continue;
      result.push_back({robot, {1, found.q[1], robot->leg(1).actuated_by_angle()}, pose});
      break;
    }
  return result;
}

Point2 random_point(test::RandomRobots& random) {
  return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}

// About the held anchor, then about its proximal point.
TEST(SphericalHeldSlice, HasTheOrientationsThatKeepTheHeldRod) {
  test::RandomRobots random(1);
  for (const Held& held : held_robots(random, 5)) {
    const SphericalHeldSlice slice = held.slice();
    const Leg& leg = held.robot->leg(1);
    const Eigen::Vector3d c = leg.proximal_point(held.joint.value).normalized(), b = leg.anchor.normalized();
    const Eigen::Quaterniond start = slice.pose({0.0, 0.0}).orientation;
    for (int i = 0; i < 20; ++i) {
      const Point2 at = random_point(random);
      const Pose pose = slice.pose(at);
      const Eigen::Quaterniond expected =
          Eigen::AngleAxisd(test::pi * at[0], c) * start * Eigen::AngleAxisd(test::pi * at[1], b);
      EXPECT_LT(pose.orientation.angularDistance(expected), 1e-7) << held.robot->name();
      EXPECT_NEAR(leg.residual(pose, held.joint.value), 0.0, 1e-12) << held.robot->name();
    }
  }
}

/// The derivative of a function of two angles [rad] by differences of it.
double difference(const std::function<double(const Point2&)>& f, Point2 at, std::size_t i, std::size_t k) {
  if (i + k == 0) return f(at);
  constexpr double h = 0.01;
  const std::size_t axis = i > 0 ? 0 : 1;
  const auto lower_order = [&](double step) {
    Point2 moved = at;
    moved[axis] += step;
    return axis == 0 ? difference(f, moved, i - 1, k) : difference(f, moved, i, k - 1);
  };
  return (8.0 * (lower_order(h) - lower_order(-h)) - (lower_order(2.0 * h) - lower_order(-2.0 * h))) /
         (12.0 * h);
}

void expect_derivatives_of_residual(const Held& held, const SphericalHeldSlice& slice, std::size_t i,
                                    int sign, const Point2& at) {
  const RoundingUpward rounding;
  const SlicePlace place(at);
  const auto over = slice.leg_over(i, sign, place);
  if (!over || over->reaches != Verdict::holds) return;
  const Leg& leg = held.robot->leg(slice.leg(i));
  const double q = joint_value(leg, slice.pose(at).transform(leg.anchor), sign);
  const auto half_residual = [&](const Point2& x) {
    return 0.5 * leg.residual(slice.pose({x[0] / test::pi, x[1] / test::pi}), q);
  };
  const Jet<3> jet = over->equation.jet<3>(place.over());
  for (std::size_t n = 1; n <= 3; ++n)
    for (std::size_t k = 0; k <= n; ++k)
      EXPECT_NEAR(middle_of(jet.at(n - k, k)),
                  difference(half_residual, {test::pi * at[0], test::pi * at[1]}, n - k, k), 1e-5)
          << held.robot->name() << ", leg " << slice.leg(i) + 1 << ": " << at[0] << ", " << at[1];
}

TEST(SphericalHeldSlice, HasTheDerivativesOfTheResidualsOfLegs) {
  test::RandomRobots random(2);
  for (const Held& held : held_robots(random, 5)) {
    const SphericalHeldSlice slice = held.slice();
    for (int n = 0; n < 10; ++n) {
      const Point2 at = random_point(random);
      for (std::size_t i = 0; i < 2; ++i)
        for (const SlicePosture& posture : slice.postures())
          expect_derivatives_of_residual(held, slice, i, posture[i], at);
    }
  }
}

/// The enclosures at a point are some units in the last place wide.
bool meet(const Interval& outer, const Interval& inner) {
  return outer.lower() <= inner.upper() && inner.lower() <= outer.upper();
}

template <std::size_t Order>
bool meet(const Jet<Order>& outer, const Jet<Order>& inner) {
  for (std::size_t n = 0; n <= Order; ++n)
    for (std::size_t k = 0; k <= n; ++k)
      if (!meet(outer.at(n - k, k), inner.at(n - k, k))) return false;
  return true;
}

/// What holds over a box holds at a point of it.
void expect_enclosed(const SphericalHeldSlice& slice, std::size_t i, int sign, const Box& box,
                     const Point2& at, int& compared) {
  const RoundingUpward rounding;
  const SlicePlace of_box = slice.place(box), of_point(at);
  const auto over = slice.leg_over(i, sign, of_box), point = slice.leg_over(i, sign, of_point);
  if (!over || !point) return;
  if (over->reaches != Verdict::unknown) {
    EXPECT_EQ(over->reaches, point->reaches);
  }
  if (point->reaches != Verdict::holds || over->reaches == Verdict::fails) return;
  EXPECT_TRUE(meet(over->entry, point->entry));
  EXPECT_TRUE(meet(over->equation.jet<2>(of_box.over()), point->equation.jet<2>(of_point.over())));
  EXPECT_TRUE(meet(over->slope.jet<2>(of_box.over()), point->slope.jet<2>(of_point.over())));
  ++compared;
}

TEST(SphericalHeldSlice, EnclosesItsPoints) {
  test::RandomRobots random(3);
  int compared = 0;
  for (const Held& held : held_robots(random, 5)) {
    const SphericalHeldSlice slice = held.slice();
    for (int n = 0; n < 300; ++n) {
      const double half = std::exp2(random.uniform(-12.0, -2.0));
      Box box{2, {}, {}};
      Point2 at = random_point(random);
      for (std::size_t k = 0; k < 2; ++k) {
        box.lower[k] = at[k] - half;
        box.upper[k] = at[k] + half;
        at[k] = random.uniform(box.lower[k], box.upper[k]);
      }
      for (std::size_t i = 0; i < 2; ++i)
        for (const SlicePosture& posture : slice.postures())
          expect_enclosed(slice, i, posture[i], box, at, compared);
    }
  }
  EXPECT_GT(compared, 5000);
}

// Where the axis of the held anchor is in the plane of both other axes, the platform turns about it while all
// joints stand: along such a line everything vanishes that vanishes at a cusp.
TEST(SphericalHeldSlice, LeavesTheSelfMotionsOfTheAgileEye) {
  const Robot robot = test::agile_eye();
  const HeldJoint joint{0, 0.3, true};
  const CuspList found = find_cusps(*robot, joint);
  EXPECT_TRUE(found.cusps.empty());
  EXPECT_FALSE(found.complete);
  EXPECT_TRUE(found.leaves_curves);
}

TEST(SphericalHeldSlice, IsRefusedWithAReason) {
  const Robot robot = test::spherical_three_rrr();
  EXPECT_EQ(find_cusps_problem(*robot, {0, 0.3, true}), "");
  EXPECT_NE(find_cusps_problem(*robot, {3, 0.3, true}), "");
  EXPECT_NE(find_cusps_problem(*robot, {0, std::nan(""), true}), "");
  EXPECT_NE(find_cusps_problem(*test::bipod(), {0, 0.3, false}), "");
  EXPECT_NE(find_cusps_problem(*test::stewart(), {0, 0.3, false}), "");
  std::vector<Leg> legs = robot->legs();
  legs[0].anchor.setZero();
  EXPECT_NE(
      find_cusps_problem(*test::manipulator("anchor in the center", TaskSpace::SO3, legs), {0, 0.3, true}),
      "");
}

}  // namespace
}  // namespace parallel_aspects
