// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/near_constraints.h"

#include "aspects/symmetry/robot_symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

Vector3d& center_of(Obstacle& obstacle) {
  return std::visit([](auto& shape) -> Vector3d& { return shape.center; }, obstacle.shape);
}

class ConstraintSymmetrizer {
 public:
  ConstraintSymmetrizer(const ManipulatorDescription& robot, const SymmetricLegs& legs, double size,
                        double tolerance)
      : directions_(static_cast<Eigen::Index>(directions(robot.task_space))),
        robot_legs_(robot.legs),
        legs_(legs),
        length_(size * tolerance),
        angle_(tolerance),
        length_step_(step_of_lengths(size)) {
    result_.constraints = robot.constraints;
  }

  SymmetricConstraints run() {
    Constraints& constraints = result_.constraints;
    if (constraints.workspace) settle(*constraints.workspace);
    settle(constraints.obstacles);
    settle(constraints.passive_limits);
    settle(constraints.passive_cones);
    settle(constraints.cones);
    return std::move(result_);
  }

 private:
  // What is averaged and what that moved.
  template <class Kind>
  struct Mean {
    Kind kind;
    MovedNumber length, angle;
  };

  // Over those motions that take it onto itself.
  template <class Kind>
  void settle(Kind& kind) {
    std::vector<SymmetricMotion> near;
    for (const SymmetricMotion& motion : legs_.motions) {
      motions_ = {motion};
      if (mean_of(kind)) near.push_back(motion);
    }
    motions_ = near;
    const auto mean = near.empty() || !is_group() ? std::nullopt : mean_of(kind);
    if (!mean) return;
    kind = mean->kind;
    tell(result_.length, mean->length.what, mean->length.amount);
    tell(result_.angle, mean->angle.what, mean->angle.amount);
  }

  bool is_group() const {
    return std::all_of(motions_.begin(), motions_.end(), [this](const SymmetricMotion& one) {
      return std::all_of(motions_.begin(), motions_.end(),
                         [&](const SymmetricMotion& other) { return has_product(one, other); });
    });
  }

  // First `one`, then `other`.
  bool has_product(const SymmetricMotion& one, const SymmetricMotion& other) const {
    const Eigen::Matrix3d base = other.motion.base * one.motion.base,
                          platform = other.motion.platform * one.motion.platform;
    return (base.isIdentity(0.0) && platform.isIdentity(0.0)) ||
           std::any_of(motions_.begin(), motions_.end(), [&](const SymmetricMotion& product) {
             return product.motion.base == base && product.motion.platform == platform;
           });
  }

  std::optional<Mean<WorkspaceBox>> mean_of(const WorkspaceBox& box) const {
    WorkspaceBox sum = about_center(box);
    for (const SymmetricMotion& motion : motions_) {
      const WorkspaceBox image = taken(motion.motion, about_center(box));
      if (!near(image.lower, about_center(box).lower) || !near(image.upper, about_center(box).upper))
        return std::nullopt;
      sum.lower += image.lower;
      sum.upper += image.upper;
    }
    Mean<WorkspaceBox> mean{box, {}, {}};
    mean.kind.lower = placed(sum.lower, box.lower);
    mean.kind.upper = placed(sum.upper, box.upper);
    tell(mean.length, "workspace", (mean.kind.lower - box.lower).cwiseAbs().maxCoeff());
    tell(mean.length, "workspace", (mean.kind.upper - box.upper).cwiseAbs().maxCoeff());
    return mean;
  }

  // Relative to where all motions turn, in whole steps, so that sums are exact.
  WorkspaceBox about_center(const WorkspaceBox& box) const { return {inside(box.lower), inside(box.upper)}; }

  Vector3d inside(const Vector3d& point) const {
    return snapped(Vector3d(point - legs_.center), length_step_);
  }

