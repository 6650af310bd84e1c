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

double elbow_angle(const ElbowDrive& drive, double q) { return drive.angle_at_zero + drive.sense * q; }

double largest_magnitude(const JointLimits& limits) {
  return std::max(std::abs(limits.lower), std::abs(limits.upper));
}

double longest_strut(const StrutDrive& drive, const JointLimits& limits) {
  return std::max(drive.length_at_zero + drive.sense * limits.lower,
                  drive.length_at_zero + drive.sense * limits.upper);
}

}  // namespace

Eigen::Vector3d Leg::proximal_point(double q) const noexcept {
  return std::visit(
      Overloaded{[q](const RevoluteDrive& d) -> Eigen::Vector3d {
                   return d.center + d.radius * (std::cos(q) * d.zero_direction +
                                                 std::sin(q) * d.axis.cross(d.zero_direction));
                 },
                 [q](const PrismaticDrive& d) -> Eigen::Vector3d { return d.origin + q * d.direction; },
                 [](const StrutDrive& d) -> Eigen::Vector3d { return d.base; },
                 [](const ElbowDrive& d) -> Eigen::Vector3d { return d.base; }},
      drive);
}

Eigen::Vector3d Leg::proximal_point_derivative(double q) const noexcept {
  return std::visit(Overloaded{[q](const RevoluteDrive& d) -> Eigen::Vector3d {
                                 return d.radius * (std::cos(q) * d.axis.cross(d.zero_direction) -
                                                    std::sin(q) * d.zero_direction);
                               },
                               [](const PrismaticDrive& d) -> Eigen::Vector3d { return d.direction; },
                               [](const StrutDrive&) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); },
                               [](const ElbowDrive&) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); }},
                    drive);
}

double Leg::squared_distance(double q) const noexcept {
  return std::visit(Overloaded{[this](const RevoluteDrive&) { return rod_length * rod_length; },
                               [this](const PrismaticDrive&) { return rod_length * rod_length; },
                               [q](const StrutDrive& d) {
                                 const double length = d.length_at_zero + d.sense * q;
                                 return length * length;
                               },
                               [q](const ElbowDrive& d) {
                                 return d.inner_length * d.inner_length + d.outer_length * d.outer_length +
                                        2.0 * d.inner_length * d.outer_length * std::cos(elbow_angle(d, q));
                               }},
                    drive);
}

double Leg::squared_distance_derivative(double q) const noexcept {
  return std::visit(
      Overloaded{[](const RevoluteDrive&) { return 0.0; }, [](const PrismaticDrive&) { return 0.0; },
                 [q](const StrutDrive& d) { return 2.0 * d.sense * (d.length_at_zero + d.sense * q); },
                 [q](const ElbowDrive& d) {
                   return -2.0 * d.sense * d.inner_length * d.outer_length * std::sin(elbow_angle(d, q));
                 }},
      drive);
}

double Leg::residual(const Pose& pose, double q) const noexcept {
  return (pose.transform(anchor) - proximal_point(q)).squaredNorm() - squared_distance(q);
}

bool Leg::driven_by_angle() const noexcept {
  return std::holds_alternative<RevoluteDrive>(drive) || std::holds_alternative<ElbowDrive>(drive);
}

bool Leg::has_branch(int sign) const noexcept {
  const auto* strut = std::get_if<StrutDrive>(&drive);
  return strut == nullptr || strut->sense * sign > 0.0;
}

double Leg::longest_reach() const noexcept {
  return std::visit(
      Overloaded{[this](const RevoluteDrive& d) { return d.radius + rod_length; },
                 [this](const PrismaticDrive&) { return largest_magnitude(limits) + rod_length; },
                 [this](const StrutDrive& d) { return longest_strut(d, limits); },
                 [](const ElbowDrive& d) { return d.inner_length + d.outer_length; }},
      drive);
}

Eigen::Vector3d Leg::base_point() const noexcept {
  return std::visit(
      Overloaded{[](const RevoluteDrive& d) { return d.center; },
                 [](const PrismaticDrive& d) { return d.origin; }, [](const StrutDrive& d) { return d.base; },
                 [](const ElbowDrive& d) { return d.base; }},
      drive);
}

std::string_view kind_name(const Drive& drive) noexcept {
  static constexpr std::array<std::string_view, 4> names{"revolute drive", "prismatic drive", "strut",
                                                         "driven elbow"};
  return names[drive.index()];
}

}  // namespace parallel_aspects
