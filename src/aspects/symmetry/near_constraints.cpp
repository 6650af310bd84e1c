// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/near_constraints.h"

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
  ConstraintSymmetrizer(const Constraints& constraints, TaskSpace space, const SymmetricLegs& legs,
                        double size, double tolerance)
      : directions_(static_cast<Eigen::Index>(directions(space))),
        legs_(legs),
        length_(size * tolerance),
        angle_(tolerance),
        length_step_(step_of_lengths(size)),
        count_(static_cast<double>(legs.motions.size() + 1)) {
    result_.constraints = constraints;
  }

  SymmetricConstraints run() {
    Constraints& constraints = result_.constraints;
    if (constraints.workspace) average(*constraints.workspace);
    average(constraints.obstacles);
    average(constraints.passive_limits);
    return std::move(result_);
  }

 private:
  void average(WorkspaceBox& box) {
    WorkspaceBox sum = about_center(box);
    for (const SymmetricMotion& motion : legs_.motions) {
      const WorkspaceBox image = taken(motion.motion, about_center(box));
      if (!near(image.lower, about_center(box).lower) || !near(image.upper, about_center(box).upper)) return;
      sum.lower += image.lower;
      sum.upper += image.upper;
    }
    const WorkspaceBox old = box;
    box.lower = placed(sum.lower, old.lower);
    box.upper = placed(sum.upper, old.upper);
    tell(result_.length, "workspace", (box.lower - old.lower).cwiseAbs().maxCoeff());
    tell(result_.length, "workspace", (box.upper - old.upper).cwiseAbs().maxCoeff());
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
      result[k] = snapped(sum[k] / count_, length_step_) + legs_.center[k];
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
  void average(std::vector<Obstacle>& obstacles) {
    std::vector<Obstacle> result = obstacles;
    MovedNumber most = result_.length;
    for (Obstacle& obstacle : result) {
      Vector3d sum = inside(center_of(obstacle));
      for (const SymmetricMotion& motion : legs_.motions) {
        const auto image = std::find_if(obstacles.begin(), obstacles.end(), [&](Obstacle other) {
          return other.shape.index() == obstacle.shape.index() &&
                 near(motion.motion.base * inside(center_of(obstacle)), inside(center_of(other)));
        });
        if (image == obstacles.end()) return;
        sum += motion.motion.base.transpose() * inside(center_of(*image));
      }
      const Vector3d old = center_of(obstacle);
      center_of(obstacle) = placed(sum, old);
      tell(most, "obstacle " + obstacle.name, (center_of(obstacle) - old).norm());
    }
    obstacles = std::move(result);
    result_.length = most;
  }

  void average(std::vector<PassiveLimit>& limits) {
    std::vector<PassiveLimit> result = limits;
    MovedNumber most = result_.angle;
    for (std::size_t k = 0; k < limits.size(); ++k) {
      std::array<double, 3> sum = numbers(limits[k], 1, 1);
      for (const SymmetricMotion& motion : legs_.motions) {
        const auto image = image_of(limits[k], motion, limits);
        if (!image) return;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (*image)[i];
      }
      result[k].offset = mean(sum[0]);
      result[k].limits.lower = mean(sum[1]);
      result[k].limits.upper = mean(sum[2]);
      tell(most, "limit of " + limits[k].joint, std::abs(result[k].limits.lower - limits[k].limits.lower));
      tell(most, "limit of " + limits[k].joint, std::abs(result[k].limits.upper - limits[k].limits.upper));
      tell(most, "zero of " + limits[k].joint, std::abs(result[k].offset - limits[k].offset));
    }
    limits = std::move(result);
    result_.angle = most;
  }

  double mean(double sum) const { return std::isfinite(sum) ? snapped(sum / count_, step_of_angles) : sum; }

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
  const SymmetricLegs& legs_;
  double length_, angle_, length_step_, count_;
  SymmetricConstraints result_;
};

}  // namespace

SymmetricConstraints nearest_symmetric_constraints(const Constraints& constraints, TaskSpace space,
                                                   const SymmetricLegs& legs, double size, double tolerance) {
  return ConstraintSymmetrizer(constraints, space, legs, space == TaskSpace::SO3 ? 1.0 : size, tolerance)
      .run();
}

}  // namespace parallel_aspects
