// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_search.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using test::ActuationKind;
using test::Robot;
using test::uniform;

// The lengths of struts 2 and 3 at the cusps, found by Newton's method in double precision.
TEST(Cusps, AreTheSixOfTheThreeRpr) {
  const auto found = test::uniqueness_of_slice(test::three_rpr()->with_constraints({}), 0, 14.98);
  const std::vector<std::array<double, 2>> expected{{0.84528, 3.77792},   {13.85146, 6.26010},
                                                    {16.02767, 29.56671}, {17.98855, 26.44618},
                                                    {30.44913, 26.61916}, {31.27613, 16.17845}};
  EXPECT_TRUE(found->cusps_complete);
  ASSERT_EQ(found->cusps.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(found->cusps[i].actuated[0], 14.98);
    EXPECT_NEAR(found->cusps[i].actuated[1], expected[i][0], 1e-5);
    EXPECT_NEAR(found->cusps[i].actuated[2], expected[i][1], 1e-5);
    EXPECT_LT(found->cusps[i].accuracy, 1e-9);
  }
  EXPECT_EQ(found->map->aspects().size(), 2U);
}

// With struts from 10 to 32 two of them are out of reach.
TEST(Cusps, AreListedWithinLimits) {
  const auto found = test::uniqueness_of_slice(test::three_rpr(), 0, 14.98);
  EXPECT_TRUE(found->cusps_complete);
  EXPECT_EQ(found->cusps.size(), 4U);
}

/// A robot with one joint held where a random pose has it.
struct HeldCase {
  Robot robot;
  HeldJoint joint;

  std::string text() const {
    return robot->name() + ", " + std::to_string(joint.leg + 1) + " at " + std::to_string(joint.value);
  }
};

std::unique_ptr<const HeldSlice> slice_of(const HeldCase& held) {
  const RoundingUpward rounding;
  return make_held_slice(*held.robot, held.joint);
}

HeldCase held_at_value(const Robot& robot, std::size_t leg, double value) {
  return {robot, {leg, value, robot->leg(leg).actuated_by_angle()}};
}

std::optional<HeldCase> held_at(const Robot& robot, std::size_t leg, std::mt19937_64& random) {
  test::RandomRobots poses(static_cast<unsigned>(random()));
  for (int tries = 0; tries < 1000; ++tries) {
    const Pose pose = poses.pose(robot->task_space());
    const auto modes = working_modes(*robot);
    const InverseSolution found = inverse(*robot, pose, modes[random() % modes.size()]);
    if (!found) continue;
    const HeldCase held = held_at_value(robot, leg, found.q[static_cast<Eigen::Index>(leg)]);
    EXPECT_EQ(find_cusps_problem(*robot, held.joint), "");
    return held;
  }
  return std::nullopt;
}

/// Robots of every kind of leg, and one with three kinds.
std::vector<HeldCase> random_robots(TaskSpace space, std::mt19937_64& random, int of_each_kind) {
  test::RandomRobots robots(static_cast<unsigned>(random()));
  std::vector<HeldCase> result;
  for (int i = 0; i < of_each_kind; ++i) {
    std::vector<Robot> next;
    for (const ActuationKind kind : {ActuationKind::strut, ActuationKind::revolute, ActuationKind::prismatic})
      next.push_back(robots.robot(space, kind));
    std::vector<Leg> legs{next[1]->leg(0), next[2]->leg(1),
                          robots.robot(space, ActuationKind::elbow)->leg(2)};
    next.push_back(test::manipulator("mixed", space, std::move(legs)));
    for (const Robot& robot : next)
      if (const auto held = held_at(robot, random() % 2, random)) result.push_back(*held);
  }
  return result;
}

/// Both free joint values over the slice in one posture, by the inverse problem.
class SliceByInverse {
 public:
  SliceByInverse(const HeldCase& held, const HeldSlice& slice, const SlicePosture& posture)
      : slice_(slice), posture_(posture) {
    for (std::size_t i = 0; i < 2; ++i) legs_[i] = &held.robot->leg(slice.leg(i));
  }

