// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/constraint_symmetry.h"

#include <algorithm>
#include <variant>

namespace parallel_aspects {
namespace {

template <class Items, class Matches>
bool each_has_image(const Items& items, const Matches& matches) {
  return std::all_of(items.begin(), items.end(), [&](const auto& item) {
    return std::any_of(items.begin(), items.end(), [&](const auto& image) { return matches(item, image); });
  });
}

/// What the constraints become.
class ConstraintImages {
 public:
  ConstraintImages(const RigidSymmetry& symmetry, const std::vector<std::size_t>& leg_image,
                   const Manipulator& manipulator)
      : symmetry_(symmetry), leg_image_(leg_image), manipulator_(manipulator) {}

  bool operator()(const PassiveLimit& limit, const PassiveLimit& image) const {
    if (leg_image_[limit.leg] != image.leg || limit.angle != image.angle) return false;
    if (limit.angle != PassiveAngle::crank_to_rod && !keeps_x_axis()) return false;
    const int turned = symmetry_.handedness() < 0.0 ? -1 : 1;
    const int sense = limit.sense == image.sense ? 1 : -1;
    return image.offset == turned * limit.offset && are_images(limit.limits, image.limits, turned * sense);
  }

  bool operator()(const BallJointCone& cone, const BallJointCone& image) const {
    return leg_image_[cone.leg] == image.leg && cone.end == image.end && cone.angle == image.angle &&
           image_of_axis(symmetry_, cone, manipulator_.leg(cone.leg), manipulator_.leg(image.leg)) ==
               image.axis;
  }

  bool operator()(const PassiveCone& limit, const PassiveCone& image) const {
    return (*this)(limit.cone, image.cone);
  }

  bool operator()(const Obstacle& obstacle, const Obstacle& image) const {
    if (const auto* ball = std::get_if<BallObstacle>(&obstacle.shape)) {
      const auto* other = std::get_if<BallObstacle>(&image.shape);
      return other != nullptr && ball->radius == other->radius &&
             takes_point(symmetry_, ball->center, other->center);
    }
    const auto* other = std::get_if<BoxObstacle>(&image.shape);
    return other != nullptr && takes_box(std::get<BoxObstacle>(obstacle.shape), *other);
  }

  bool operator()(const std::array<LinkName, 2>& pair, const std::array<LinkName, 2>& image) const {
    const LinkName first = taken(pair[0]), second = taken(pair[1]);
    return (first == image[0] && second == image[1]) || (first == image[1] && second == image[0]);
  }

  bool takes_workspace(const WorkspaceBox& box, std::size_t directions) const {
    for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(directions); ++i) {
      Eigen::Index from = 0;
      symmetry_.base.row(i).cwiseAbs().maxCoeff(&from);
      const bool reversed = symmetry_.base(i, from) < 0.0;
      const double lower = reversed ? -box.upper[from] : box.lower[from];
      const double upper = reversed ? -box.lower[from] : box.upper[from];
      if (!is_exact_sum(lower, symmetry_.shift[i], box.lower[i])) return false;
      if (!is_exact_sum(upper, symmetry_.shift[i], box.upper[i])) return false;
    }
    return true;
  }

  // Points of one joint are distinguished from others by distances, which must not be rounded differently.
  bool keeps_distances() const { return symmetry_.base.diagonal().all() && symmetry_.shift.isZero(0.0); }

 private:
  /// Angles in the plane are counted from there.
  bool keeps_x_axis() const { return symmetry_.base(0, 0) > 0.0 && symmetry_.platform(0, 0) > 0.0; }

  LinkName taken(const LinkName& link) const { return {link.kind, leg_image_[link.leg]}; }

  // In axes that are images of each other, the vector of a rotation changes like one, but for reflections.
  bool takes_box(const BoxObstacle& box, const BoxObstacle& image) const {
    const Eigen::Vector3d vector = symmetry_.handedness() * (symmetry_.base * box.orientation.vec());
    const bool same = box.orientation.w() == image.orientation.w() && vector == image.orientation.vec();
    const bool negative = box.orientation.w() == -image.orientation.w() && vector == -image.orientation.vec();
    return (same || negative) && takes_point(symmetry_, box.center, image.center) &&
           symmetry_.base.cwiseAbs() * box.half_size == image.half_size;
  }

  const RigidSymmetry& symmetry_;
  const std::vector<std::size_t>& leg_image_;
  const Manipulator& manipulator_;
};

}  // namespace

bool takes_point(const RigidSymmetry& symmetry, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& image) noexcept {
  const Eigen::Vector3d turned = symmetry.base * point;
  for (Eigen::Index i = 0; i < turned.size(); ++i)
    if (!is_exact_sum(turned[i], symmetry.shift[i], image[i])) return false;
  return true;
}

int takes_direction(const RigidSymmetry& symmetry, const Eigen::Vector3d& direction,
                    const Eigen::Vector3d& image) noexcept {
  const Eigen::Vector3d turned = symmetry.base * direction;
  if (turned == image) return 1;
  return turned == -image ? -1 : 0;
}

// In a crank x goes to x, z to z or -z, and y = z cross x changes like z, but for reflections.
Eigen::Vector3d image_of_axis(const RigidSymmetry& symmetry, const BallJointCone& cone, const Leg& leg,
                              const Leg& image) {
  if (cone.end == LegEnd::platform) return symmetry.platform * cone.axis;
  if (leg.crank() == nullptr) return symmetry.base * cone.axis;
  const double along = takes_direction(symmetry, leg.crank()->axis, image.crank()->axis);
  return cone.axis.cwiseProduct(Eigen::Vector3d(1.0, symmetry.handedness() * along, along));
}

bool are_images(const JointLimits& limits, const JointLimits& image, int sign) noexcept {
  if (sign > 0) return limits.lower == image.lower && limits.upper == image.upper;
  return limits.lower == -image.upper && limits.upper == -image.lower;
}

bool takes_constraints(const RigidSymmetry& symmetry, const std::vector<std::size_t>& leg_image,
                       const Manipulator& manipulator) {
  const Constraints& constraints = manipulator.constraints();
  const ConstraintImages images(symmetry, leg_image, manipulator);
  if (constraints.workspace &&
      !images.takes_workspace(*constraints.workspace, directions(manipulator.task_space())))
    return false;
  if ((constraints.self_collision || constraints.thickness.platform) && !images.keeps_distances())
    return false;
  if (constraints.self_collision && !each_has_image(constraints.self_collision->ignored, images))
    return false;
  return each_has_image(constraints.passive_limits, images) &&
         each_has_image(constraints.passive_cones, images) && each_has_image(constraints.cones, images) &&
         each_has_image(constraints.obstacles, images);
}

}  // namespace parallel_aspects
