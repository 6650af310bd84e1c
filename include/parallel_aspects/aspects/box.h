// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOX_H
#define PARALLEL_ASPECTS_ASPECTS_BOX_H

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Maps are trees over at most three pose coordinates.
inline constexpr std::size_t max_map_dimension = 3;

/// A closed box of pose coordinates, in the order of `coordinate_names` [m or rad].
struct Box {
  std::size_t dimension = 0;
  std::array<double, max_map_dimension> lower{};
  std::array<double, max_map_dimension> upper{};

  double center(std::size_t i) const noexcept { return 0.5 * (lower[i] + upper[i]); }
  double width(std::size_t i) const noexcept { return upper[i] - lower[i]; }

  double measure() const noexcept {
    double product = 1.0;
    for (std::size_t i = 0; i < dimension; ++i) product *= width(i);
    return product;
  }

  bool contains(const std::array<double, max_map_dimension>& point) const noexcept {
    for (std::size_t i = 0; i < dimension; ++i)
      if (!(lower[i] <= point[i] && point[i] <= upper[i])) return false;
    return true;
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOX_H
