// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_INDEX_ON_ARCS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_INDEX_ON_ARCS_H

#include "aspects/boxes/box_intervals.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "legs/determinant.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// The index in a box where an anchor can lie on the axis of its crank: beside such a pose the crank points
/// anywhere, so that the box alone says nothing of the leg's row, however small it is. So its circle is
/// divided into arcs, and the row is taken from where the crank is on each.
template <class Chart>
class IndexOnArcs {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count;
  using Signs = std::array<int, leg_count>;

  /// A leg's anchor is near its axis where the square of its distance, which is not negative, may be less
  /// than this share of what it may be. Boxes farther off come to tell enough of the row when they are
  /// halved.
  static constexpr double near_axis = 0.05;

  /// The box must be reachable somewhere, and outlive this.
  IndexOnArcs(const BoxIntervals<Chart>& box, const Signs& signs) noexcept
      : box_(box), signs_(signs), leg_(leg_near_axis()) {}

  /// What is left of bounds of the index where det A has this sign; all where no leg is near its axis.
  Interval closer(const Interval& known, ParallelIndex kind, int sign) const noexcept {
    if (!leg_) return known;
    double largest = 0.0;
    for (const Turn<Interval>& arc : arcs()) {
      largest = std::max(largest, largest_on(arc, kind, sign));
      if (!(largest < known.upper())) return known;
    }
    return {std::min(known.lower(), largest), largest};
  }

 private:
  static constexpr int arcs_of_half = 32;  // a power of two, so that their ends are exact
  using Legs = EvaluatedLegs<Chart, Interval>;
  using Row = parallel_aspects::Row<Interval, leg_count>;

  /// The legs as `MarginTests` asks for them, with a row of u for that near its axis.
  struct LegsOnArc {
    const Legs& legs;
    std::size_t near;
    Row row_of_rod;
    Interval squared_length;

    const Row& row(std::size_t j, int sign) const { return j == near ? row_of_rod : legs.row(j, sign); }
    Interval squared_rod(std::size_t j) const { return j == near ? squared_length : legs.squared_rod(j); }
    Interval scale(std::size_t j) const { return j == near ? Interval(1.0) : legs.scale(j); }
    auto turned(const Point<Interval, Chart::point_dimension>& direction) const {
      return legs.turned(direction);
    }
  };

  using Arcs = std::array<Turn<Interval>, std::size_t{2 * arcs_of_half}>;

  static const Arcs& arcs() noexcept {
    static const Arcs all = [] {
      Arcs arcs;
      for (int i = -arcs_of_half; i < arcs_of_half; ++i)
        arcs[static_cast<std::size_t>(i + arcs_of_half)] = turn_of_half_turns(
            {static_cast<double>(i) / arcs_of_half, static_cast<double>(i + 1) / arcs_of_half});
      return arcs;
    }();
    return all;
  }

  /// Only cranks have a scale that is not 1: the square of the anchor's distance from the axis.
  std::optional<std::size_t> leg_near_axis() const noexcept {
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Interval scale = box_.at().chart.scale(j, box_.displacement(j));
      if (scale.lower() < near_axis * scale.upper()) return j;
    }
    return std::nullopt;
  }

  double largest_on(const Turn<Interval>& turn, ParallelIndex kind, int sign) const noexcept {
    const auto& chart = box_.at().chart;
    const auto& d = box_.displacement(*leg_);
    const auto rod = chart.rod_on_arc(*leg_, d, turn, signs_[*leg_]);
    if (!rod) return 0.0;
    const LegsOnArc legs{box_.legs(), *leg_, chart.rows(*leg_, rod->form, d, box_.placement()).fixed,
                         rod->squared_length};
    const Interval squares = box_.at().tests.margins().index_squares(kind, legs, signs_);
    const Interval all = every_index(kind);
    if (!squares.positive()) return all.upper();
    std::array<Row, leg_count> rows;
    for (std::size_t j = 0; j < leg_count; ++j) rows[j] = legs.row(j, signs_[j]);
    const Interval index = of_sign(determinant_of(rows), sign) * reciprocal(square_root(squares));
    return std::min(index.upper(), all.upper());
  }

  const BoxIntervals<Chart>& box_;
  Signs signs_;
  std::optional<std::size_t> leg_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_INDEX_ON_ARCS_H
