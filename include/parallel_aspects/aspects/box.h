// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOX_H
#define PARALLEL_ASPECTS_ASPECTS_BOX_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace parallel_aspects {

/// Maps are trees over at most three pose coordinates.
inline constexpr std::size_t max_map_dimension = 3;

/// A point of the space of poses that a map is made over, in the order of `coordinate_names` [m or rad].
using MapPoint = std::array<double, max_map_dimension>;

/// A closed box of pose coordinates, in the order of `coordinate_names` [m or rad].
struct Box {
  std::size_t dimension = 0;  ///< how many coordinates count, 0 to `max_map_dimension`
  MapPoint lower{};           ///< lower ends [m or rad]
  MapPoint upper{};           ///< upper ends, not below the lower [m or rad]

  /// Middle of its range of coordinate i [m or rad].
  double center(std::size_t i) const noexcept { return 0.5 * (lower[i] + upper[i]); }

  /// Length of its range of coordinate i [m or rad].
  double width(std::size_t i) const noexcept { return upper[i] - lower[i]; }

  /// Its center.
  MapPoint middle() const noexcept {
    MapPoint result{};
    for (std::size_t i = 0; i < dimension; ++i) result[i] = center(i);
    return result;
  }

  /// Its volume, in the product of the units of its coordinates; 1 in no dimension.
  double measure() const noexcept {
    double product = 1.0;
    for (std::size_t i = 0; i < dimension; ++i) product *= width(i);
    return product;
  }

  /// Whether the point lies in it or on its faces.
  bool contains(const MapPoint& point) const noexcept {
    for (std::size_t i = 0; i < dimension; ++i)
      if (!(lower[i] <= point[i] && point[i] <= upper[i])) return false;
    return true;
  }

  /// The point of the box that is nearest to `point`.
  MapPoint nearest(const MapPoint& point) const noexcept {
    MapPoint result{};
    for (std::size_t i = 0; i < dimension; ++i) result[i] = std::clamp(point[i], lower[i], upper[i]);
    return result;
  }

  /// Squared distance of `point` from the box, with differences multiplied by `weights`.
  double squared_distance(const MapPoint& point, const MapPoint& weights) const noexcept {
    const MapPoint closest = nearest(point);
    double sum = 0.0;
    for (std::size_t i = 0; i < dimension; ++i) {
      const double difference = weights[i] * (point[i] - closest[i]);
      sum += difference * difference;
    }
    return sum;
  }

  /// Rank of the half, quarter or eighth that holds `point`: bit i is set in the upper half along coordinate
  /// i.
  std::uint32_t rank_of(const MapPoint& point) const noexcept {
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < dimension; ++i)
      if (point[i] >= center(i)) rank |= 1U << i;
    return rank;
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOX_H
