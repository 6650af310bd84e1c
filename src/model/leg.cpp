// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/leg.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parallel_aspects {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

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

bool Leg::actuated_by_angle() const noexcept {
  return std::holds_alternative<RevoluteActuation>(actuation) ||
         std::holds_alternative<ElbowActuation>(actuation);
}

bool Leg::has_branch(int sign) const noexcept {
  const auto* strut = std::get_if<StrutActuation>(&actuation);
  return strut == nullptr || strut->sense * sign > 0.0;
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

std::string_view kind_name(const Actuation& actuation) noexcept {
  static constexpr std::array<std::string_view, 4> names{
      "actuated revolute joint", "actuated prismatic joint", "strut", "actuated elbow"};
  return names[actuation.index()];
}

}  // namespace parallel_aspects
