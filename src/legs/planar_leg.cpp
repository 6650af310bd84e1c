// SPDX-License-Identifier: BSD-3-Clause
#include "legs/planar_leg.h"

#include "legs/toleranced.h"

#include <cmath>

namespace parallel_aspects {

PlanarLeg::PlanarLeg(const Leg& leg) : type_(leg.kind().type) {
  assert_rounding_upward();
  set_base(leg);
  std::visit([this, &leg](const auto& actuation) { set(actuation, leg); }, leg.actuation);
}

std::optional<RodOnArc<PlanarLegForm>> PlanarLeg::rod_on_arc(const Planar<Interval>& d,
                                                             const Turn<Interval>& turn, int sign) const {
  const Planar<Interval> u{d.x - crank_ * turn.cosine, d.y - crank_ * turn.sine};
  const Interval entry = Interval(sense_) * (u.y * d.x - u.x * d.y);
  if (are_apart(squared_norm(u), squared_rod_) || has_sign(entry, -sign)) return std::nullopt;
  return RodOnArc<PlanarLegForm>{{0.0, u, {0.0, 0.0}}, squared_rod_};
}

std::optional<double> PlanarLeg::crank_that_folds() const noexcept {
  const double length = crank_.upper();
  const bool folds = type_ == LegType::revolute && squared_height_.upper() == 0.0 &&
                     crank_.lower() == length && rod_.lower() == length && rod_.upper() == length;
  return folds ? std::optional(length) : std::nullopt;
}

void PlanarLeg::set_base(const Leg& leg) {
  const std::array<Interval, 3> base = toleranced_base(leg);
  base_ = {base[0], base[1]};
  squared_height_ = square(toleranced_anchor(leg)[2] - base[2]);
  reach_ = toleranced_reach(leg);
}

void PlanarLeg::set_two_links(const Interval& squared_first, const Interval& squared_second) {
  const Interval twice_product = Interval(2.0) * square_root(squared_first * squared_second);
  squared_longest_ = squared_first + squared_second + twice_product;
  squared_shortest_ = squared_first + squared_second - twice_product;
}

void PlanarLeg::set(const RevoluteActuation& actuation, const Leg& leg) {
  crank_ = toleranced_length(actuation.radius, leg);
  const Interval squared_crank = square(crank_);
  // Anchor and crank tip move in parallel planes; what is left of the rod in the plane.
  rod_ = toleranced_length(leg.rod_length, leg);
  squared_rod_ = square(rod_) - squared_height_;
  set_two_links(squared_crank, not_negative_part(squared_rod_));
  half_difference_ = Interval(0.5) * (squared_rod_ - squared_crank);
  sense_ = actuation.axis.z() > 0.0 ? 1.0 : -1.0;
  const double zero_angle = sense_ * std::atan2(actuation.zero_direction.y(), actuation.zero_direction.x());
  angle_limits_ = AngleLimits(leg.limits, zero_angle, 1.0);
}

void PlanarLeg::set(const PrismaticActuation& actuation, const Leg& leg) {
  rod_ = toleranced_length(leg.rod_length, leg);
  squared_rod_ = square(rod_) - squared_height_;
  direction_ = {actuation.direction.x(), actuation.direction.y()};
  length_limits_ = LengthLimits(leg.limits);
}

void PlanarLeg::set(const StrutActuation& actuation, const Leg& leg) {
  length_limits_ =
      LengthLimits(leg.limits, toleranced_length(actuation.length_at_zero, leg), actuation.sense);
}

void PlanarLeg::set(const ElbowActuation& actuation, const Leg& leg) {
  const Interval squared_inner = square(toleranced_length(actuation.inner_length, leg));
  const Interval squared_outer = square(toleranced_length(actuation.outer_length, leg));
  set_two_links(squared_inner, squared_outer);
  half_sum_ = Interval(0.5) * (squared_inner + squared_outer);
  sense_ = actuation.sense;
  angle_limits_ = AngleLimits(leg.limits, actuation.angle_at_zero, actuation.sense);
}

}  // namespace parallel_aspects
