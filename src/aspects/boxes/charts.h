// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_CHARTS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_CHARTS_H

#include "aspects/boxes/chart_legs.h"
#include "aspects/tree/pose_space.h"
#include "interval/half_turns.h"
#include "legs/leg_rows.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <optional>

// A chart turns the map coordinates of one task space into the rows of A. Each has
//  - leg_count, which is the number of degrees of freedom, and coordinate_count, of the map;
//  - Placement<Scalar>: the pose as its legs need it, made by place(root, coordinates) once for all legs;
//  - displacement(j, placement): d = p - base point of leg j;
//  - form(j, displacement) of leg j, and rows(j, form, displacement, placement) of A;
//  - rod_on_arc(j, displacement, turn, sign of B_jj): see SpatialLeg; asked for cranks alone;
//  - squared_rod(j, displacement) and scale(j, displacement): see PlanarLeg; the first is asked for only
//  where
//    the platform does not turn;
//  - limits(j, displacement, |B_jj|, sign of B_jj): of the actuated joint, see LimitFunctions;
//  - point_dimension: of its points, 2 or 3;
//  - link_points(j, displacement, |B_jj|, sign of B_jj): see LinkPoints;
//  - anchor(j, displacement);
//  - position(placement): of the operational point;
//  - turned(direction, placement): a direction that is fixed in the platform, with constant entries;
//  - reachable_positions(): see BoxClassifier.
// A whole task space could be mapped as the slice that holds nothing (see slice_chart.h). Charts of their own
// are faster: see PlanarLeg for the plane; the linear Delta takes 1.1 times as long as a slice.
//
// Scalar is Interval, Affine<coordinate_count> or Dual<coordinate_count, Affine<coordinate_count>>. All of it
// needs a live `RoundingUpward`.

namespace parallel_aspects {

/// T1: x. The leg is in the x-y plane.
class T1Chart : public PlanarLegs {
 public:
  static constexpr std::size_t leg_count = 1, coordinate_count = 1;
  template <class Scalar>
  using Placement = Scalar;
  template <class Scalar>
  using Displacement = Planar<Scalar>;

  explicit T1Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, coordinate_count>& x) const {
    return x[0];
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t, const Placement<Scalar>& position) const {
    return {position + Scalar(offset_.x), Scalar(offset_.y)};
  }

  template <class Scalar>
  LegRows<Scalar, leg_count> rows(std::size_t, const PlanarLegForm<Scalar>& form, const Displacement<Scalar>&,
                                  const Placement<Scalar>&) const {
    return leg_rows<TaskSpace::T1>(form);
  }

  template <class Scalar>
  Point<Scalar, point_dimension> position(const Placement<Scalar>& position) const {
    return {position, Scalar(0.0)};
  }

  template <class Scalar>
  Point<Scalar, point_dimension> turned(const Point<Interval, point_dimension>& direction,
                                        const Placement<Scalar>&) const {
    return constant<Scalar>(direction);
  }

  std::optional<Box> reachable_positions() const;

 private:
  Planar<Interval> offset_;                 // d = position + offset
  std::optional<PrismaticActuation> rail_;  // bounds x even without limits
  Interval rod_length_;
};

/// T2: x, y.
class T2Chart : public PlanarLegs {
 public:
  static constexpr std::size_t leg_count = 2, coordinate_count = 2;
  template <class Scalar>
  using Displacement = Planar<Scalar>;
  template <class Scalar>
  using Placement = Planar<Scalar>;

  explicit T2Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, coordinate_count>& x) const {
    return {x[0], x[1]};
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& position) const {
    return {position.x + Scalar(offsets_[j].x), position.y + Scalar(offsets_[j].y)};
  }

  template <class Scalar>
  LegRows<Scalar, leg_count> rows(std::size_t, const PlanarLegForm<Scalar>& form, const Displacement<Scalar>&,
                                  const Placement<Scalar>&) const {
    return leg_rows<TaskSpace::T2>(form);
  }

  template <class Scalar>
  Point<Scalar, point_dimension> position(const Placement<Scalar>& position) const {
    return {position.x, position.y};
  }

  template <class Scalar>
  Point<Scalar, point_dimension> turned(const Point<Interval, point_dimension>& direction,
                                        const Placement<Scalar>&) const {
    return constant<Scalar>(direction);
  }

  std::optional<Box> reachable_positions() const;

 private:
  std::array<Planar<Interval>, leg_count> offsets_;  // d = position + offset
};

template <class Scalar>
Planar<Scalar> turned_by(const Turn<Scalar>& turn, const Planar<Interval>& b) {
  return {b.x * turn.cosine - b.y * turn.sine, b.x * turn.sine + b.y * turn.cosine};
}

