// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/robot_symmetry.h"

#include "model/linear_algebra.h"

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

namespace {

/// Signs that B_jj may change by; none where a leg is not the image of another.
struct EntrySigns {
  bool same = false, opposite = false;

  bool any() const noexcept { return same || opposite; }
};

EntrySigns only(int sign) { return {sign > 0, sign < 0}; }

/// Compares legs with images of legs. Numbers have to be equal to the last digit: what follows is a theorem
/// about these numbers (docs/theory/maps.md, Symmetries), and none about robots that are nearly symmetric.
class LegImages {
 public:
  LegImages(const RigidSymmetry& symmetry, bool shows_cranks)
      : symmetry_(symmetry), shows_cranks_(shows_cranks) {}

  EntrySigns compare(const Leg& leg, const Leg& image) const {
    if (leg.actuation.index() != image.actuation.index()) return {};
    if (leg.tolerance != image.tolerance) return {};
    if (symmetry_.platform * leg.anchor != image.anchor) return {};
    return std::visit(
        [&](const auto& actuation) {
          return compare(actuation, std::get<std::decay_t<decltype(actuation)>>(image.actuation), leg, image);
        },
        leg.actuation);
  }

 private:
  static bool are_limited(const Leg& leg, const Leg& image) {
    return leg.limits.limited() || image.limits.limited();
  }

  // c = center + radius (cos q e1 + sin q axis x e1): where the axis goes to `along` times the axis of the
  // image, q changes by `along` times the handedness, and so do c' and B_jj.
  EntrySigns compare(const RevoluteActuation& actuation, const RevoluteActuation& other, const Leg& leg,
                     const Leg& image) const {
    const int along = takes_direction(symmetry_, actuation.axis, other.axis);
    const int sign = symmetry_.handedness() < 0.0 ? -along : along;
    if (along == 0 || actuation.radius != other.radius || leg.rod_length != image.rod_length) return {};
    if (!takes_point(symmetry_, actuation.center, other.center)) return {};
    const int zero = takes_direction(symmetry_, actuation.zero_direction, other.zero_direction);
    if (shows_cranks_ && zero == 0) return {};
    if (are_limited(leg, image) && (zero != 1 || !are_images(leg.limits, image.limits, sign))) return {};
    return only(sign);
  }

  EntrySigns compare(const PrismaticActuation& actuation, const PrismaticActuation& other, const Leg& leg,
                     const Leg& image) const {
    // c' is the direction, so that q and B_jj change with its sign.
    const int along = takes_direction(symmetry_, actuation.direction, other.direction);
    if (along == 0 || leg.rod_length != image.rod_length) return {};
    if (!takes_point(symmetry_, actuation.origin, other.origin)) return {};
    if (are_limited(leg, image) && !are_images(leg.limits, image.limits, along)) return {};
    return only(along);
  }

  EntrySigns compare(const StrutActuation& actuation, const StrutActuation& other, const Leg& leg,
                     const Leg& image) const {
    // B_jj is sense times length. Without limits it does not matter which joint value gives a length.
    if (!takes_point(symmetry_, actuation.base, other.base)) return {};
    if (are_limited(leg, image) &&
        (actuation.length_at_zero != other.length_at_zero || actuation.sense != other.sense ||
         !are_images(leg.limits, image.limits, 1)))
      return {};
    return only(actuation.sense == other.sense ? 1 : -1);
  }

  // The distance is the same for an angle and its opposite, so both postures can be the image.
  EntrySigns compare(const ElbowActuation& actuation, const ElbowActuation& other, const Leg& leg,
                     const Leg& image) const {
    if (!takes_point(symmetry_, actuation.base, other.base)) return {};
    if (actuation.inner_length != other.inner_length || actuation.outer_length != other.outer_length)
      return {};
    if (!are_limited(leg, image)) return {true, true};
    if (actuation.sense != other.sense) return {};
    return {actuation.angle_at_zero == other.angle_at_zero && are_images(leg.limits, image.limits, 1),
            actuation.angle_at_zero == -other.angle_at_zero && actuation.angle_at_zero == 0.0 &&
                are_images(leg.limits, image.limits, -1)};
  }