  /// Not a number where a leg does not reach.
  Vector2d values(const Vector2d& x) const {
    const Pose pose = slice_.pose({x[0] / test::pi, x[1] / test::pi});
    Vector2d q;
    for (std::size_t i = 0; i < 2; ++i) {
      const Eigen::Vector3d anchor = pose.transform(legs_[i]->anchor);
      q[static_cast<Eigen::Index>(i)] = squared_inverse_entry(*legs_[i], anchor) > 1e-8
                                            ? joint_value(*legs_[i], anchor, posture_[i])
                                            : std::nan("");
    }
    return q;
  }

  /// By differences of fourth order.
  Matrix2d jacobian(const Vector2d& x) const {
    constexpr double h = 1e-4;
    Matrix2d result;
    for (int k = 0; k < 2; ++k) {
      const Vector2d step = h * Vector2d::Unit(k);
      result.col(k) =
          (8.0 * difference(x + step, x - step) - difference(x + 2.0 * step, x - 2.0 * step)) / (12.0 * h);
    }
    return result;
  }

 private:
  Vector2d difference(const Vector2d& to, const Vector2d& from) const {
    Vector2d result = values(to) - values(from);
    for (std::size_t i = 0; i < 2; ++i)
      if (legs_[i]->actuated_by_angle()) {
        double& each = result[static_cast<Eigen::Index>(i)];
        each = std::remainder(each, 2.0 * test::pi);
      }
    return result;
  }

  const HeldSlice& slice_;
  SlicePosture posture_;
  std::array<const Leg*, 2> legs_{};
};

double distance(const Vector2d& a, const Vector2d& b) {
  return std::hypot(std::remainder(a[0] - b[0], 2.0 * test::pi), std::remainder(a[1] - b[1], 2.0 * test::pi));
}

/// Cusps by Newton's method with differences in double precision, from many poses.
class CuspsByNewton {
 public:
  explicit CuspsByNewton(const SliceByInverse& slice) : slice_(slice) {}

  std::vector<Vector2d> find(std::mt19937_64& random, int starts) const {
    std::vector<Vector2d> found;
    for (int i = 0; i < starts; ++i) {
      Vector2d x(uniform(random, -test::pi, test::pi), uniform(random, -test::pi, test::pi));
      if (!converges(x)) continue;
      const auto same = [&](const Vector2d& y) { return distance(x, y) < 1e-4; };
      if (std::none_of(found.begin(), found.end(), same)) found.push_back(x);
    }
    return found;
  }

 private:
  double determinant(const Vector2d& x) const { return slice_.jacobian(x).determinant(); }

  /// det J and its slope along the kernel.
  Vector2d functions(const Vector2d& x) const {
    constexpr double h = 1e-3;
    const Matrix2d jacobian = slice_.jacobian(x);
    if (!jacobian.allFinite()) return Vector2d::Constant(std::nan(""));
    const Eigen::JacobiSVD<Matrix2d> svd(jacobian, Eigen::ComputeFullV);
    Vector2d k = svd.matrixV().col(1);
    if (k[std::abs(k[0]) > std::abs(k[1]) ? 0 : 1] < 0.0) k = -k;
    return {determinant(x), (determinant(x + h * k) - determinant(x - h * k)) / (2.0 * h)};
  }

  bool converges(Vector2d& x) const {
    constexpr double h = 1e-4;
    for (int step = 0; step < 40; ++step) {
      const Vector2d f = functions(x);
      Matrix2d slope;
      for (int k = 0; k < 2; ++k) {
        const Vector2d to = h * Vector2d::Unit(k);
        slope.col(k) = (functions(x + to) - functions(x - to)) / (2.0 * h);
      }
      if (!slope.allFinite() || !f.allFinite()) return false;
      const Vector2d move = slope.fullPivLu().solve(f);
      if (!move.allFinite() || move.norm() > 1e3) return false;
      x -= move.norm() > 0.2 ? Vector2d(0.2 * move.normalized()) : move;
      if (move.norm() < 1e-7)
        return slice_.jacobian(x).norm() > 1e-3 && slice_.values(x).cwiseAbs().minCoeff() > 1e-3;
    }
    return false;
  }

