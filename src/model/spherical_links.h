// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_SPHERICAL_LINKS_H
#define PARALLEL_ASPECTS_MODEL_SPHERICAL_LINKS_H

#include "parallel_aspects/model/manipulator.h"

#include <optional>

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_SPHERICAL_LINKS_H
