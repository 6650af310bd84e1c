// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_SLICE_CHART_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_SLICE_CHART_H

#include "aspects/boxes/chart_legs.h"
#include "interval/half_turns.h"
#include "legs/leg_rows.h"
#include "legs/toleranced.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <optional>

// Charts of slices (see charts.h). Every leg is taken in space, whatever the task space.

namespace parallel_aspects {

/// What the charts of slices have in common: legs, and rows of A from displacements. Points of planar robots,
/// which have two coordinates, leave out the third.
template <std::size_t Legs, std::size_t Coordinates, std::size_t Dimension = 3>
class SliceLegs : public ChartLegs<SpatialLeg, Dimension> {
  using Base = ChartLegs<SpatialLeg, Dimension>;

 public:
  static constexpr std::size_t leg_count = Legs, coordinate_count = Coordinates;
  template <class Scalar>
  using Displacement = AnchorDisplacement<Scalar>;

  template <class Scalar, class Placement>
  LegRows<Scalar, leg_count> rows(std::size_t, const SpatialLegForm<Scalar>& form,
                                  const Displacement<Scalar>& d, const Placement&) const {
    return with_task_space(space_, [&](auto constant) -> LegRows<Scalar, leg_count> {
      constexpr TaskSpace space = decltype(constant)::value;
      if constexpr (traits(space).degrees_of_freedom() == leg_count && !is_of_hinges(space))
        return leg_rows<space>(form, d.anchor);
      else
        return {};  // not this robot's
    });
  }

  /// Rows of planar robots hold what is in the plane. There the proximal point is as high as the base point.
  template <class Scalar>
  Scalar squared_rod(std::size_t j, const Displacement<Scalar>& d) const {
    const Scalar in_space = Base::squared_rod(j, d);
    if constexpr (Dimension == 3)
      return in_space;
    else
      return in_space - square(this->scale(j, d) * d.from_base[2]);
  }

  auto rod_on_arc(std::size_t j, const Displacement<Interval>& d, const Turn<Interval>& turn,
                  int sign) const {
    auto rod = Base::rod_on_arc(j, d, turn, sign);
    if constexpr (Dimension == 2)
      if (rod) rod->squared_length = rod->squared_length - square(d.from_base[2]);
    return rod;
  }

  template <class Scalar>
  std::optional<LinkPoints<Scalar, Dimension>> link_points(std::size_t j, const Displacement<Scalar>& d,
                                                           const Scalar& entry, int sign) const {
    const auto points = this->leg(j).link_points(d.from_base, entry, sign);
    if (!points) return std::nullopt;
    return LinkPoints<Scalar, Dimension>{reduced<Dimension>(points->base), reduced<Dimension>(points->joint),
                                         reduced<Dimension>(points->anchor), points->length};
  }

 protected:
  explicit SliceLegs(const Manipulator& manipulator) : Base(manipulator), space_(manipulator.task_space()) {}

 private:
  TaskSpace space_;
};

/// Free positions in the order of x, y and z, then the angle in half turns where there is one. An anchor that
/// turns about the unit vector a is  b = a (a.v) + cos (v - a (a.v)) + sin (a x v)  with v where it is held.
template <std::size_t Legs, std::size_t Coordinates, std::size_t Dimension = 3>
class SliceChart : public SliceLegs<Legs, Coordinates, Dimension> {
 public:
  template <class Scalar>
  struct Placement {
    Spatial<Scalar> position;
    Turn<Scalar> turn;
  };

  SliceChart(const Manipulator& manipulator, const MapSlice& slice)
      : SliceLegs<Legs, Coordinates, Dimension>(manipulator),
        slice_(slice),
        turns_(slice.rotation == MapSlice::Rotation::about_axis),
        held_(enclosed_rotation(slice.held.orientation)) {
    for (std::size_t j = 0; j < Legs; ++j) anchors_[j] = turning(toleranced_anchor(manipulator.leg(j)));
  }

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, Coordinates>& x) const {
    Placement<Scalar> at;
    std::size_t next = 0;
    for (std::size_t i = 0; i < 3; ++i)
      at.position[i] =
          slice_.moves[i] ? x[next++] : Scalar(slice_.held.position[static_cast<Eigen::Index>(i)]);
    if (turns_) at.turn = turn_of_half_turns(x[Coordinates - 1]);
    return at;
  }

