// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STARS_COMMON_POINT_H
#define PARALLEL_ASPECTS_ASPECTS_STARS_COMMON_POINT_H

#include "parallel_aspects/aspects/box.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// A linear function of coordinates in [-1, 1].
struct LinearFunction {
  double at_center = 0.0;
  MapPoint slope{};
};

/// Some linear functions.
struct LinearFunctions {
  static constexpr std::size_t most = 48;

  std::array<LinearFunction, most> items;
  std::size_t count = 0;

  bool is_full() const noexcept { return count == most; }
  void add(const LinearFunction& function) noexcept { items[count++] = function; }
};

/// Where linear functions are positive together, or why they are nowhere.
struct CommonPoint {
  bool found = false;
  MapPoint point{};  ///< with coordinates in [-1, 1]
  /// Of each function, not negative: where no point was found, their sum with these factors is hardly
  /// positive anywhere.
  std::array<double, LinearFunctions::most> weights{};
};

/// Looks for a point where all functions are positive, by a good margin, in double precision.
CommonPoint find_common_point(const LinearFunctions& functions) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STARS_COMMON_POINT_H