/// SE2: x, y and phi / pi.
class SE2Chart : public PlanarLegs {
 public:
  static constexpr std::size_t leg_count = 3, coordinate_count = 3;
  template <class Scalar>
  using Displacement = Planar<Scalar>;
  template <class Scalar>
  struct Placement {
    Planar<Scalar> position;
    Turn<Scalar> turn;
  };

  explicit SE2Chart(const Manipulator& manipulator);

  std::optional<double> crank_that_folds(std::size_t j) const noexcept { return leg(j).crank_that_folds(); }

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, coordinate_count>& x) const {
    return {{x[0], x[1]}, turn_of_half_turns(x[2])};
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& at) const {
    const Planar<Scalar> b = turned_by(at.turn, anchors_[j]);
    const Planar<Interval>& base = leg(j).base();
    return {at.position.x + b.x - Scalar(base.x), at.position.y + b.y - Scalar(base.y)};
  }

  template <class Scalar>
  LegRows<Scalar, leg_count> rows(std::size_t j, const PlanarLegForm<Scalar>& form,
                                  const Displacement<Scalar>&, const Placement<Scalar>& at) const {
    return leg_rows<TaskSpace::SE2>(form, turned_by(at.turn, anchors_[j]));
  }

  template <class Scalar>
  Point<Scalar, point_dimension> position(const Placement<Scalar>& at) const {
    return {at.position.x, at.position.y};
  }

  template <class Scalar>
  Point<Scalar, point_dimension> turned(const Point<Interval, point_dimension>& direction,
                                        const Placement<Scalar>& at) const {
    const Planar<Scalar> result = turned_by(at.turn, {direction[0], direction[1]});
    return {result.x, result.y};
  }

  std::optional<Box> reachable_positions() const;

 private:
  std::array<Planar<Interval>, leg_count> anchors_;
};

/// T3: x, y, z.
class T3Chart : public SpatialLegs {
 public:
  static constexpr std::size_t leg_count = 3, coordinate_count = 3;
  template <class Scalar>
  using Placement = Spatial<Scalar>;
  template <class Scalar>
  using Displacement = Spatial<Scalar>;

  explicit T3Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, coordinate_count>& x) const {
    return x;
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& position) const {
    const Spatial<Interval>& offset = offsets_[j];
    return {position[0] + Scalar(offset[0]), position[1] + Scalar(offset[1]),
            position[2] + Scalar(offset[2])};
  }

  template <class Scalar>
  LegRows<Scalar, leg_count> rows(std::size_t, const SpatialLegForm<Scalar>& form,
                                  const Displacement<Scalar>&, const Placement<Scalar>&) const {
    return leg_rows<TaskSpace::T3>(form);
  }

  template <class Scalar>
  Point<Scalar, point_dimension> position(const Placement<Scalar>& position) const {
    return position;
  }

  template <class Scalar>
  Point<Scalar, point_dimension> turned(const Point<Interval, point_dimension>& direction,
                                        const Placement<Scalar>&) const {
    return constant<Scalar>(direction);
  }

  std::optional<Box> reachable_positions() const;

 private:
  std::array<Spatial<Interval>, leg_count> offsets_;  // d = position + offset
};

/// SO3: three components of the quaternion over its largest.
class SO3Chart : public SpatialLegs {
 public:
  static constexpr std::size_t leg_count = 3, coordinate_count = 3;
  template <class Scalar>
  using Placement = RotationRows<Scalar>;
  template <class Scalar>
  using Displacement = AnchorDisplacement<Scalar>;

  explicit SO3Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex root, const std::array<Scalar, coordinate_count>& x) const {
    return rotation_of_cube(root, x);
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& rotation) const {
    const Spatial<Interval>&anchor = anchors_[j], &base = leg(j).base();
    Displacement<Scalar> d;
    for (std::size_t i = 0; i < 3; ++i) {
      d.anchor[i] = dot(anchor, rotation[i]);
      d.from_base[i] = d.anchor[i] - Scalar(base[i]);
    }
    return d;
  }

  template <class Scalar>
  LegRows<Scalar, leg_count> rows(std::size_t, const SpatialLegForm<Scalar>& form,
                                  const Displacement<Scalar>& d, const Placement<Scalar>&) const {
    return leg_rows<TaskSpace::SO3>(form, d.anchor);
  }

  template <class Scalar>
  Point<Scalar, point_dimension> position(const Placement<Scalar>&) const {
    return {Scalar(0.0), Scalar(0.0), Scalar(0.0)};
  }

  template <class Scalar>
  Point<Scalar, point_dimension> turned(const Point<Interval, point_dimension>& direction,
                                        const Placement<Scalar>& rotation) const {
    return {dot(direction, rotation[0]), dot(direction, rotation[1]), dot(direction, rotation[2])};
  }

  /// Rotations need no bounds.
  std::optional<Box> reachable_positions() const { return Box{}; }

 private:
  std::array<Spatial<Interval>, leg_count> anchors_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_CHARTS_H
