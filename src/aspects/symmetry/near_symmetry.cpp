// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/near_symmetry.h"

#include "model/overloaded.h"
#include "parallel_aspects/model/manipulator.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// As far below the size of the robot as sums of all images allow.
constexpr int bits_of_lengths = 42;

// Of groups about another point than the origin, which have few motions. Regions of maps about it need no
// more bits, `exact_region`, up to some sizes of the robot.
constexpr int bits_of_decimals = 47;

// What becomes of one leg: signs by which the directions of its image differ.
struct LegMatch {
  int along = 1;  // of axis or direction
  int zero = 1;   // of the zero direction; 0 where that of the image is another
};

// A motion and where it takes the legs.
struct NearSymmetry {
  RigidSymmetry motion;
  std::vector<std::size_t> leg_image;
  std::vector<LegMatch> matches;
};

// Numbers of a leg that a motion takes to others, or leaves as they are. Null where its kind has none.
struct LegNumbers {
  Vector3d* base_point;
  Vector3d* direction;           // of axis or rail
  Vector3d* zero;                // direction of the zero of an angle
  std::vector<double*> lengths;  // that a motion does not change
  double* angle;
  double sense;
};

LegNumbers numbers_of(Leg& leg) {
  return std::visit(
      Overloaded{
          [&leg](RevoluteActuation& d) -> LegNumbers {
            return {&d.center, &d.axis, &d.zero_direction, {&d.radius, &leg.rod_length}, nullptr, 1.0};
          },
          [&leg](PrismaticActuation& d) -> LegNumbers {
            return {&d.origin, &d.direction, nullptr, {&leg.rod_length}, nullptr, 1.0};
          },
          [](StrutActuation& d) -> LegNumbers {
            return {&d.base, nullptr, nullptr, {&d.length_at_zero}, nullptr, d.sense};
          },
          [](ElbowActuation& d) -> LegNumbers {
            return {&d.base, nullptr, nullptr, {&d.inner_length, &d.outer_length}, &d.angle_at_zero, d.sense};
          }},
      leg.actuation);
}

Vector3d& base_point(Leg& leg) { return *numbers_of(leg).base_point; }
Vector3d* direction_of(Leg& leg) { return numbers_of(leg).direction; }
Vector3d* zero_of(Leg& leg) { return numbers_of(leg).zero; }
std::vector<double*> lengths_of(Leg& leg) { return numbers_of(leg).lengths; }
double* angle_of(Leg& leg) { return numbers_of(leg).angle; }
int sense_of(Leg& leg) { return numbers_of(leg).sense > 0.0 ? 1 : -1; }

// By which joint values differ.
int sign_of_values(const Leg& leg, const RigidSymmetry& motion, const LegMatch& match) {
  const bool mirrored = leg.crank() != nullptr && motion.handedness() < 0.0;
  return mirrored ? -match.along : match.along;
}

JointLimits with_sign(JointLimits limits, int sign) {
  if (sign < 0) {
    std::swap(limits.lower, limits.upper);
    limits.lower = -limits.lower;
    limits.upper = -limits.upper;
  }
  return limits;
}

class Comparison {
 public:
  Comparison(double size, double tolerance) : length_(size * tolerance), angle_(tolerance) {}

  double length() const { return length_; }

  // `motion` has its shift.
  std::optional<LegMatch> compare(Leg leg, Leg image, const RigidSymmetry& motion) const {
    if (leg.actuation.index() != image.actuation.index() || sense_of(leg) != sense_of(image))
      return std::nullopt;
    if (!near(motion.platform * leg.anchor, image.anchor, length_) ||
        !near(motion.base * base_point(leg) + motion.shift, base_point(image), length_))
      return std::nullopt;
    const auto lengths = lengths_of(leg), others = lengths_of(image);
    for (std::size_t k = 0; k < lengths.size(); ++k)
      if (!(std::abs(*lengths[k] - *others[k]) <= length_)) return std::nullopt;
    if (angle_of(leg) != nullptr && !(std::abs(*angle_of(leg) - *angle_of(image)) <= angle_))
      return std::nullopt;
    LegMatch match;
    if (direction_of(leg) != nullptr)
      match.along = sign(motion.base * *direction_of(leg), *direction_of(image));
    if (zero_of(leg) != nullptr) match.zero = sign(motion.base * *zero_of(leg), *zero_of(image));
    if (match.along == 0 || !limits_match(leg, image, motion, match)) return std::nullopt;
    return match;
  }

