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

/// The unit in which distances between configurations are displayed and entered: lengths or, for robots that
/// move on the unit sphere, the angles at its center. The model computes with lengths, there chords. Nothing
/// else decides between the two.
class DistanceUnit {
 public:
  constexpr DistanceUnit() noexcept = default;  ///< of lengths
  explicit DistanceUnit(const Manipulator& manipulator) noexcept;
  static constexpr DistanceUnit of_angles() noexcept { return DistanceUnit(true); }

  constexpr bool is_angle() const noexcept { return is_angle_; }
  constexpr const char* name() const noexcept { return is_angle_ ? "rad" : "m"; }

  /// A length of the model in this unit; what is not finite stays.
  double displayed(double length) const noexcept;

  /// The rate of `displayed(length)` where the length of the model changes at `speed` [m/s].
  double displayed_speed(double length, double speed) const noexcept;

  /// The length of the model for a value in this unit; for more than half a turn the diameter.
  double length_of(double value) const noexcept;

  /// "0.1 m" or "0.1 rad", of a length of the model.
  std::string text(double length, int digits) const;

 private:
  constexpr explicit DistanceUnit(bool is_angle) noexcept : is_angle_(is_angle) {}

  bool is_angle_ = false;
};

/// The angle at the center [rad] of a chord of the sphere of radius 1 m.
double angle_of_chord(double chord) noexcept;

/// A distance between configurations with its unit, as `DistanceUnit` has it: "0.1 m" or "5.73 deg (0.1
/// rad)".
std::string distance_text(const Manipulator& manipulator, double length, int digits = 6);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_SPHERICAL_LINKS_H
