// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_POSE_TEXT_H
#define PARALLEL_ASPECTS_MODEL_POSE_TEXT_H

#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/task_space.h"

#include <cmath>
#include <optional>
#include <string>

namespace parallel_aspects {

/// For people who read poses and frames [m or rad]: zero where only rounding tells a value from it, of
/// doubles or of a URDF, which gives ten digits at the most.
inline double without_noise(double value) noexcept {
  constexpr double noise = 1e-9;
  return std::abs(value) < noise ? 0.0 : value;
}

/// Digits of a pose that is to be typed again.
inline constexpr int pose_digits = 10;

/// The coordinates of a pose as questions take them, "4.5 8", with at most so many significant digits.
std::string pose_numbers(TaskSpace space, const Pose& pose, int digits = 6);

/// The pose that these numbers say when they are typed; nothing where `pose` is not finite.
std::optional<Pose> as_typed(TaskSpace space, const Pose& pose, int digits);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_POSE_TEXT_H