 private:
  static bool near(const Vector3d& one, const Vector3d& other, double distance) {
    return (one - other).norm() <= distance;
  }

  int sign(const Vector3d& one, const Vector3d& other) const {
    if (near(one, other, angle_)) return 1;
    return near(-one, other, angle_) ? -1 : 0;
  }

  bool limits_match(const Leg& leg, const Leg& image, const RigidSymmetry& motion,
                    const LegMatch& match) const {
    const JointLimits wanted = with_sign(leg.limits, sign_of_values(leg, motion, match));
    const JointLimits found = image.limits;
    if (!wanted.limited() && !found.limited()) return true;
    return match.zero == 1 && near_end(wanted.lower, found.lower, leg) &&
           near_end(wanted.upper, found.upper, leg);
  }

  bool near_end(double one, double other, const Leg& leg) const {
    return one == other || std::abs(one - other) <= (leg.actuated_by_angle() ? angle_ : length_);
  }

  double length_, angle_;
};

class Symmetrizer {
 public:
  Symmetrizer(TaskSpace space, const std::vector<Leg>& legs, double size, double tolerance, double step)
      : space_(space), legs_(legs), comparison_(size, tolerance), length_step_(step) {}

  SymmetricLegs run() {
    SymmetricLegs result;
    result.legs = legs_;
    for (const RigidSymmetry& motion : rigid_symmetries_without_shift(space_)) add(motion);
    if (group_.size() < 2 || !is_group()) return result;
    result.center = center_ = common_center();
    for (std::size_t leg = 0; leg < legs_.size(); ++leg)
      if (first_of_orbit(leg) == leg) set_orbit(leg, result.legs);
    for (NearSymmetry& symmetry : group_) {
      symmetry.motion.shift = center_ - symmetry.motion.base * center_;
      if (!is_identity(symmetry.motion)) result.motions.push_back({symmetry.motion, symmetry.leg_image});
    }
    for (std::size_t leg = 0; leg < legs_.size(); ++leg) measure(legs_[leg], result.legs[leg], result);
    return result;
  }

 private:
  static bool is_identity(const RigidSymmetry& motion) {
    return motion.base.isIdentity(0.0) && motion.platform.isIdentity(0.0);
  }

  // With the first permutation of legs that fits.
  void add(const RigidSymmetry& motion) {
    std::vector<std::size_t> image(legs_.size());
    std::iota(image.begin(), image.end(), std::size_t{0});
    do {
      NearSymmetry symmetry{motion, image, {}};
      symmetry.motion.shift = mean_shift(motion, image);
      for (std::size_t leg = 0; leg < legs_.size(); ++leg)
        if (const auto match = comparison_.compare(legs_[leg], legs_[image[leg]], symmetry.motion))
          symmetry.matches.push_back(*match);
      if (symmetry.matches.size() < legs_.size()) continue;
      group_.push_back(symmetry);
      return;
    } while (std::next_permutation(image.begin(), image.end()));
  }

  // In the directions that the platform can move in.
  Vector3d mean_shift(const RigidSymmetry& motion, const std::vector<std::size_t>& image) const {
    Vector3d shift = Vector3d::Zero();
    for (std::size_t leg = 0; leg < legs_.size(); ++leg)
      shift += legs_[image[leg]].base_point() - motion.base * legs_[leg].base_point();
    return movable(shift / static_cast<double>(legs_.size()));
  }

  Vector3d movable(Vector3d vector) const {
    const auto count = space_ == TaskSpace::SO3 ? 0 : static_cast<Eigen::Index>(directions(space_));
    vector.tail(3 - count).setZero();
    return vector;
  }

  bool is_group() const {
    return std::all_of(group_.begin(), group_.end(), [this](const NearSymmetry& one) {
      return std::all_of(group_.begin(), group_.end(),
                         [&](const NearSymmetry& other) { return has_product(one, other); });
    });
  }

  // First `one`, then `other`.
  bool has_product(const NearSymmetry& one, const NearSymmetry& other) const {
    return std::any_of(group_.begin(), group_.end(), [&](const NearSymmetry& product) {
      if (product.motion.base != other.motion.base * one.motion.base ||
          product.motion.platform != other.motion.platform * one.motion.platform)
        return false;
      for (std::size_t leg = 0; leg < legs_.size(); ++leg)
        if (product.leg_image[leg] != other.leg_image[one.leg_image[leg]]) return false;
      return true;
    });
  }

