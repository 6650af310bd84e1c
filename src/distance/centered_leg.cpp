// SPDX-License-Identifier: BSD-3-Clause
#include "distance/centered_leg.h"

#include <variant>

namespace parallel_aspects {
namespace {

std::array<Interval, 3> axis_of(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

}  // namespace

CenteredLeg::CenteredLeg(const Leg& leg) : type_(leg.kind().type) {
  assert_rounding_upward();
  std::visit([this, &leg](const auto& actuation) { set(actuation, leg.rod_length); }, leg.actuation);
}

void CenteredLeg::set(const RevoluteActuation& actuation, double rod) {
  const Interval crank(actuation.radius), length(rod);
  axis_ = axis_of(actuation.axis);
  squared_crank_ = square(crank);
  half_difference_ = Interval(0.5) * (square(length) - squared_crank_);
  squared_longest_ = square(crank + length);
  squared_shortest_ = square(crank - length);
}

void CenteredLeg::set(const PrismaticActuation& actuation, double rod) {
  axis_ = axis_of(actuation.direction);
  squared_rod_ = square(Interval(rod));
  axial_share_ = Interval(2.0) - (square(axis_[0]) + square(axis_[1]) + square(axis_[2]));
}

void CenteredLeg::set(const ElbowActuation& actuation, double) {
  const Interval inner(actuation.inner_length), outer(actuation.outer_length);
  squared_longest_ = square(inner + outer);
  squared_shortest_ = square(inner - outer);
}

}  // namespace parallel_aspects