  const SliceByInverse& slice_;
};

CuspBoxes cusp_boxes(const HeldSlice& slice) {
  const RoundingUpward rounding;
  return find_cusp_boxes(slice, {});
}

Vector2d middle_of(const CuspBox& cusp) {
  return test::pi * Vector2d(cusp.box.center(0), cusp.box.center(1));
}

/// Of what Newton's method finds in all postures, with `starts` each: how many of them are among the cusps
/// that are proved. Where these are complete, all must be.
std::size_t count_listed(const HeldCase& held, const HeldSlice& slice, const CuspBoxes& boxes, int starts,
                         std::mt19937_64& random) {
  std::size_t matched = 0;
  for (const SlicePosture& posture : slice.postures()) {
    const SliceByInverse by_inverse(held, slice, posture);
    for (const Vector2d& x : CuspsByNewton(by_inverse).find(random, starts)) {
      const bool is_listed = std::any_of(boxes.cusps.begin(), boxes.cusps.end(), [&](const CuspBox& cusp) {
        return cusp.posture == posture && distance(middle_of(cusp), x) < 1e-4;
      });
      EXPECT_TRUE(is_listed || !boxes.undecided.empty()) << held.text() << ": " << x.transpose();
      if (is_listed) ++matched;
    }
  }
  return matched;
}

class CuspsOfSlices : public testing::TestWithParam<TaskSpace> {};

INSTANTIATE_TEST_SUITE_P(TaskSpaces, CuspsOfSlices, testing::Values(TaskSpace::SE2, TaskSpace::SO3));

// Of random robots with legs of every kind, each cusp that Newton's method finds is one of those that are
// proved.
TEST_P(CuspsOfSlices, AreAllThatNewtonsMethodFinds) {
  std::mt19937_64 random(3);
  std::size_t complete = 0, matched = 0, listed = 0;
  const std::vector<HeldCase> all = random_robots(GetParam(), random, 4);
  for (const HeldCase& held : all) {
    const auto slice = slice_of(held);
    const CuspBoxes boxes = cusp_boxes(*slice);
    complete += boxes.undecided.empty() ? 1 : 0;
    listed += boxes.cusps.size();
    matched += count_listed(held, *slice, boxes, 60, random);
  }
  EXPECT_EQ(complete, all.size());
  EXPECT_GT(2 * matched, listed);
}

