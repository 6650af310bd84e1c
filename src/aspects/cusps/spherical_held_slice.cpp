// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/spherical_held_slice.h"

#include "interval/scalar_range.h"
#include "legs/determinant.h"
#include "legs/held_leg.h"
#include "model/angles.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <variant>

namespace parallel_aspects {
namespace {

Spatial<Interval> unit(const Spatial<Interval>& v) {
  return scaled(reciprocal(square_root(squared_norm(v))), v);
}

/// A right-handed orthonormal frame whose third axis has this direction.
RotationRows<Interval> frame_along(const Spatial<Interval>& direction) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(middle_of(direction[i])) < std::abs(middle_of(direction[least]))) least = i;
  Spatial<Interval> other{0.0, 0.0, 0.0};
  other[least] = 1.0;
  const Spatial<Interval> third = unit(direction), first = unit(cross(other, direction));
  return {first, cross(third, first), third};
}

}  // namespace

HeldOrientations::HeldOrientations(const Leg& leg, double q) {
  const HeldPoint held(leg, q);
  const Spatial<Interval> anchor = enclosed(leg.anchor);
  base_ = frame_along(held.c);
  platform_ = frame_along(anchor);
  const Interval squares = squared_norm(held.c) + squared_norm(anchor) - held.squared_rod;
  cosine_ = Interval(0.5) * squares * reciprocal(square_root(squared_norm(held.c) * squared_norm(anchor)));
  sine_ = square_root(not_negative_part(Interval(1.0) - square(cosine_)));
  slope_ = held.slope;
  along_slope_ = dot(held.c, held.slope);
  anchor_ = anchor;
}

// With E^T m = (m1, m2, m3) and F^T b = (b1, b2, b3), and U and V the first two coordinates of Rz(-a) E^T m,
// X and Y those of Rz(phi) F^T b, it is  cos U X + V Y + sin (b3 U - m3 X) + cos m3 b3;  U X + V Y is a
// cosine of a + phi, U X - V Y one of phi - a.
CosineSum HeldOrientations::along(const Spatial<Interval>& m, const Spatial<Interval>& b) const noexcept {
  const Interval m1 = dot(base_[0], m), m2 = dot(base_[1], m), m3 = dot(base_[2], m);
  const Interval b1 = dot(platform_[0], b), b2 = dot(platform_[1], b), b3 = dot(platform_[2], b);
  const Interval half(0.5), plus = half * (Interval(1.0) + cosine_), minus = half * (cosine_ - Interval(1.0));
  CosineSum sum;
  sum.constant = cosine_ * m3 * b3;
  sum.of_sum = {plus * (m1 * b1 + m2 * b2), plus * (m2 * b1 - m1 * b2)};
  sum.of_difference = {minus * (m1 * b1 - m2 * b2), -(minus * (m1 * b2 + m2 * b1))};
  sum.of_direction = {sine_ * b3 * m1, sine_ * b3 * m2};
  sum.of_phi = {-(sine_ * m3 * b1), sine_ * m3 * b2};
  return sum;
}

CosineSum HeldOrientations::held_entry() const noexcept {
  CosineSum entry = along(slope_, anchor_);
  entry.constant = entry.constant - along_slope_;
  return entry;
}

