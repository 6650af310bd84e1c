// SPDX-License-Identifier: BSD-3-Clause
#include "legs/spatial_leg.h"

#include "legs/determinant.h"
#include "legs/toleranced.h"

namespace parallel_aspects {

SpatialLeg::SpatialLeg(const Leg& leg)
    : type_(leg.kind().type), reach_(toleranced_reach(leg)), base_(toleranced_base(leg)) {
  assert_rounding_upward();
  std::visit([this, &leg](const auto& actuation) { set(actuation, leg); }, leg.actuation);
}

// |B_jj| turned, with  turned = axis x d,  is what u has along turned.
std::optional<RodOnArc<SpatialLegForm>> SpatialLeg::rod_on_arc(const Spatial<Interval>& d,
                                                               const Turn<Interval>& turn, int sign) const {
  Spatial<Interval> u;
  for (std::size_t i = 0; i < 3; ++i)
    u[i] = d[i] - crank_ * (zero_direction_[i] * turn.cosine + side_direction_[i] * turn.sine);
  if (are_apart(squared_norm(u), squared_rod_) || has_sign(dot(u, cross(axis_, d)), -sign))
    return std::nullopt;
  return RodOnArc<SpatialLegForm>{{0.0, u, {0.0, 0.0, 0.0}}, squared_rod_};
}

void SpatialLeg::set(const RevoluteActuation& actuation, const Leg& leg) {
  axis_ = enclosed(actuation.axis);
  zero_direction_ = enclosed(actuation.zero_direction);
  side_direction_ = cross(axis_, zero_direction_);
  const Interval crank = toleranced_length(actuation.radius, leg),
                 rod = toleranced_length(leg.rod_length, leg);
  rod_ = rod;
  squared_rod_ = square(rod);
  squared_longest_ = square(crank + rod);
  squared_shortest_ = square(crank - rod);
  crank_ = crank;
  squared_crank_ = square(crank);
  half_difference_ = Interval(0.5) * (square(rod) - squared_crank_);
  angle_limits_ = AngleLimits(leg.limits, 0.0, 1.0);
}

void SpatialLeg::set(const PrismaticActuation& actuation, const Leg& leg) {
  axis_ = enclosed(actuation.direction);
  rod_ = toleranced_length(leg.rod_length, leg);
  squared_rod_ = square(rod_);
  length_limits_ = LengthLimits(leg.limits);
}

void SpatialLeg::set(const StrutActuation& actuation, const Leg& leg) {
  length_limits_ =
      LengthLimits(leg.limits, toleranced_length(actuation.length_at_zero, leg), actuation.sense);
}

void SpatialLeg::set(const ElbowActuation& actuation, const Leg& leg) {
  const Interval inner = toleranced_length(actuation.inner_length, leg);
  const Interval outer = toleranced_length(actuation.outer_length, leg);
  squared_longest_ = square(inner + outer);
  squared_shortest_ = square(inner - outer);
  half_sum_ = Interval(0.5) * (square(inner) + square(outer));
  sense_ = actuation.sense;
  angle_limits_ = AngleLimits(leg.limits, actuation.angle_at_zero, actuation.sense);
}

}  // namespace parallel_aspects