// The joint values move over the slice by g_x / B_jj.
TEST_P(CuspsOfSlices, HaveTheJointValuesOfTheInverseProblem) {
  std::mt19937_64 random(5);
  int compared = 0;
  for (const HeldCase& held : random_robots(GetParam(), random, 10)) {
    const auto slice = slice_of(held);
    for (const SlicePosture& posture : slice->postures()) {
      const SliceByInverse by_inverse(held, *slice, posture);
      const Vector2d x(uniform(random, -test::pi, test::pi), uniform(random, -test::pi, test::pi));
      const Matrix2d expected = by_inverse.jacobian(x);
      if (!expected.allFinite()) continue;
      const RoundingUpward rounding;
      const SlicePlace at(std::array<double, 2>{x[0] / test::pi, x[1] / test::pi});
      for (std::size_t i = 0; i < 2; ++i) {
        if (!held.robot->leg(slice->leg(i)).kind().moves_proximal_point) continue;
        const auto leg = slice->leg_over(i, posture[i], at);
        ASSERT_TRUE(leg);
        const Jet<1> g = leg->equation.jet<1>(at.over());
        const auto row = static_cast<Eigen::Index>(i);
        EXPECT_NEAR(leg->slope.jet<0>(at.over()).value().lower(), -leg->entry.lower(), 1e-9);
        EXPECT_NEAR(g.at(1, 0).lower() / leg->entry.lower(), expected(row, 0), 1e-5 * expected.norm());
        EXPECT_NEAR(g.at(0, 1).lower() / leg->entry.lower(), expected(row, 1), 1e-5 * expected.norm());
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 30);
}

/// How far a platform is turned and moved from one pose to another [rad + m].
double distance_between(const Pose& a, const Pose& b) {
  return a.orientation.angularDistance(b.orientation) + (a.position - b.position).norm();
}

/// How many direct solutions there are near the pose of a cusp, at least and at most, for actuated values on
/// a circle about its own.
std::array<std::size_t, 2> solutions_beside(const HeldCase& held, const Cusp& cusp, double radius) {
  const std::size_t leg = held.joint.leg;
  const auto first = static_cast<Eigen::Index>(leg == 0 ? 1 : 0),
             second = static_cast<Eigen::Index>(leg == 2 ? 1 : 2);
  std::array<std::size_t, 2> range{1000, 0};
  for (int i = 0; i < 1800 && !(range[0] <= 1 && range[1] >= 3); ++i) {
    const double angle = 2.0 * test::pi * (i * 1117 % 1800) / 1800.0;  // all of them, not in turn
    JointVector q = cusp.actuated;
    q[first] += radius * std::cos(angle);
    q[second] += radius * std::sin(angle);
    std::size_t near = 0;
    for (const AssemblyMode& mode : direct(*held.robot, q).solutions)
      if (distance_between(mode.pose, cusp.pose) < 0.4) ++near;
    range = {std::min(range[0], near), std::max(range[1], near)};
  }
  return range;
}

void expect_three_solutions_beside(const HeldCase& held, const Cusp& cusp) {
  const auto near = solutions_beside(held, cusp, 1e-3), far = solutions_beside(held, cusp, 1e-2);
  EXPECT_GE(std::max(near[1], far[1]), 3U) << held.text() << ": " << cusp.actuated.transpose();
  EXPECT_LE(std::min(near[0], far[0]) + 2, std::max(near[1], far[1])) << held.text();
}

// By the direct solver; another solution may be near by.
TEST_P(CuspsOfSlices, HaveThreeSolutionsBesideThem) {
  std::mt19937_64 random(6);
  std::vector<HeldCase> all = random_robots(GetParam(), random, 1);
  if (GetParam() == TaskSpace::SE2)
    all.push_back(held_at_value(test::three_rpr()->with_constraints({}), 0, 14.98));
  std::size_t looked_at = 0;
  for (const HeldCase& held : all) {
    const CuspList found = find_cusps(*held.robot, held.joint);
    EXPECT_TRUE(found.complete);
    for (std::size_t i = 0; i < found.cusps.size(); i += 1 + found.cusps.size() / 3, ++looked_at)
      expect_three_solutions_beside(held, found.cusps[i]);
  }
  EXPECT_GT(looked_at, 5U);
}

// Proved to be all, singular by det A, and with one or three solutions beside each.
TEST(Cusps, OfTheSpherical3Rrr) {
  std::mt19937_64 random(7);
  const Robot robot = test::shipped("spherical_3rrr")->mapped_manipulator();
  std::size_t matched = 0, listed = 0;
  for (const auto& [leg, value] : {std::pair<std::size_t, double>{0, 0.3}, {1, 1.0}, {2, -2.0}}) {
    const HeldCase held = held_at_value(robot, leg, value);
    const auto slice = slice_of(held);
    const CuspBoxes boxes = cusp_boxes(*slice);
    matched += count_listed(held, *slice, boxes, 100, random);
    const CuspList found = find_cusps(*robot, held.joint);
    EXPECT_TRUE(found.complete) << held.text();
    EXPECT_EQ(found.cusps.size(), boxes.cusps.size());
    listed += found.cusps.size();
    for (const Cusp& cusp : found.cusps) {
      EXPECT_LT(std::abs(parallel_index(*robot, cusp.pose, cusp.actuated)), 1e-8);
      expect_three_solutions_beside(held, cusp);
    }
  }
  EXPECT_GT(listed, 20U);
  EXPECT_GT(2 * matched, listed);
}

}  // namespace
}  // namespace parallel_aspects