Pose HeldOrientations::pose(const std::array<double, 2>& at) const {
  const auto columns = [](const RotationRows<Interval>& axes) {
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        matrix(k, i) = middle_of(axes[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
    return matrix;
  };
  const auto turn = [](double angle, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  };
  const double gamma = std::atan2(middle_of(sine_), middle_of(cosine_));
  const Eigen::Matrix3d rotation =
      columns(base_) * turn(pi * at[0], Eigen::Vector3d::UnitZ()) * turn(gamma, Eigen::Vector3d::UnitY()) *
      turn(pi * at[1], Eigen::Vector3d::UnitZ()) * columns(platform_).transpose();
  Pose pose;
  pose.orientation = Eigen::Quaterniond(rotation).normalized();
  return pose;
}

namespace {

using Number = Dual<2, Interval>;

Spatial<Interval> difference(const Spatial<Interval>& a, const Spatial<Interval>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// What the value in the middle and the slopes over the box leave of it.
Interval narrowed(const Number& over, const Interval& center, const SliceCenter& middle) noexcept {
  return intersection(over.value,
                      center + over.gradient[0] * middle.offset(0) + over.gradient[1] * middle.offset(1));
}

Spatial<Interval> opposite(const Spatial<Interval>& v) { return {-v[0], -v[1], -v[2]}; }

}  // namespace

SphericalHeldSlice::SphericalHeldSlice(const Manipulator& manipulator, const HeldJoint& joint)
    : HeldSlice(manipulator, joint.leg, SliceSums::yes),
      orientations_(manipulator.leg(joint.leg), joint.value),
      held_entry_(orientations_.held_entry()),
      legs_{MovingLeg(manipulator.leg(leg(0)), orientations_),
            MovingLeg(manipulator.leg(leg(1)), orientations_)} {}

SphericalHeldSlice::MovingLeg::MovingLeg(const Leg& moving, const HeldOrientations& orientations)
    : leg(moving), anchor(enclosed(moving.anchor)) {
  std::visit([this](const auto& actuation) { set(actuation); }, moving.actuation);
  for (std::size_t k = 0; k < 3; ++k) {
    Spatial<Interval> axis{0.0, 0.0, 0.0};
    axis[k] = 1.0;
    displacement[k] = orientations.along(axis, anchor);
    displacement[k].constant = displacement[k].constant - leg.base()[k];
  }
}

void SphericalHeldSlice::MovingLeg::set(const RevoluteActuation& crank) {
  crank_axis = enclosed(crank.axis);
  moves = true;
}

void SphericalHeldSlice::MovingLeg::set(const PrismaticActuation& slide) {
  rail = enclosed(slide.direction);
  moves = true;
}

void SphericalHeldSlice::MovingLeg::set(const StrutActuation&) {}

void SphericalHeldSlice::MovingLeg::set(const ElbowActuation&) {}

SphericalHeldSlice::Reach SphericalHeldSlice::MovingLeg::reach(const SlicePlace& at) const noexcept {
  Reach result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Jet<1> jet = displacement[k].jet<1>(at.over());
    Number& over = result.displacement[k];
    over = jet.value();
    over.gradient = {jet.at(1, 0), jet.at(0, 1)};
    result.center[k] = displacement[k].jet<0>(at.center()).value();
    over.value = result.range[k] = narrowed(over, result.center[k], at.middle());
  }
  result.squared_center = leg.form(result.center).squared_b_entry;
  result.squared_b_entry =
      narrowed(leg.form(result.displacement).squared_b_entry, result.squared_center, at.middle());
  return result;
}

std::optional<Spatial<Interval>> SphericalHeldSlice::MovingLeg::proximal_point(
    const Reach& reach, int sign, const SliceCenter& middle) const noexcept {
  const Interval root = root_of(reach.squared_b_entry);
  const auto points = leg.link_points(reach.range, root, sign);
  if (!points) return std::nullopt;
  Spatial<Interval> c = points->joint;
  if (!moves || !reach.squared_b_entry.positive()) return c;
  const auto center = leg.link_points(reach.center, root_of(reach.squared_center), sign);
  if (!center) return c;
  const Spatial<Interval> slope = joint_slope(c);
  const Number along = dot(c, reach.displacement);  // -g but for a constant
  const Interval inverse = reciprocal(sign > 0 ? -root : root);
  for (std::size_t k = 0; k < 3; ++k) {
    Number component(c[k]);
    for (std::size_t n = 0; n < 2; ++n) component.gradient[n] = slope[k] * (inverse * along.gradient[n]);
    c[k] = narrowed(component, center->joint[k], middle);
  }
  return c;
}

Spatial<Interval> SphericalHeldSlice::MovingLeg::joint_slope(const Spatial<Interval>& c) const noexcept {
  const Spatial<Interval> turning = cross(crank_axis, difference(c, leg.base()));
  return {turning[0] + rail[0], turning[1] + rail[1], turning[2] + rail[2]};
}

std::optional<HeldSlice::LegOver> SphericalHeldSlice::leg_over(std::size_t i, int sign,
                                                               const SlicePlace& at) const noexcept {
  const MovingLeg& moving = legs_[i];
  const Reach reach = moving.reach(at);
  LegOver result;
  result.reaches = is_positive(reach.squared_b_entry);
  if (reach.squared_b_entry.upper() < 0.0) return result;
  const auto c = moving.proximal_point(reach, sign, at.middle());
  if (!c) return std::nullopt;
  result.equation = orientations_.along(opposite(*c), moving.anchor);
  if (!moving.moves) return result;
  const Spatial<Interval> slope = moving.joint_slope(*c);
  result.slope = orientations_.along(opposite(slope), moving.anchor);
  result.slope.constant += dot(*c, slope);
  const Interval root = root_of(reach.squared_b_entry);
  result.entry = sign > 0 ? root : -root;
  return result;
}

HeldSlice::LegAt SphericalHeldSlice::leg_at(std::size_t i, const Interval& q) const noexcept {
  const MovingLeg& moving = legs_[i];
  const HeldPoint at(moving_leg(i), q);
  LegAt result{orientations_.along(opposite(at.c), moving.anchor),
               orientations_.along(opposite(at.slope), moving.anchor)};
  result.equation.constant +=
      Interval(0.5) * (squared_norm(moving.anchor) + squared_norm(at.c) - at.squared_rod);
  result.slope.constant += dot(at.c, at.slope) - at.rod_slope;
  return result;
}

std::optional<HeldSlice::RodOver> SphericalHeldSlice::rod_over(std::size_t i, int sign,
                                                               const SlicePlace& at) const noexcept {
  const Reach reach = legs_[i].reach(at);
  const Interval entry = sign == 0 ? Interval(0.0) : root_of(reach.squared_b_entry);
  const auto points = legs_[i].leg.link_points(reach.range, entry, sign);
  if (!points) return std::nullopt;
  return RodOver{points->joint, points->length};
}

Verdict SphericalHeldSlice::leg_within_limits(std::size_t i, int sign, const SlicePlace& at) const noexcept {
  const Reach reach = legs_[i].reach(at);
  return verdict(legs_[i].leg.limits(reach.range, root_of(reach.squared_b_entry), sign));
}

Interval SphericalHeldSlice::held_entry(const SlicePlace& at) const noexcept {
  return held_entry_.jet<0>(at.over()).value();
}

}  // namespace parallel_aspects
