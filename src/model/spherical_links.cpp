// SPDX-License-Identifier: BSD-3-Clause
#include "model/spherical_links.h"

#include "model/number_text.h"
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

std::string distance_text(const Manipulator& manipulator, double length, int digits) {
  if (!moves_on_unit_sphere(manipulator) || !std::isfinite(length)) return number_text(length, digits) + " m";
  const double angle = angle_of_chord(length);
  return number_text(angle * 180.0 / EIGEN_PI, digits) + " deg (" + number_text(angle, digits) + " rad)";
}

}  // namespace parallel_aspects