  // A finite group of motions leaves the middle of the images of any point where it is.
  Vector3d common_center() const {
    Vector3d sum = Vector3d::Zero();
    for (const NearSymmetry& symmetry : group_) sum += symmetry.motion.shift;
    const Vector3d center = sum / static_cast<double>(group_.size());
    // At the origin where it is as near as that, so that the region of a map is symmetric, too.
    const double zero = comparison_.length();
    return movable(
        snapped(center.unaryExpr([zero](double entry) { return std::abs(entry) <= zero ? 0.0 : entry; }),
                length_step_));
  }

  std::size_t first_of_orbit(std::size_t leg) const {
    std::size_t first = leg;
    for (const NearSymmetry& symmetry : group_) first = std::min(first, symmetry.leg_image[leg]);
    return first;
  }

  void set_orbit(std::size_t first, std::vector<Leg>& legs) const {
    const Leg mean = mean_leg(first);
    for (std::size_t leg = 0; leg < legs.size(); ++leg)
      for (const NearSymmetry& symmetry : group_)
        if (symmetry.leg_image[first] == leg) {
          legs[leg] = image(mean, symmetry, first, legs[leg]);
          break;
        }
  }

  // Of all images, brought back to `first`. Sums are exact, so that the order of the images does not matter,
  // and what is the same of all of them stays the same.
  Leg mean_leg(std::size_t first) const {
    Leg mean = legs_[first];
    const bool keeps_zero = zeros_match(first);
    set_zero(mean, keeps_zero);
    for (const NearSymmetry& symmetry : group_)
      add(symmetry, first, legs_[symmetry.leg_image[first]], keeps_zero, mean);
    const double count = static_cast<double>(group_.size());
    base_point(mean) = snapped(base_point(mean) / count, length_step_) + center_;
    mean.anchor = snapped(mean.anchor / count, length_step_);
    for (double* length : lengths_of(mean)) *length = snapped(*length / count, length_step_);
    if (double* angle = angle_of(mean)) *angle = snapped(*angle / count, step_of_angles);
    if (Vector3d* direction = direction_of(mean)) direction->normalize();
    if (Vector3d* zero = zero_of(mean)) *zero = across(*zero, *direction_of(mean));
    const double step = mean.actuated_by_angle() ? step_of_angles : length_step_;
    for (double* end : {&mean.limits.lower, &mean.limits.upper})
      if (std::isfinite(*end)) *end = snapped(*end / count, step);
    return mean;
  }

  bool zeros_match(std::size_t first) const {
    return std::all_of(group_.begin(), group_.end(),
                       [first](const NearSymmetry& symmetry) { return symmetry.matches[first].zero != 0; });
  }

  static bool limits_move(const Leg& leg) { return leg.limits.limited(); }

  static void set_zero(Leg& leg, bool keeps_zero) {
    base_point(leg).setZero();
    leg.anchor.setZero();
    for (double* length : lengths_of(leg)) *length = 0.0;
    if (double* angle = angle_of(leg)) *angle = 0.0;
    if (Vector3d* direction = direction_of(leg)) direction->setZero();
    if (zero_of(leg) != nullptr && keeps_zero) zero_of(leg)->setZero();
    if (limits_move(leg))
      for (double* end : {&leg.limits.lower, &leg.limits.upper})
        if (std::isfinite(*end)) *end = 0.0;
  }

  void add(const NearSymmetry& symmetry, std::size_t first, Leg leg, bool keeps_zero, Leg& sum) const {
    const Matrix3d back = symmetry.motion.base.transpose();
    const LegMatch& match = symmetry.matches[first];
    base_point(sum) += back * snapped(base_point(leg) - center_, length_step_);
    sum.anchor += symmetry.motion.platform.transpose() * snapped(leg.anchor, length_step_);
    const auto lengths = lengths_of(leg), sums = lengths_of(sum);
    for (std::size_t k = 0; k < lengths.size(); ++k) *sums[k] += snapped(*lengths[k], length_step_);
    if (angle_of(leg) != nullptr) *angle_of(sum) += snapped(*angle_of(leg), step_of_angles);
    if (direction_of(leg) != nullptr)
      *direction_of(sum) += match.along * (back * snapped(*direction_of(leg), step_of_angles));
    if (zero_of(leg) != nullptr && keeps_zero)
      *zero_of(sum) += match.zero * (back * snapped(*zero_of(leg), step_of_angles));
    if (limits_move(leg)) add_limits(leg, sign_of_values(leg, symmetry.motion, match), sum);
  }

