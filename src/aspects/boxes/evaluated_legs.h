// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_EVALUATED_LEGS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_EVALUATED_LEGS_H

#include "aspects/tree/pose_space.h"
#include "legs/leg_rows.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// The legs of a chart (see charts.h) over one kind of enclosures, as far as the poses alone show.
template <class Chart, class Scalar>
struct PlacedLegs {
  static constexpr std::size_t leg_count = Chart::leg_count;

  struct PlacedLeg {
    typename Chart::template Displacement<Scalar> displacement;
    LegRows<Scalar, leg_count> rows;
  };

  typename Chart::template Placement<Scalar> placement;
  std::array<PlacedLeg, leg_count> legs;

  PlacedLegs(const Chart& chart, RootIndex root, const std::array<Scalar, Chart::coordinate_count>& at)
      : placement(chart.place(root, at)) {
    for (std::size_t j = 0; j < leg_count; ++j) {
      legs[j].displacement = chart.displacement(j, placement);
      legs[j].rows = chart.rows(j, chart.form(j, legs[j].displacement), legs[j].displacement, placement);
    }
  }

  const Scalar& squared_b_entry(std::size_t j) const { return legs[j].rows.squared_b_entry; }
};

/// The same legs with their |B_jj|: rows of A, det A and where the links are, in every working mode.
template <class Chart, class Scalar>
class EvaluatedLegs {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count, point_dimension = Chart::point_dimension;
  using Signs = std::array<int, leg_count>;
  using Entries = std::array<Scalar, leg_count>;
  using Rows = std::array<BranchRows<Scalar, leg_count>, leg_count>;
  using Points = Point<Scalar, point_dimension>;
  using Links = LinkPoints<Scalar, point_dimension>;

  EvaluatedLegs(const Chart& chart, const PlacedLegs<Chart, Scalar>& placed, const Entries& entries)
      : chart_(chart), placed_(placed), entries_(entries), determinants_(rows_) {
    for (std::size_t j = 0; j < leg_count; ++j) rows_[j] = branch_rows(placed.legs[j].rows, entries_[j]);
  }
  EvaluatedLegs(const EvaluatedLegs&) = delete;
  EvaluatedLegs& operator=(const EvaluatedLegs&) = delete;

  const Scalar& entry(std::size_t j) const { return entries_[j]; }
  const Rows& rows() const { return rows_; }
  const Scalar& determinant(const Signs& signs) const {
    std::size_t mode = 0;
    for (const int sign : signs) mode = 2 * mode + (sign > 0 ? 1 : 0);
    std::optional<Scalar>& found = found_[mode];
    if (!found) found = determinants_.of(signs);
    return *found;
  }

  /// Of A, up to a positive factor.
  const Row<Scalar, leg_count>& row(std::size_t j, int sign) const { return rows_[j].of(sign); }

  /// See the charts.
  Scalar squared_rod(std::size_t j) const { return chart_.squared_rod(j, placed_.legs[j].displacement); }
  Scalar scale(std::size_t j) const { return chart_.scale(j, placed_.legs[j].displacement); }

  /// Where the links of a leg are; null where that is not known.
  const Links* points(std::size_t j, int sign) const {
    MaybeLinks& links = links_[j][sign > 0 ? 1 : 0];
    if (!links.asked) links = {true, chart_.link_points(j, placed_.legs[j].displacement, entries_[j], sign)};
    return links.points ? &*links.points : nullptr;
  }

  Points position() const { return chart_.position(placed_.placement); }

  /// A direction that is fixed in the platform.
  Points turned(const Point<Interval, point_dimension>& direction) const {
    return chart_.turned(direction, placed_.placement);
  }

  std::array<Points, max_legs> anchors() const {
    std::array<Points, max_legs> result;
    for (std::size_t j = 0; j < leg_count; ++j) result[j] = chart_.anchor(j, placed_.legs[j].displacement);
    return result;
  }

 private:
  struct MaybeLinks {
    bool asked = false;
    std::optional<Links> points;
  };

  const Chart& chart_;
  const PlacedLegs<Chart, Scalar>& placed_;
  Entries entries_;
  Rows rows_;
  // Found where they are asked for first, and kept.
  mutable Determinants<Scalar, leg_count> determinants_;
  mutable std::array<std::optional<Scalar>, std::size_t{1} << leg_count> found_;  // of determinants, by mode
  mutable std::array<std::array<MaybeLinks, 2>, leg_count> links_;                // by leg and branch
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_EVALUATED_LEGS_H
