// SPDX-License-Identifier: BSD-3-Clause
#include "legs/spatial_leg.h"

#include "legs/determinant.h"
#include "legs/toleranced.h"

namespace parallel_aspects {
namespace {

Spatial<Interval> enclosed(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

}  // namespace

SpatialLeg::SpatialLeg(const Leg& leg)
    : type_(leg.kind().type), reach_(toleranced_reach(leg)), base_(toleranced_base(leg)) {
  assert_rounding_upward();
  std::visit([this, &leg](const auto& actuation) { set(actuation, leg); }, leg.actuation);
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
