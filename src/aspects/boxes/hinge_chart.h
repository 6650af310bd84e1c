// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_HINGE_CHART_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_HINGE_CHART_H

#include "aspects/boxes/chart_legs.h"
#include "legs/hinges.h"
#include "legs/leg_rows.h"
#include "legs/toleranced.h"

#include <array>
#include <optional>

namespace parallel_aspects {

/// R1 and R2 (see charts.h): the angles of the hinges in half turns.
template <TaskSpace space>
class HingeChart : public SpatialLegs {
 public:
  static constexpr std::size_t leg_count = traits(space).degrees_of_freedom(), coordinate_count = leg_count;
  template <class Scalar>
  using Placement = HingePlacement<Scalar>;
  template <class Scalar>
  using Displacement = AnchorDisplacement<Scalar>;

  explicit HingeChart(const Manipulator& manipulator)
      : SpatialLegs(manipulator), hinges_(manipulator.motions().hinges) {
    for (std::size_t j = 0; j < leg_count; ++j) anchors_[j] = toleranced_anchor(manipulator.leg(j));
  }

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, coordinate_count>& x) const {
    if constexpr (leg_count == 1)
      return placed_by_hinge<Scalar>(turn_of_half_turns(x[0]));
    else
      return hinges_.placed<Scalar>(turn_of_half_turns(x[0]), turn_of_half_turns(x[1]));
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& at) const {
    const Spatial<Interval>&anchor = anchors_[j], &base = leg(j).base();
    Displacement<Scalar> d;
    for (std::size_t i = 0; i < 3; ++i) {
      d.anchor[i] = dot(anchor, at.rotation[i]);
      d.from_base[i] = at.position[i] + (d.anchor[i] - Scalar(base[i]));
    }
    return d;
  }

  template <class Scalar>
  LegRows<Scalar, leg_count> rows(std::size_t, const SpatialLegForm<Scalar>& form,
                                  const Displacement<Scalar>& d, const Placement<Scalar>& at) const {
    if constexpr (leg_count == 1) {
      return leg_rows<space>(form, d.anchor);
    } else {
      Lever<Spatial<Scalar>> lever{d.anchor, {}, at.axis()};
      for (std::size_t i = 0; i < 3; ++i) lever.point[i] = at.position[i] + d.anchor[i];
      return leg_rows<space>(form, lever);
    }
  }

  template <class Scalar>
  Point<Scalar, point_dimension> position(const Placement<Scalar>& at) const {
    return at.position;
  }

  template <class Scalar>
  Point<Scalar, point_dimension> turned(const Point<Interval, point_dimension>& direction,
                                        const Placement<Scalar>& at) const {
    return {dot(direction, at.rotation[0]), dot(direction, at.rotation[1]), dot(direction, at.rotation[2])};
  }

  /// Angles need no bounds.
  std::optional<Box> reachable_positions() const { return Box{}; }

 private:
  EnclosedHinges hinges_;
  std::array<Spatial<Interval>, leg_count> anchors_;
};

using R1Chart = HingeChart<TaskSpace::R1>;
using R2Chart = HingeChart<TaskSpace::R2>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_HINGE_CHART_H