  const RigidSymmetry& symmetry_;
  bool shows_cranks_;
};

/// Finds the legs that legs go to.
class LegMatching {
 public:
  LegMatching(const Manipulator& manipulator, const RigidSymmetry& symmetry)
      : manipulator_(manipulator),
        symmetry_(symmetry),
        count_(manipulator.leg_count()),
        leg_image_(count_),
        signs_(count_),
        taken_(count_, false) {
    const Constraints& constraints = manipulator.constraints();
    shows_cranks_ = !is_planar(manipulator.task_space()) &&
                    (constraints.self_collision || !constraints.obstacles.empty() ||
                     !constraints.cones.empty() || !constraints.passive_cones.empty());
  }

  void find(std::vector<RobotSymmetry>& found) {
    if (match_from(0)) add_all_signs(found);
  }

 private:
  bool match_from(std::size_t leg) {
    if (leg == count_) return takes_constraints(symmetry_, leg_image_, manipulator_);
    const LegImages images(symmetry_, shows_cranks_);
    for (std::size_t other = 0; other < count_; ++other) {
      if (taken_[other]) continue;
      signs_[leg] = images.compare(manipulator_.leg(leg), manipulator_.leg(other));
      if (!signs_[leg].any()) continue;
      leg_image_[leg] = other;
      taken_[other] = true;
      if (match_from(leg + 1)) return true;
      taken_[other] = false;
    }
    return false;
  }

  /// Every choice, where legs leave one.
  void add_all_signs(std::vector<RobotSymmetry>& found) const {
    for (std::size_t opposite = 0; opposite < std::size_t{1} << count_; ++opposite) {
      RobotSymmetry symmetry{symmetry_, leg_image_, {}, determinant_sign()};
      for (std::size_t j = 0; j < count_; ++j) {
        const bool is_opposite = (opposite >> j & 1U) != 0;
        if (is_opposite ? signs_[j].opposite : signs_[j].same)
          symmetry.entry_sign.push_back(is_opposite ? -1 : 1);
      }
      if (symmetry.entry_sign.size() == count_) found.push_back(symmetry);
    }
  }

  /// The rows of A are permuted like the legs. Where the platform turns, its columns change by a matrix of
  /// determinant 1, else by that of the motion.
  int determinant_sign() const {
    int sign = 1;
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j)
        if (leg_image_[i] > leg_image_[j]) sign = -sign;
    if (has_rotation(manipulator_.task_space())) return sign;
    const auto degrees_of_freedom = static_cast<Eigen::Index>(count_);
    return determinant(symmetry_.base.topLeftCorner(degrees_of_freedom, degrees_of_freedom)) < 0.0 ? -sign
                                                                                                   : sign;
  }

  const Manipulator& manipulator_;
  const RigidSymmetry& symmetry_;
  std::size_t count_;
  std::vector<std::size_t> leg_image_;
  std::vector<EntrySigns> signs_;
  std::vector<bool> taken_;
  bool shows_cranks_ = false;
};

bool is_trivial(const RobotSymmetry& symmetry) {
  return symmetry.motion.base.isIdentity(0.0) && symmetry.motion.platform.isIdentity(0.0) &&
         std::all_of(symmetry.entry_sign.begin(), symmetry.entry_sign.end(),
                     [](int sign) { return sign > 0; });
}

}  // namespace

WorkingMode RobotSymmetry::image(const WorkingMode& mode) const {
  WorkingMode result(mode.leg_count());
  for (std::size_t j = 0; j < leg_image.size(); ++j)
    result.set_sign(leg_image[j], entry_sign[j] * mode.sign(j));
  return result;
}

std::vector<RobotSymmetry> find_robot_symmetries(const Manipulator& manipulator, const Box& region) {
  std::vector<RobotSymmetry> found;
  for (const RigidSymmetry& symmetry : find_rigid_symmetries(manipulator.task_space(), region))
    LegMatching(manipulator, symmetry).find(found);
  found.erase(std::remove_if(found.begin(), found.end(), is_trivial), found.end());
  return found;
}

}  // namespace parallel_aspects