  template <class Scalar>
  AnchorDisplacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& at) const {
    const Spatial<Interval>& base = this->leg(j).base();
    AnchorDisplacement<Scalar> d;
    for (std::size_t i = 0; i < 3; ++i) {
      d.anchor[i] = turned(anchors_[j], at, i);
      d.from_base[i] = at.position[i] + (d.anchor[i] - Scalar(base[i]));
    }
    return d;
  }

  template <class Scalar>
  Point<Scalar, Dimension> position(const Placement<Scalar>& at) const {
    return reduced<Dimension>(at.position);
  }

  template <class Scalar>
  Point<Scalar, Dimension> turned(const Point<Interval, Dimension>& direction,
                                  const Placement<Scalar>& at) const {
    Spatial<Interval> in_space{};
    for (std::size_t i = 0; i < Dimension; ++i) in_space[i] = direction[i];
    const Turning vector = turning(in_space);
    Point<Scalar, Dimension> result;
    for (std::size_t i = 0; i < Dimension; ++i) result[i] = turned(vector, at, i);
    return result;
  }

  std::optional<Box> reachable_positions() const {
    const RoundingUpward rounding;
    ReachableBox box(slice_.free_positions());
    for (std::size_t j = 0; j < Legs; ++j) {
      const Turning& anchor = anchors_[j];
      const double radius =
          square_root(square(anchor.across[0]) + square(anchor.across[1]) + square(anchor.across[2])).upper();
      for (std::size_t i = 0, next = 0; i < 3; ++i)
        if (slice_.moves[i])
          box.restrict(next++, this->leg(j).base()[i] - anchor.still[i], this->leg(j).reach() + radius);
    }
    return box.box();
  }

 private:
  /// A vector of the platform: what does not turn, what goes with the cosine and with the sine.
  struct Turning {
    Spatial<Interval> still, across, sideways;
  };

  template <class Scalar>
  Scalar turned(const Turning& anchor, const Placement<Scalar>& at, std::size_t i) const {
    const Scalar still(anchor.still[i]);
    return turns_ ? still + (anchor.across[i] * at.turn.cosine + anchor.sideways[i] * at.turn.sine) : still;
  }

  Turning turning(const Spatial<Interval>& in_platform) const {
    Turning vector;
    for (std::size_t i = 0; i < 3; ++i) vector.still[i] = dot(in_platform, held_[i]);
    if (!turns_) return vector;
    const Spatial<Interval> v = vector.still, a{slice_.axis.x(), slice_.axis.y(), slice_.axis.z()};
    const Interval over = reciprocal(square(a[0]) + square(a[1]) + square(a[2]));
    const Interval along = over * dot(a, v), over_length = square_root(over);
    const Spatial<Interval> side = cross(a, v);
    for (std::size_t i = 0; i < 3; ++i) {
      vector.still[i] = along * a[i];
      vector.across[i] = v[i] - vector.still[i];
      vector.sideways[i] = over_length * side[i];
    }
    return vector;
  }

  MapSlice slice_;
  bool turns_;
  RotationRows<Interval> held_;
  std::array<Turning, Legs> anchors_;
};

/// Every orientation at one position: the cubes of SO3.
class OrientationChart : public SliceLegs<6, 3> {
 public:
  template <class Scalar>
  using Placement = RotationRows<Scalar>;

  OrientationChart(const Manipulator& manipulator, const MapSlice& slice) : SliceLegs<6, 3>(manipulator) {
    for (std::size_t i = 0; i < 3; ++i) held_[i] = slice.held.position[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Eigen::Vector3d& position = slice.held.position;
      anchors_[j] = toleranced_anchor(manipulator.leg(j));
      for (std::size_t i = 0; i < 3; ++i)
        offsets_[j][i] = Interval(position[static_cast<Eigen::Index>(i)]) - leg(j).base()[i];
    }
  }

  template <class Scalar>
  Placement<Scalar> place(RootIndex root, const std::array<Scalar, coordinate_count>& x) const {
    return rotation_of_cube(root, x);
  }

  template <class Scalar>
  AnchorDisplacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& rotation) const {
    AnchorDisplacement<Scalar> d;
    for (std::size_t i = 0; i < 3; ++i) {
      d.anchor[i] = dot(anchors_[j], rotation[i]);
      d.from_base[i] = d.anchor[i] + Scalar(offsets_[j][i]);
    }
    return d;
  }

  template <class Scalar>
  Point<Scalar, 3> position(const Placement<Scalar>&) const {
    return {Scalar(held_[0]), Scalar(held_[1]), Scalar(held_[2])};
  }

  template <class Scalar>
  Point<Scalar, 3> turned(const Point<Interval, 3>& direction, const Placement<Scalar>& rotation) const {
    return {dot(direction, rotation[0]), dot(direction, rotation[1]), dot(direction, rotation[2])};
  }

  /// Rotations need no bounds.
  std::optional<Box> reachable_positions() const { return Box{}; }

 private:
  Spatial<Interval> held_;  // position
  std::array<Spatial<Interval>, leg_count> anchors_;
  std::array<Spatial<Interval>, leg_count> offsets_;  // position - base point
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_SLICE_CHART_H
