// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_MESSAGE_TEXT_H
#define PARALLEL_ASPECTS_MODEL_MESSAGE_TEXT_H

#include "parallel_aspects/model/pose.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Digits that distinguish every double from all others.
inline constexpr int exact_digits = 17;

/// A number as people write it, "0.5" or "1e-09", with at most so many significant digits. The same in every
/// locale, as files and other programs have to read it.
std::string number_text(double value, int digits = 6);

/// The same with so many digits after the point: "0.50".
std::string fixed_number_text(double value, int decimals);

/// "a", "a and b", "a, b and c".
inline std::string enumerated(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

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
std::optional<Pose> as_typed(const Motions& motions, const Pose& pose, int digits);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_MESSAGE_TEXT_H
