// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_SPHERICAL_LINKS_H
#define PARALLEL_ASPECTS_MODEL_SPHERICAL_LINKS_H

#include "parallel_aspects/model/manipulator.h"

#include <optional>
#include <string>

namespace parallel_aspects {

/// The two links of a spherical leg RRR, whose axes meet in the center: angles between the axes of their
/// joints [rad]. The model has the elbow and the anchor on the sphere of radius 1 m about the center.
struct SphericalLinks {
  double crank;
  double rod;
};

/// Nothing for a leg whose lengths are lengths.
std::optional<SphericalLinks> spherical_links(const Leg& leg) noexcept;

/// Whether all legs are such, so that every distance is one on a sphere of radius 1 m.
bool moves_on_unit_sphere(const Manipulator& manipulator) noexcept;

/// The angle at the center [rad] of a chord of the sphere of radius 1 m.
double angle_of_chord(double chord) noexcept;

/// A distance between configurations with its unit: "0.1 m" or, on the sphere, where an angle says more than
/// a length, "5.73 deg (0.1 rad)".
std::string distance_text(const Manipulator& manipulator, double length, int digits = 6);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_SPHERICAL_LINKS_H
