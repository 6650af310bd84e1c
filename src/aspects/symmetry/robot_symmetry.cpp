// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/robot_symmetry.h"

#include "aspects/symmetry/constraint_symmetry.h"

#include <Eigen/LU>

#include <algorithm>
#include <variant>

namespace parallel_aspects {
namespace {

/// Signs that B_jj may change by; none where a leg is not the image of another.
struct EntrySigns {
  bool same = false, opposite = false;

  bool any() const noexcept { return same || opposite; }
};

EntrySigns only(int sign) { return {sign > 0, sign < 0}; }

/// Compares legs with images of legs. Numbers have to be equal to the last digit: what follows is a theorem
/// about these numbers (docs/maps.md, Symmetries), and none about robots that are nearly symmetric.
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
    return symmetry_.base.topLeftCorner(degrees_of_freedom, degrees_of_freedom).determinant() < 0.0 ? -sign
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