  void add_limits(const Leg& leg, int sign, Leg& sum) const {
    const JointLimits limits = with_sign(leg.limits, sign);
    const double step = leg.actuated_by_angle() ? step_of_angles : length_step_;
    if (std::isfinite(limits.lower)) sum.limits.lower += snapped(limits.lower, step);
    if (std::isfinite(limits.upper)) sum.limits.upper += snapped(limits.upper, step);
  }

  static Vector3d across(const Vector3d& vector, const Vector3d& axis) {
    return (vector - axis * axis.dot(vector)).normalized();
  }

  // What is no number of the kinematics stays with `own`.
  Leg image(const Leg& mean, const NearSymmetry& symmetry, std::size_t first, const Leg& own) const {
    Leg result = mean;
    const LegMatch& match = symmetry.matches[first];
    const Matrix3d& base = symmetry.motion.base;
    result.name = own.name;
    result.actuated_joint = own.actuated_joint;
    result.limits = own.limits;
    if (limits_move(mean)) {
      const JointLimits limits = with_sign(mean.limits, sign_of_values(mean, symmetry.motion, match));
      result.limits.lower = limits.lower;
      result.limits.upper = limits.upper;
    }
    base_point(result) = base * (mean.base_point() - center_) + center_;
    result.anchor = symmetry.motion.platform * mean.anchor;
    if (Vector3d* direction = direction_of(result)) *direction = match.along * (base * *direction);
    if (zero_of(result) == nullptr) return result;
    Leg old = own;
    *zero_of(result) = zeros_match(first) ? Vector3d(match.zero * (base * *zero_of(result)))
                                          : across(*zero_of(old), *direction_of(result));
    return result;
  }

  static void measure(Leg before, Leg after, SymmetricLegs& result) {
    const auto tell = [&before](MovedNumber& most, const char* what, double amount) {
      if (amount > most.amount) most = {what + std::string(" of ") + before.name, amount};
    };
    tell(result.length, "base point", (base_point(before) - base_point(after)).norm());
    tell(result.length, "anchor", (before.anchor - after.anchor).norm());
    const auto lengths = lengths_of(before), others = lengths_of(after);
    for (std::size_t k = 0; k < lengths.size(); ++k)
      tell(result.length, "length", std::abs(*lengths[k] - *others[k]));
    if (direction_of(before) != nullptr)
      tell(result.angle, "direction", (*direction_of(before) - *direction_of(after)).norm());
    if (zero_of(before) != nullptr)
      tell(result.angle, "zero direction", (*zero_of(before) - *zero_of(after)).norm());
    if (angle_of(before) != nullptr)
      tell(result.angle, "angle", std::abs(*angle_of(before) - *angle_of(after)));
    MovedNumber& limit = before.actuated_by_angle() ? result.angle : result.length;
    for (const auto& [end, other] : {std::make_pair(before.limits.lower, after.limits.lower),
                                     std::make_pair(before.limits.upper, after.limits.upper)})
      if (end != other) tell(limit, "limit", std::abs(end - other));
  }

  TaskSpace space_;
  const std::vector<Leg>& legs_;
  Comparison comparison_;
  double length_step_;
  std::vector<NearSymmetry> group_;
  Vector3d center_ = Vector3d::Zero();
};

}  // namespace

SymmetricLegs symmetric_in_decimals(TaskSpace space, const std::vector<Leg>& legs, double size) {
  SymmetricLegs result;
  result.legs = legs;
  if (space == TaskSpace::SO3 || space == TaskSpace::SE3 || has_hinges(space)) return result;
  const double step = std::ldexp(1.0, std::ilogb(size) - bits_of_decimals);
  SymmetricLegs found = Symmetrizer(space, legs, size, rounding_of_decimals, step).run();
  if (found.motions.empty() || found.center.isZero(0.0)) return result;
  for (std::size_t leg = 0; leg < legs.size(); ++leg)
    base_point(result.legs[leg]) = base_point(found.legs[leg]);
  found.legs = std::move(result.legs);
  return found;
}

double step_of_lengths(double size) { return std::ldexp(1.0, std::ilogb(size) - bits_of_lengths); }

double snapped(double value, double step) { return std::round(value / step) * step; }

Vector3d snapped(const Vector3d& vector, double step) {
  return vector.unaryExpr([step](double entry) { return snapped(entry, step); });
}

SymmetricLegs nearest_symmetric_legs(TaskSpace space, const std::vector<Leg>& legs, double size,
                                     double tolerance) {
  const double length = space == TaskSpace::SO3 ? 1.0 : size;
  return Symmetrizer(space, legs, length, tolerance, step_of_lengths(length)).run();
}

}  // namespace parallel_aspects
