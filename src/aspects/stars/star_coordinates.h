// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STARS_STAR_COORDINATES_H
#define PARALLEL_ASPECTS_ASPECTS_STARS_STAR_COORDINATES_H

#include "aspects/boxes/box_forms.h"
#include "aspects/boxes/evaluated_legs.h"
#include "aspects/stars/star_conditions.h"
#include "interval/affine.h"
#include "interval/dual.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Coordinates in which a star is looked for: those of the pose, with the heights h = |B_jj| of `Levels` legs
/// in place of as many of them. Enclosures are affine forms of all pose coordinates and of the heights
/// besides.
template <class Chart, std::size_t Levels>
class StarCoordinates {
 public:
  static constexpr std::size_t size = Chart::coordinate_count, leg_count = Chart::leg_count;
  using Form = Affine<size + Levels>;

  std::array<std::size_t, Levels> leg{};           ///< whose heights are taken
  std::array<std::size_t, Levels> replaced{};      ///< the pose coordinate that each height stands for
  std::array<double, Levels> lowest{}, highest{};  ///< of the heights looked at, which are positive

  bool is_replaced(std::size_t i) const noexcept {
    for (const std::size_t each : replaced)
      if (each == i) return true;
    return false;
  }

  LegSet legs() const noexcept {
    LegSet result = 0;
    for (const std::size_t j : leg) result |= BoxFacts::bit(j);
    return result;
  }

  Form height(std::size_t level) const noexcept {
    return Form::coordinate(Interval(lowest[level], highest[level]), size + level);
  }

  static std::array<Form, size> pose(const ChartBox<Chart>& at) {
    std::array<Form, size> result;
    for (std::size_t i = 0; i < size; ++i) result[i] = Form::coordinate(at.range(i), i);
    return result;
  }

  /// |B_jj| of every leg. That of a leg that is neither clear nor among the levels has no slope.
  template <class Entries>
  std::array<Form, leg_count> entries(const Entries& known, const PlacedLegs<Chart, Form>& placed) const {
    std::array<Form, leg_count> result;
    for (std::size_t j = 0; j < leg_count; ++j)
      result[j] = known.clear(j) ? square_root(placed.squared_entry(j), known.square(j).lower())
                                 : Form(known.value(j));
    for (std::size_t level = 0; level < Levels; ++level) result[leg[level]] = height(level);
    return result;
  }
};

/// Legs that are not clear, but for `levels`.
template <class Entries>
LegSet unclear_but(LegSet levels, const Entries& entries, std::size_t leg_count) noexcept {
  LegSet result = 0;
  for (std::size_t j = 0; j < leg_count; ++j)
    if (!entries.clear(j)) result |= BoxFacts::bit(j);
  return static_cast<LegSet>(result & ~levels);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STARS_STAR_COORDINATES_H
