// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STARS_STARS_H
#define PARALLEL_ASPECTS_ASPECTS_STARS_STARS_H

#include "parallel_aspects/aspects/box.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace parallel_aspects {

/// What was found of the set in a box.
struct Stars {
  static constexpr std::size_t most = 16;

  bool is_known = false;  ///< if so, all that the box has of the set is connected with some of the poses each
  std::array<MapPoint, most> poses{};  ///< of the set, maybe a little outside of the box
  std::size_t count = 0;               ///< 0 where the box has nothing of the set

  static Stars none() noexcept {
    Stars result;
    result.is_known = true;
    return result;
  }
  static Stars one(const MapPoint& pose) noexcept {
    Stars result = none();
    result.poses[result.count++] = pose;
    return result;
  }

  /// What is known of two boxes together.
  Stars with(const Stars& other) const noexcept {
    Stars result = *this;
    result.is_known = is_known && other.is_known && count + other.count <= most;
    if (result.is_known) std::copy_n(other.poses.begin(), other.count, result.poses.begin() + count);
    result.count += other.count;
    return result;
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STARS_STARS_H
