// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_MONOTONICITY_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_MONOTONICITY_H

#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace parallel_aspects {

/// In which directions a set of poses are monotone through a box. It grows upward along a coordinate if with
/// each pose of it, all poses of the box are in it that differ by a larger value of this coordinate only;
/// likewise downward.
///
/// A set that is monotone along a coordinate can be pushed onto one face of the box without leaving itself:
/// it is connected if what it has of that face is, and empty if that is. One that is monotone along every
/// coordinate is connected or empty, and holds one corner unless it is empty.
///
/// A set { f > 0 } grows upward where the partial derivative of f is nowhere negative, and sets that grow
/// alike leave intersections and unions that do.
class Monotonicity {
 public:
  /// Of the whole box: along every coordinate, in both directions.
  static Monotonicity of_everything() noexcept { return Monotonicity(0xffU, 0xffU); }
  static Monotonicity unknown() noexcept { return Monotonicity(0, 0); }

  /// Bit i is set where it grows along coordinate i in this direction.
  Monotonicity(std::uint8_t upward, std::uint8_t downward) noexcept : upward_(upward), downward_(downward) {}

  bool upward(std::size_t coordinate) const noexcept { return (upward_ >> coordinate & 1U) != 0; }
  bool downward(std::size_t coordinate) const noexcept { return (downward_ >> coordinate & 1U) != 0; }
  bool along(std::size_t coordinate) const noexcept { return upward(coordinate) || downward(coordinate); }

  /// Along every coordinate in which the box has a width.
  bool along_all(const Box& box) const noexcept {
    for (std::size_t i = 0; i < box.dimension; ++i)
      if (box.width(i) > 0.0 && !along(i)) return false;
    return true;
  }

  /// Leaves the directions in which both sets grow.
  Monotonicity with(const Monotonicity& other) const noexcept {
    return Monotonicity(static_cast<std::uint8_t>(upward_ & other.upward_),
                        static_cast<std::uint8_t>(downward_ & other.downward_));
  }

  /// Flattens the box onto the face, edge or corner that the set grows to, along every coordinate along which
  /// it grows; whether there was any.
  bool flatten(Box& box) const noexcept {
    bool flattened = false;
    for (std::size_t i = 0; i < box.dimension; ++i) {
      if (!(box.width(i) > 0.0) || !along(i)) continue;
      (upward(i) ? box.lower[i] : box.upper[i]) = upward(i) ? box.upper[i] : box.lower[i];
      flattened = true;
    }
    return flattened;
  }

  /// The corner of the box that the set grows away from.
  MapPoint lowest(const Box& box) const noexcept {
    MapPoint corner{};
    for (std::size_t i = 0; i < box.dimension; ++i) corner[i] = upward(i) ? box.lower[i] : box.upper[i];
    return corner;
  }

  /// The corner that it grows to.
  MapPoint highest(const Box& box) const noexcept {
    MapPoint corner{};
    for (std::size_t i = 0; i < box.dimension; ++i) corner[i] = upward(i) ? box.upper[i] : box.lower[i];
    return corner;
  }

  /// Leaves the directions in which { f > 0 } grows too, f with this gradient times any positive function.
  template <std::size_t N>
  void require(const std::array<Interval, N>& gradient) noexcept {
    for (std::size_t i = 0; i < N; ++i) {
      if (!(gradient[i].lower() >= 0.0)) upward_ &= static_cast<std::uint8_t>(~(1U << i));
      if (!(gradient[i].upper() <= 0.0)) downward_ &= static_cast<std::uint8_t>(~(1U << i));
    }
  }

 private:
  std::uint8_t upward_, downward_;  // bit i for coordinate i
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_MONOTONICITY_H
