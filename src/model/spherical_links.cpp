// SPDX-License-Identifier: BSD-3-Clause
#include "model/spherical_links.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace parallel_aspects {
namespace {

// Of lengths on the unit sphere; far above rounding, and it decides only how a leg is shown.
constexpr double tolerance = 1e-9;

}  // namespace

std::optional<SphericalLinks> spherical_links(const Leg& leg) noexcept {
  const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation);
  if (crank == nullptr) return std::nullopt;
  const double along = crank->axis.dot(crank->center);
  const bool through_center = (crank->center - along * crank->axis).norm() < tolerance;
  const bool on_sphere = std::abs(std::hypot(crank->radius, along) - 1.0) < tolerance &&
                         std::abs(leg.anchor.norm() - 1.0) < tolerance;
  if (!through_center || !on_sphere) return std::nullopt;
  return SphericalLinks{std::atan2(crank->radius, along), angle_of_chord(leg.rod_length)};
}

bool moves_on_unit_sphere(const Manipulator& manipulator) noexcept {
  return manipulator.task_space() == TaskSpace::SO3 &&
         std::all_of(manipulator.legs().begin(), manipulator.legs().end(),
                     [](const Leg& leg) { return spherical_links(leg).has_value(); });
}

double angle_of_chord(double chord) noexcept { return 2.0 * std::asin(std::clamp(0.5 * chord, 0.0, 1.0)); }

}  // namespace parallel_aspects