  // The mean, in the directions that the platform moves in.
  Vector3d placed(const Vector3d& sum, const Vector3d& old) const {
    Vector3d result = old;
    for (Eigen::Index k = 0; k < directions_; ++k)
      result[k] = snapped(sum[k] / count(), length_step_) + legs_.center[k];
    return result;
  }

  static WorkspaceBox taken(const RigidSymmetry& motion, const WorkspaceBox& box) {
    const Vector3d one = motion.base * box.lower, other = motion.base * box.upper;
    return {one.cwiseMin(other), one.cwiseMax(other)};
  }

  bool near(const Vector3d& one, const Vector3d& other) const {
    for (Eigen::Index k = 0; k < directions_; ++k)
      if (!(std::abs(one[k] - other[k]) <= length_)) return false;
    return true;
  }

  static void tell(MovedNumber& most, const std::string& what, double amount) {
    if (amount > most.amount) most = {what, amount};
  }

  // What each is the mean of: what the motions take onto it, brought back.
  std::optional<Mean<std::vector<Obstacle>>> mean_of(std::vector<Obstacle> obstacles) const {
    Mean<std::vector<Obstacle>> mean{obstacles, {}, {}};
    for (Obstacle& obstacle : mean.kind) {
      Vector3d sum = inside(center_of(obstacle));
      for (const SymmetricMotion& motion : motions_) {
        const auto image = std::find_if(obstacles.begin(), obstacles.end(), [&](Obstacle other) {
          return other.shape.index() == obstacle.shape.index() &&
                 near(motion.motion.base * inside(center_of(obstacle)), inside(center_of(other)));
        });
        if (image == obstacles.end()) return std::nullopt;
        sum += motion.motion.base.transpose() * inside(center_of(*image));
      }
      const Vector3d old = center_of(obstacle);
      center_of(obstacle) = placed(sum, old);
      tell(mean.length, "obstacle " + obstacle.name, (center_of(obstacle) - old).norm());
    }
    return mean;
  }

  std::optional<Mean<std::vector<PassiveLimit>>> mean_of(const std::vector<PassiveLimit>& limits) const {
    Mean<std::vector<PassiveLimit>> result{limits, {}, {}};
    for (std::size_t k = 0; k < limits.size(); ++k) {
      std::array<double, 3> sum = numbers(limits[k], 1, 1);
      for (const SymmetricMotion& motion : motions_) {
        const auto image = image_of(limits[k], motion, limits);
        if (!image) return std::nullopt;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (*image)[i];
      }
      PassiveLimit& limit = result.kind[k];
      limit.offset = mean(sum[0]);
      limit.limits.lower = mean(sum[1]);
      limit.limits.upper = mean(sum[2]);
      tell(result.angle, "limit of " + limit.joint, std::abs(limit.limits.lower - limits[k].limits.lower));
      tell(result.angle, "limit of " + limit.joint, std::abs(limit.limits.upper - limits[k].limits.upper));
      tell(result.angle, "zero of " + limit.joint, std::abs(limit.offset - limits[k].offset));
    }
    return result;
  }

  static BallJointCone& cone_of(BallJointCone& cone) { return cone; }
  static BallJointCone& cone_of(PassiveCone& limit) { return limit.cone; }
  static const BallJointCone& cone_of(const BallJointCone& cone) { return cone; }
  static const BallJointCone& cone_of(const PassiveCone& limit) { return limit.cone; }
  static std::string name_of(const BallJointCone& cone) {
    return "cone of leg " + std::to_string(cone.leg + 1);
  }
  static std::string name_of(const PassiveCone& limit) { return "limit of " + limit.joint; }

