// SPDX-License-Identifier: BSD-3-Clause
#include "model/spherical_links.h"

#include "model/message_text.h"
#include "model/overloaded.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace parallel_aspects {
namespace {

// Of lengths on the unit sphere, where a loader puts legs whose axes it takes as meeting: far above what
// rounding leaves there.
constexpr double tolerance = 1e-9;

std::optional<SphericalLinks> links_of(const RevoluteActuation& crank, const Leg& leg) noexcept {
  const double along = crank.axis.dot(crank.center);
  const bool through_center = (crank.center - along * crank.axis).norm() < tolerance;
  const bool on_sphere = std::abs(std::hypot(crank.radius, along) - 1.0) < tolerance &&
                         std::abs(leg.anchor.norm() - 1.0) < tolerance;
  if (!through_center || !on_sphere) return std::nullopt;
  return SphericalLinks{std::atan2(crank.radius, along), angle_of_chord(leg.rod_length)};
}

}  // namespace

std::optional<SphericalLinks> spherical_links(const Leg& leg) noexcept {
  using Links = std::optional<SphericalLinks>;
  return std::visit(Overloaded{[&leg](const RevoluteActuation& crank) { return links_of(crank, leg); },
                               [](const PrismaticActuation&) { return Links(); },
                               [](const StrutActuation&) { return Links(); },
                               [](const ElbowActuation&) { return Links(); }},
                    leg.actuation);
}

bool moves_on_unit_sphere(const Manipulator& manipulator) noexcept {
  return manipulator.task_space() == TaskSpace::SO3 &&
         std::all_of(manipulator.legs().begin(), manipulator.legs().end(),
                     [](const Leg& leg) { return spherical_links(leg).has_value(); });
}

double angle_of_chord(double chord) noexcept { return 2.0 * std::asin(std::clamp(0.5 * chord, 0.0, 1.0)); }

DistanceUnit::DistanceUnit(const Manipulator& manipulator) noexcept
    : is_angle_(moves_on_unit_sphere(manipulator)) {}

double DistanceUnit::displayed(double length) const noexcept {
  return is_angle_ && std::isfinite(length) ? angle_of_chord(length) : length;
}

double DistanceUnit::displayed_speed(double length, double speed) const noexcept {
  if (!is_angle_ || !std::isfinite(length)) return speed;
  const double half = std::clamp(0.5 * length, 0.0, 1.0);
  return speed / std::sqrt(1.0 - half * half);
}

double DistanceUnit::length_of(double value) const noexcept {
  return is_angle_ ? 2.0 * std::sin(0.5 * std::clamp<double>(value, 0.0, EIGEN_PI)) : value;
}

std::string DistanceUnit::text(double length, int digits) const {
  return number_text(displayed(length), digits) + " " + name();
}

std::string distance_text(const Manipulator& manipulator, double length, int digits) {
  const DistanceUnit unit(manipulator);
  if (!unit.is_angle() || !std::isfinite(length)) return unit.text(length, digits);
  return number_text(unit.displayed(length) * 180.0 / EIGEN_PI, digits) + " deg (" +
         unit.text(length, digits) + ")";
}

}  // namespace parallel_aspects
