// SPDX-License-Identifier: BSD-3-Clause
#include "model/overloaded.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

double elbow_angle(const ElbowActuation& actuation, double q) {
  return actuation.angle_at_zero + actuation.sense * q;
}

double largest_magnitude(const JointLimits& limits) {
  return std::max(std::abs(limits.lower), std::abs(limits.upper));
}

double longest_strut(const StrutActuation& actuation, const JointLimits& limits) {
  return std::max(actuation.length_at_zero + actuation.sense * limits.lower,
                  actuation.length_at_zero + actuation.sense * limits.upper);
}

}  // namespace

Eigen::Vector3d Leg::proximal_point(double q) const noexcept {
  return std::visit(
      Overloaded{[q](const RevoluteActuation& d) -> Eigen::Vector3d {
                   return d.center + d.radius * (std::cos(q) * d.zero_direction +
                                                 std::sin(q) * d.axis.cross(d.zero_direction));
                 },
                 [q](const PrismaticActuation& d) -> Eigen::Vector3d { return d.origin + q * d.direction; },
                 [](const StrutActuation& d) -> Eigen::Vector3d { return d.base; },
                 [](const ElbowActuation& d) -> Eigen::Vector3d { return d.base; }},
      actuation);
}

Eigen::Vector3d Leg::proximal_point_derivative(double q) const noexcept {
  return std::visit(
      Overloaded{[q](const RevoluteActuation& d) -> Eigen::Vector3d {
                   return d.radius *
                          (std::cos(q) * d.axis.cross(d.zero_direction) - std::sin(q) * d.zero_direction);
                 },
                 [](const PrismaticActuation& d) -> Eigen::Vector3d { return d.direction; },
                 [](const StrutActuation&) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); },
                 [](const ElbowActuation&) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); }},
      actuation);
}

double Leg::squared_distance(double q) const noexcept {
  return std::visit(Overloaded{[this](const RevoluteActuation&) { return rod_length * rod_length; },
                               [this](const PrismaticActuation&) { return rod_length * rod_length; },
                               [q](const StrutActuation& d) {
                                 const double length = d.length_at_zero + d.sense * q;
                                 return length * length;
                               },
                               [q](const ElbowActuation& d) {
                                 return d.inner_length * d.inner_length + d.outer_length * d.outer_length +
                                        2.0 * d.inner_length * d.outer_length * std::cos(elbow_angle(d, q));
                               }},
                    actuation);
}

double Leg::squared_distance_derivative(double q) const noexcept {
  return std::visit(
      Overloaded{[](const RevoluteActuation&) { return 0.0; }, [](const PrismaticActuation&) { return 0.0; },
                 [q](const StrutActuation& d) { return 2.0 * d.sense * (d.length_at_zero + d.sense * q); },
                 [q](const ElbowActuation& d) {
                   return -2.0 * d.sense * d.inner_length * d.outer_length * std::sin(elbow_angle(d, q));
                 }},
      actuation);
}

double Leg::residual(const Pose& pose, double q) const noexcept {
  return (pose.transform(anchor) - proximal_point(q)).squaredNorm() - squared_distance(q);
}

const LegKind& Leg::kind() const noexcept {
  return std::visit([](const auto& each) -> const LegKind& { return each.kind; }, actuation);
}

const RevoluteActuation* Leg::crank() const noexcept {
  using Crank = const RevoluteActuation*;
  return std::visit(Overloaded{[](const RevoluteActuation& d) -> Crank { return &d; },
                               [](const PrismaticActuation&) -> Crank { return nullptr; },
                               [](const StrutActuation&) -> Crank { return nullptr; },
                               [](const ElbowActuation&) -> Crank { return nullptr; }},
                    actuation);
}

bool Leg::has_branch(int sign) const noexcept {
  return std::visit(Overloaded{[](const RevoluteActuation&) { return true; },
                               [](const PrismaticActuation&) { return true; },
                               [sign](const StrutActuation& d) { return d.sense * sign > 0.0; },
                               [](const ElbowActuation&) { return true; }},
                    actuation);
}

bool Leg::can_have(double q) const noexcept {
  return std::visit(
      Overloaded{[](const RevoluteActuation&) { return true; },
                 [](const PrismaticActuation&) { return true; },
                 [q](const StrutActuation& d) { return !(d.length_at_zero + d.sense * q < 0.0); },
                 [](const ElbowActuation&) { return true; }},
      actuation);
}

// u.c' where c moves, rho rho' where rho does: a sine times these lengths.
double Leg::largest_entry() const noexcept {
  return std::visit(Overloaded{[this](const RevoluteActuation& d) { return d.radius * rod_length; },
                               [this](const PrismaticActuation&) { return rod_length; },
                               [](const StrutActuation&) { return 0.0; },
                               [](const ElbowActuation& d) { return d.inner_length * d.outer_length; }},
                    actuation);
}

double Leg::longest_reach() const noexcept {
  return std::visit(
      Overloaded{[this](const RevoluteActuation& d) { return d.radius + rod_length; },
                 [this](const PrismaticActuation&) { return largest_magnitude(limits) + rod_length; },
                 [this](const StrutActuation& d) { return longest_strut(d, limits); },
                 [](const ElbowActuation& d) { return d.inner_length + d.outer_length; }},
      actuation);
}

Eigen::Vector3d Leg::base_point() const noexcept {
  return std::visit(Overloaded{[](const RevoluteActuation& d) { return d.center; },
                               [](const PrismaticActuation& d) { return d.origin; },
                               [](const StrutActuation& d) { return d.base; },
                               [](const ElbowActuation& d) { return d.base; }},
                    actuation);
}

}  // namespace parallel_aspects