  // Of what the motions take onto each.
  template <class Cone>
  std::optional<Mean<std::vector<Cone>>> mean_of(const std::vector<Cone>& cones) const {
    Mean<std::vector<Cone>> result{cones, {}, {}};
    for (Cone& each : result.kind) {
      BallJointCone& cone = cone_of(each);
      const BallJointCone old = cone;
      Vector3d axis = snapped(old.axis, step_of_angles);
      double angle = snapped(old.angle, step_of_angles);
      for (const SymmetricMotion& motion : motions_) {
        const auto other = std::find_if(cones.begin(), cones.end(), [&](const Cone& one) {
          return motion.leg_image[cone_of(one).leg] == old.leg && is_near(taken(motion, cone_of(one)), old);
        });
        if (other == cones.end()) return std::nullopt;
        axis += snapped(taken(motion, cone_of(*other)).axis, step_of_angles);
        angle += snapped(cone_of(*other).angle, step_of_angles);
      }
      cone.axis = axis / norm(axis);
      cone.angle = mean(angle);
      tell(result.angle, name_of(each),
           std::max((cone.axis - old.axis).norm(), std::abs(cone.angle - old.angle)));
    }
    return result;
  }

  BallJointCone taken(const SymmetricMotion& motion, BallJointCone cone) const {
    const std::size_t image = motion.leg_image[cone.leg];
    cone.axis = image_of_axis(motion.motion, cone, robot_legs_[cone.leg], robot_legs_[image]);
    cone.leg = image;
    return cone;
  }

  bool is_near(const BallJointCone& one, const BallJointCone& other) const {
    return one.end == other.end && std::abs(one.angle - other.angle) <= angle_ &&
           (one.axis - other.axis).norm() <= angle_;
  }

  // The same to the last digit of all images, whose entries are in another order.
  static double norm(const Vector3d& vector) {
    std::array<double, 3> entries{std::abs(vector.x()), std::abs(vector.y()), std::abs(vector.z())};
    std::sort(entries.begin(), entries.end());
    return std::hypot(entries[0], entries[1], entries[2]);
  }

  double count() const { return static_cast<double>(motions_.size() + 1); }

  double mean(double sum) const { return std::isfinite(sum) ? snapped(sum / count(), step_of_angles) : sum; }

  // Offset and limits, brought back by the signs that a motion changes them with.
  static std::array<double, 3> numbers(const PassiveLimit& limit, int turned, int sign) {
    const auto whole = [](double value) {
      return std::isfinite(value) ? snapped(value, step_of_angles) : value;
    };
    const double lower = whole(limit.limits.lower), upper = whole(limit.limits.upper);
    return {turned * whole(limit.offset), sign > 0 ? lower : -upper, sign > 0 ? upper : -lower};
  }

  std::optional<std::array<double, 3>> image_of(const PassiveLimit& limit, const SymmetricMotion& motion,
                                                const std::vector<PassiveLimit>& limits) const {
    const int turned = motion.motion.handedness() < 0.0 ? -1 : 1;
    const std::array<double, 3> own = numbers(limit, 1, 1);
    for (const PassiveLimit& other : limits) {
      if (other.leg != motion.leg_image[limit.leg] || other.angle != limit.angle) continue;
      const auto back = numbers(other, turned, limit.sense == other.sense ? turned : -turned);
      const auto is_near = [this](double one, double two) {
        return one == two || std::abs(one - two) <= angle_;
      };
      if (std::equal(own.begin(), own.end(), back.begin(), is_near)) return back;
    }
    return std::nullopt;
  }

  Eigen::Index directions_;
  const std::vector<Leg>& robot_legs_;
  const SymmetricLegs& legs_;
  double length_, angle_, length_step_;
  std::vector<SymmetricMotion> motions_;  // that means are taken over, without the identity
  SymmetricConstraints result_;
};

}  // namespace

SymmetricConstraints nearest_symmetric_constraints(const ManipulatorDescription& robot,
                                                   const SymmetricLegs& legs, double size, double tolerance) {
  return ConstraintSymmetrizer(robot, legs, robot.task_space == TaskSpace::SO3 ? 1.0 : size, tolerance).run();
}

}  // namespace parallel_aspects
