// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/star_sets/folded_leg.h"
#include "interval/interval.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/slices.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>

namespace parallel_aspects {
namespace {

using about_fold::AboutFold;
using about_fold::Cylinder;
using test::Robot;
using test::uniform;

constexpr double step = 1e-5;  // of finite differences [rad]

/// Whose legs have cranks and rods of one length each.
Robot random_folding(std::mt19937_64& random) {
  ManipulatorDescription description = test::three_rrr()->description();
  for (Leg& leg : description.legs) {
    auto& crank = std::get<RevoluteActuation>(leg.actuation);
    crank.center += Eigen::Vector3d(uniform(random, -4.0, 4.0), uniform(random, -4.0, 4.0), 0.0);
    leg.anchor += Eigen::Vector3d(uniform(random, -4.0, 4.0), uniform(random, -4.0, 4.0), 0.0);
  }
  return std::make_shared<const Manipulator>(description);
}

/// Poses by the vector d from base point to anchor of leg 0, and phi.
class FoldPoses {
 public:
  explicit FoldPoses(const Manipulator& robot) : robot_(robot) {}

  Pose pose(double length, double direction, double phi) const {
    const Leg& leg = robot_.leg(0);
    const Eigen::Vector2d d(length * std::cos(direction), length * std::sin(direction));
    const Eigen::Vector2d anchor = Eigen::Rotation2Dd(phi) * leg.anchor.head<2>();
    const Eigen::Vector2d at = d + std::get<RevoluteActuation>(leg.actuation).center.head<2>() - anchor;
    return Pose::planar(at.x(), at.y(), phi);
  }

  double square(std::size_t k, const Pose& at) const {
    return squared_inverse_entry(robot_.leg(k), at.transform(robot_.leg(k).anchor));
  }

  /// The angle near `phi` at which B_kk^2 is so large; none where there is none.
  std::optional<double> angle_with(std::size_t k, double wanted, double length, double direction,
                                   double phi) const {
    const auto missing = [&](double t) { return square(k, pose(length, direction, t)) - wanted; };
    for (int i = 0; i < 30; ++i)
      phi -= missing(phi) / ((missing(phi + step) - missing(phi - step)) / (2.0 * step));
    return std::isfinite(phi) && std::abs(missing(phi)) < 1e-8 ? std::make_optional(phi) : std::nullopt;
  }

  /// The direction of G, det A = G . u_0.
  double beta(const WorkingMode& mode, const Pose& at) const {
    const TaskMatrix a = direct_matrix(robot_, at, inverse(robot_, at, mode).q);
    const Eigen::Vector3d first = a.row(1).transpose(), second = a.row(2).transpose(),
                          minors = first.cross(second);
    const Eigen::Vector3d arm = at.orientation * robot_.leg(0).anchor;
    return std::atan2(minors[2] + arm.x() * minors[0], minors[1] - arm.y() * minors[0]);
  }

 private:
  const Manipulator& robot_;
};

/// What leg 0 may fold beside: a leg k whose B_kk vanishes at this angle.
struct Place {
  std::size_t leg;
  double phi;
};

std::optional<Place> place_of(const FoldPoses& poses, std::mt19937_64& random) {
  const std::size_t k = 1 + random() % 2;
  const auto phi = poses.angle_with(k, 0.0, 0.0, 0.0, uniform(random, -3.0, 3.0));
  if (!phi || std::abs(*phi) > 3.0 || !(poses.square(3 - k, poses.pose(0.0, 0.0, *phi)) > 1.0))
    return std::nullopt;
  return Place{k, *phi};
}

/// A bound of how far G turns per radian of the rod about a fold at this angle; none where nothing is
/// claimed, or where no height is held.
std::optional<double> bound_of(const Manipulator& robot, const WorkingMode& mode, double phi, double radius,
                               double reach) {
  const RoundingUpward rounding;
  const SE2Chart chart(robot);
  const ConstraintTests<SE2Chart::point_dimension> tests(robot);
  const Box box{3, {}, {}};
  const AboutFold here({chart, tests, 0, box}, {mode.sign(0), mode.sign(1), mode.sign(2)},
                       Cylinder{0, radius, {(phi - reach) / M_PI, (phi + reach) / M_PI}});
  const auto turning = here.turning();
  if (!here.is_simple() || !turning || *turning == 0.0 || !(here.least_length() > 0.0)) return std::nullopt;
  return here.change(*turning) / here.least_length();
}

/// How far G turns per radian of the rod, at constant |d| and |B_kk|; none where that is too small.
std::optional<double> turn_of(const FoldPoses& poses, std::size_t k, const WorkingMode& mode, double length,
                              double direction, double phi) {
  const double square = poses.square(k, poses.pose(length, direction, phi));
  if (!(square > 0.1)) return std::nullopt;
  const auto before = poses.angle_with(k, square, length, direction - step, phi),
             after = poses.angle_with(k, square, length, direction + step, phi);
  if (!before || !after) return std::nullopt;
  return std::remainder(poses.beta(mode, poses.pose(length, direction + step, *after)) -
                            poses.beta(mode, poses.pose(length, direction - step, *before)),
                        2.0 * M_PI) /
         (2.0 * step);
}

// Against differences over poses that keep |d| and |B_kk|, for which the platform has to turn.
TEST(AboutFold, BoundsHowGTurnsWithTheRod) {
  std::mt19937_64 random(20261129);
  int compared = 0;
  double closest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const Robot robot = random_folding(random);
    const FoldPoses poses(*robot);
    const auto place = place_of(poses, random);
    if (!place) continue;
    const double radius = std::pow(10.0, uniform(random, -2.0, -0.3)), reach = 0.05 * radius;
    const auto modes = working_modes(*robot);
    const WorkingMode& mode = modes[random() % modes.size()];
    const auto bound = bound_of(*robot, mode, place->phi, radius, reach);
    if (!bound) continue;
    const double length = uniform(random, 0.5, 1.0) * radius, direction = uniform(random, -M_PI, M_PI);
    const auto turn = turn_of(poses, place->leg, mode, length, direction,
                              place->phi + 0.9 * uniform(random, -reach, reach));
    if (!turn) continue;
    EXPECT_LE(std::abs(*turn), *bound * (1.0 + 1e-4)) << "robot " << i << ", radius " << radius;
    closest = std::max(closest, std::abs(*turn) / *bound);
    ++compared;
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(closest, 0.4);
}

}  // namespace
}  // namespace parallel_aspects
