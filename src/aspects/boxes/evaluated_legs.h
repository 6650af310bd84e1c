// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_EVALUATED_LEGS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_EVALUATED_LEGS_H

#include "aspects/tree/pose_space.h"
#include "legs/leg_rows.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/vectors.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// The legs of a chart (see charts.h) over one kind of enclosures, and what follows from them.
template <class Chart, class Scalar>
struct EvaluatedLegs {
  static constexpr std::size_t leg_count = Chart::leg_count, point_dimension = Chart::point_dimension;
  using Points = Point<Scalar, point_dimension>;

  struct EvaluatedLeg {
    typename Chart::template Displacement<Scalar> displacement;
    LegRows<Scalar, leg_count> rows;
  };
  struct MaybeLinks {
    bool asked = false;
    std::optional<LinkPoints<Scalar, point_dimension>> points;
  };

  typename Chart::template Placement<Scalar> placement;
  std::array<EvaluatedLeg, leg_count> legs;
  std::array<Scalar, leg_count> entries;  // |B_jj|
  std::array<BranchRows<Scalar, leg_count>, leg_count> rows;
  std::optional<Determinants<Scalar, leg_count>> determinants;
  mutable std::array<std::array<MaybeLinks, 2>, leg_count> links;  // by leg and branch, where asked for

  void place(const Chart& chart, RootIndex root, const std::array<Scalar, Chart::coordinate_count>& at) {
    placement = chart.place(root, at);
    for (std::size_t j = 0; j < leg_count; ++j) {
      legs[j].displacement = chart.displacement(j, placement);
      legs[j].rows = chart.rows(j, legs[j].displacement, placement);
    }
  }

  /// Needs the entries.
  void combine() {
    for (std::size_t j = 0; j < leg_count; ++j) rows[j] = branch_rows(legs[j].rows, entries[j]);
    determinants.emplace(rows);
  }
};

/// Where the links and the platform are; see ConstraintVerdicts.
template <class Chart, class Scalar>
class EvaluatedLinks {
 public:
  using Legs = EvaluatedLegs<Chart, Scalar>;

  EvaluatedLinks(const Chart& chart, const Legs& legs) : chart_(chart), legs_(legs) {}

  /// Null where they are not known.
  const LinkPoints<Scalar, Chart::point_dimension>* points(std::size_t j, int sign) const {
    typename Legs::MaybeLinks& links = legs_.links[j][sign > 0 ? 1 : 0];
    if (!links.asked)
      links = {true, chart_.link_points(j, legs_.legs[j].displacement, legs_.entries[j], sign)};
    return links.points ? &*links.points : nullptr;
  }

  typename Legs::Points position() const { return chart_.position(legs_.placement); }
  Point<Scalar, 2> heading() const { return chart_.heading(legs_.placement); }

  std::array<typename Legs::Points, max_legs> anchors() const {
    std::array<typename Legs::Points, max_legs> result;
    for (std::size_t j = 0; j < Chart::leg_count; ++j)
      result[j] = chart_.anchor(j, legs_.legs[j].displacement);
    return result;
  }

 private:
  const Chart& chart_;
  const Legs& legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_EVALUATED_LEGS_H
