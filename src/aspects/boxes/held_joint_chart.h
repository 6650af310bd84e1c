// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_HELD_JOINT_CHART_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_HELD_JOINT_CHART_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/charts.h"
#include "legs/held_leg.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <memory>
#include <vector>

namespace parallel_aspects {

/// SE2 with an actuated joint held (see charts.h): the direction of the rod of its leg about the proximal
/// point c, and phi, both in half turns. So the row of this leg is known but for its direction, and its
/// equation holds on the whole box. Its displacement is u = p - c; those of other legs are from their base
/// points. Its limits are what the sign of its B_jj asks for, see HeldLeg.
class HeldJointChart : public PlanarLegs {
 public:
  static constexpr std::size_t leg_count = 3, coordinate_count = 2;
  template <class Scalar>
  struct Placement {
    Planar<Scalar> rod;
    Turn<Scalar> turn;
  };
  template <class Scalar>
  using Displacement = Planar<Scalar>;

  /// Of a slice that holds a joint, see `find_slice_problem`.
  HeldJointChart(const Manipulator& manipulator, const MapSlice& slice);

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, coordinate_count>& x) const {
    return {held_leg_.rod(turn_of_half_turns(x[0])), turn_of_half_turns(x[1])};
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& at) const {
    if (j == held_) return at.rod;
    const Planar<Scalar> between = turned_by(at.turn, from_held_anchor_[j]);
    return {at.rod.x + (between.x + Scalar(from_base_[j].x)),
            at.rod.y + (between.y + Scalar(from_base_[j].y))};
  }

  template <class Scalar>
  PlanarLegForm<Scalar> form(std::size_t j, const Displacement<Scalar>& d) const {
    return j == held_ ? held_leg_.form(d) : PlanarLegs::form(j, d);
  }

  template <class Scalar>
  LegRows<Scalar, leg_count> rows(std::size_t j, const PlanarLegForm<Scalar>& form,
                                  const Displacement<Scalar>&, const Placement<Scalar>& at) const {
    return leg_rows<TaskSpace::SE2>(form, turned_by(at.turn, anchors_[j]));
  }

  template <class Scalar>
  Scalar squared_rod(std::size_t j, const Displacement<Scalar>& d) const {
    return j == held_ ? squared_norm(d) : PlanarLegs::squared_rod(j, d);
  }

  template <class Scalar>
  Scalar scale(std::size_t j, const Displacement<Scalar>& d) const {
    return j == held_ ? Scalar(1.0) : PlanarLegs::scale(j, d);
  }

  template <class Scalar>
  LimitFunctions<Scalar> limits(std::size_t j, const Displacement<Scalar>& d, const Scalar& entry,
                                int sign) const {
    return j == held_ ? held_leg_.branch(d, sign) : PlanarLegs::limits(j, d, entry, sign);
  }

  template <class Scalar>
  std::optional<LinkPoints<Scalar, point_dimension>> link_points(std::size_t j, const Displacement<Scalar>& d,
                                                                 const Scalar& entry, int sign) const {
    if (j == held_) return held_leg_.link_points(d);
    return PlanarLegs::link_points(j, d, entry, sign);
  }

  template <class Scalar>
  Point<Scalar, point_dimension> anchor(std::size_t j, const Displacement<Scalar>& d) const {
    if (j != held_) return PlanarLegs::anchor(j, d);
    return {d.x + Scalar(held_leg_.center().x), d.y + Scalar(held_leg_.center().y)};
  }

  template <class Scalar>
  Point<Scalar, point_dimension> position(const Placement<Scalar>& at) const {
    const Planar<Scalar> b = turned_by(at.turn, anchors_[held_]);
    return {at.rod.x + (Scalar(held_leg_.center().x) - b.x), at.rod.y + (Scalar(held_leg_.center().y) - b.y)};
  }

  template <class Scalar>
  Point<Scalar, point_dimension> turned(const Point<Interval, point_dimension>& direction,
                                        const Placement<Scalar>& at) const {
    const Planar<Scalar> result = turned_by(at.turn, {direction[0], direction[1]});
    return {result.x, result.y};
  }

  /// Directions need no bounds.
  std::optional<Box> reachable_positions() const { return Box{}; }

 private:
  std::size_t held_;
  HeldLeg held_leg_;
  std::array<Planar<Interval>, leg_count> anchors_;
  std::array<Planar<Interval>, leg_count> from_held_anchor_;  // anchor - that of the held leg
  std::array<Planar<Interval>, leg_count> from_base_;         // c of the held leg - base point
};

/// The classifier for a slice that holds a joint (see `find_slice_problem`), in the coordinates of
/// `make_held_joint_space`.
std::unique_ptr<const BoxClassifier> make_held_joint_classifier(const Manipulator& manipulator,
                                                                const std::vector<WorkingMode>& modes,
                                                                const MapSlice& slice,
                                                                const BoxPolicy& policy);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_HELD_JOINT_CHART_H
