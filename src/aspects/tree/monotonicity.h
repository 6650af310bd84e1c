// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_MONOTONICITY_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_MONOTONICITY_H

#include "interval/lanes.h"
#include "interval/scalar_range.h"
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
///
/// `Number`: of one box, or of several in lanes.
template <class Number>
class MonotonicityIn {
 public:
  using Mask = MaskOf<Number>;
  using Bits = BitsOf<Number>;

  /// Of the whole box: along every coordinate, in both directions.
  static MonotonicityIn of_everything() noexcept { return {~Bits{}, ~Bits{}}; }
  static MonotonicityIn unknown() noexcept { return {Bits{}, Bits{}}; }

  /// Bit i is set where it grows along coordinate i in this direction.
  MonotonicityIn(const Bits& upward, const Bits& downward) noexcept : upward_(upward), downward_(downward) {}

  Mask upward(std::size_t coordinate) const noexcept { return (upward_ & bit(coordinate)) != 0; }
  Mask downward(std::size_t coordinate) const noexcept { return (downward_ & bit(coordinate)) != 0; }
  Mask along(std::size_t coordinate) const noexcept { return ((upward_ | downward_) & bit(coordinate)) != 0; }

  /// Along every coordinate in which the box, or `ChartBox`, has a width.
  template <class AnyBox>
  Mask along_all(const AnyBox& box) const noexcept {
    Mask all = !Mask{};
    for (std::size_t i = 0; i < box.dimension; ++i) all &= along(i) | !(box.width(i) > 0.0);
    return all;
  }

  /// Of the box in one lane.
  MonotonicityIn<double> lane(std::size_t i) const noexcept {
    return {lane_of(upward_, i), lane_of(downward_, i)};
  }

  /// Leaves the directions in which both sets grow.
  MonotonicityIn with(const MonotonicityIn& other) const noexcept {
    return {upward_ & other.upward_, downward_ & other.downward_};
  }

  /// This where the condition holds, else the other.
  MonotonicityIn where_or(const Mask& condition, const MonotonicityIn& other) const noexcept {
    return {where(condition, upward_, other.upward_), where(condition, downward_, other.downward_)};
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

  /// Leaves the directions in which { f > 0 } grows too, f with this gradient times any positive function;
  /// where the condition holds.
  template <class Value, std::size_t N>
  void require(const std::array<Value, N>& gradient, const Mask& condition = !Mask{}) noexcept {
    for (std::size_t i = 0; i < N; ++i) {
      const auto range = range_of(gradient[i]);
      upward_ &= ~bits_where(condition & !(range.lower() >= 0.0), bit(i));
      downward_ &= ~bits_where(condition & !(range.upper() <= 0.0), bit(i));
    }
  }

 private:
  static constexpr std::int64_t bit(std::size_t coordinate) noexcept { return std::int64_t{1} << coordinate; }

  Bits upward_, downward_;  // bit i for coordinate i
};

using Monotonicity = MonotonicityIn<double>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_MONOTONICITY_H
