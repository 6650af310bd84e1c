// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CHARTS_H
#define PARALLEL_ASPECTS_ASPECTS_CHARTS_H

#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/half_turns.h"
#include "parallel_aspects/aspects/leg_rows.h"
#include "parallel_aspects/aspects/planar_leg.h"
#include "parallel_aspects/aspects/pose_space.h"
#include "parallel_aspects/aspects/spatial_leg.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <optional>
#include <vector>

// A chart turns the map coordinates of one task space into the rows of A. Each has
//  - size: legs, freedoms and coordinates, all the same number;
//  - Placement<Scalar>: the pose as its legs need it, made by place(root, coordinates) once for all legs;
//  - displacement(j, placement): d = p - base point of leg j;
//  - rows(j, displacement, placement);
//  - limits(j, displacement, |B_jj|, sign of B_jj): of the drive, see LimitFunctions;
//  - reachable_positions(): see BoxClassifier.
// Scalar is Interval, Affine<size> or Dual<size, Affine<size>>. All of it needs a live `RoundingUpward`.

namespace parallel_aspects {

/// T1: x. The leg is in the x-y plane.
class T1Chart {
 public:
  static constexpr std::size_t size = 1;
  template <class Scalar>
  using Placement = Scalar;
  template <class Scalar>
  using Displacement = Planar<Scalar>;

  explicit T1Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, size>& x) const {
    return x[0];
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t, const Placement<Scalar>& position) const {
    return {position + Scalar(offset_.x), Scalar(offset_.y)};
  }

  template <class Scalar>
  LegRows<Scalar, size> rows(std::size_t, const Displacement<Scalar>& d, const Placement<Scalar>&) const {
    const PlanarLegForm<Scalar> form = leg_.form(d);
    return {form.squared_entry, {form.fixed.x}, {form.turned.x}};
  }

  template <class Scalar>
  LimitFunctions<Scalar> limits(std::size_t, const Displacement<Scalar>& d, const Scalar& entry,
                                int sign) const {
    return leg_.limits(d, entry, sign);
  }

  std::optional<Box> reachable_positions() const;

 private:
  PlanarLeg leg_;
  Planar<Interval> offset_;   // d = position + offset
  std::optional<Leg> slide_;  // a leg on a prismatic drive, which bounds x even without limits
};

/// T2: x, y.
class T2Chart {
 public:
  static constexpr std::size_t size = 2;
  template <class Scalar>
  using Placement = Planar<Scalar>;
  template <class Scalar>
  using Displacement = Planar<Scalar>;

  explicit T2Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, size>& x) const {
    return {x[0], x[1]};
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& position) const {
    return {position.x + Scalar(offsets_[j].x), position.y + Scalar(offsets_[j].y)};
  }

  template <class Scalar>
  LegRows<Scalar, size> rows(std::size_t j, const Displacement<Scalar>& d, const Placement<Scalar>&) const {
    const PlanarLegForm<Scalar> form = legs_[j].form(d);
    return {form.squared_entry, {form.fixed.x, form.fixed.y}, {form.turned.x, form.turned.y}};
  }

  template <class Scalar>
  LimitFunctions<Scalar> limits(std::size_t j, const Displacement<Scalar>& d, const Scalar& entry,
                                int sign) const {
    return legs_[j].limits(d, entry, sign);
  }

  std::optional<Box> reachable_positions() const;

 private:
  std::vector<PlanarLeg> legs_;
  std::array<Planar<Interval>, size> offsets_;  // d = position + offset
};

/// SE2: x, y and phi / pi.
class SE2Chart {
 public:
  static constexpr std::size_t size = 3;
  template <class Scalar>
  struct Placement {
    Planar<Scalar> position;
    Turn<Scalar> turn;

    Planar<Scalar> turned(const Planar<Interval>& b) const {
      return {b.x * turn.cosine - b.y * turn.sine, b.x * turn.sine + b.y * turn.cosine};
    }
  };
  template <class Scalar>
  using Displacement = Planar<Scalar>;

  explicit SE2Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, size>& x) const {
    return {{x[0], x[1]}, turn_of_half_turns(x[2])};
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& at) const {
    const Planar<Scalar> b = at.turned(anchors_[j]);
    const Planar<Interval>& base = legs_[j].base();
    return {at.position.x + b.x - Scalar(base.x), at.position.y + b.y - Scalar(base.y)};
  }

  template <class Scalar>
  LegRows<Scalar, size> rows(std::size_t j, const Displacement<Scalar>& d,
                             const Placement<Scalar>& at) const {
    const PlanarLegForm<Scalar> form = legs_[j].form(d);
    const Planar<Scalar> b = at.turned(anchors_[j]);
    return {form.squared_entry,
            {cross(b, form.fixed), form.fixed.x, form.fixed.y},
            {cross(b, form.turned), form.turned.x, form.turned.y}};
  }

  template <class Scalar>
  LimitFunctions<Scalar> limits(std::size_t j, const Displacement<Scalar>& d, const Scalar& entry,
                                int sign) const {
    return legs_[j].limits(d, entry, sign);
  }

  std::optional<Box> reachable_positions() const;

 private:
  std::vector<PlanarLeg> legs_;
  std::array<Planar<Interval>, size> anchors_;
};

/// T3: x, y, z.
class T3Chart {
 public:
  static constexpr std::size_t size = 3;
  template <class Scalar>
  using Placement = Spatial<Scalar>;
  template <class Scalar>
  using Displacement = Spatial<Scalar>;

  explicit T3Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex, const std::array<Scalar, size>& x) const {
    return x;
  }

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& position) const {
    const Spatial<Interval>& offset = offsets_[j];
    return {position[0] + Scalar(offset[0]), position[1] + Scalar(offset[1]),
            position[2] + Scalar(offset[2])};
  }

  template <class Scalar>
  LegRows<Scalar, size> rows(std::size_t j, const Displacement<Scalar>& d, const Placement<Scalar>&) const {
    const SpatialLegForm<Scalar> form = legs_[j].form(d);
    return {form.squared_entry, form.fixed, form.turned};
  }

  template <class Scalar>
  LimitFunctions<Scalar> limits(std::size_t j, const Displacement<Scalar>& d, const Scalar& entry,
                                int sign) const {
    return legs_[j].limits(d, entry, sign);
  }

  std::optional<Box> reachable_positions() const;

 private:
  std::vector<SpatialLeg> legs_;
  std::array<Spatial<Interval>, size> offsets_;  // d = position + offset
};

/// SO3: three components of the quaternion over its largest.
class SO3Chart {
 public:
  static constexpr std::size_t size = 3;
  template <class Scalar>
  using Placement = std::array<Spatial<Scalar>, 3>;  // rows of the rotation matrix
  template <class Scalar>
  struct Displacement {
    Spatial<Scalar> from_base, anchor;
  };

  explicit SO3Chart(const Manipulator& manipulator);

  template <class Scalar>
  Placement<Scalar> place(RootIndex root, const std::array<Scalar, size>& x) const;

  template <class Scalar>
  Displacement<Scalar> displacement(std::size_t j, const Placement<Scalar>& rotation) const {
    const Spatial<Interval>&anchor = anchors_[j], &base = legs_[j].base();
    Displacement<Scalar> d;
    for (std::size_t i = 0; i < 3; ++i) {
      d.anchor[i] = dot(anchor, rotation[i]);
      d.from_base[i] = d.anchor[i] - Scalar(base[i]);
    }
    return d;
  }

  template <class Scalar>
  LegRows<Scalar, size> rows(std::size_t j, const Displacement<Scalar>& d, const Placement<Scalar>&) const {
    const SpatialLegForm<Scalar> form = legs_[j].form(d.from_base);
    return {form.squared_entry, cross(d.anchor, form.fixed), cross(d.anchor, form.turned)};
  }

  template <class Scalar>
  LimitFunctions<Scalar> limits(std::size_t j, const Displacement<Scalar>& d, const Scalar& entry,
                                int sign) const {
    return legs_[j].limits(d.from_base, entry, sign);
  }

  /// Rotations need no bounds.
  std::optional<Box> reachable_positions() const { return Box{}; }

 private:
  std::vector<SpatialLeg> legs_;
  std::array<Spatial<Interval>, size> anchors_;
};

template <class Scalar>
SO3Chart::Placement<Scalar> SO3Chart::place(RootIndex root, const std::array<Scalar, size>& a) const {
  // The quaternion with its largest component 1: every product of two components, over the squared norm.
  std::array<Scalar, 4> q;
  for (std::size_t component = 0, i = 0; component < 4; ++component)
    q[component] = component == root ? Scalar(1.0) : a[i++];
  const Interval two(2.0);
  const Scalar xx = square(q[0]), yy = square(q[1]), zz = square(q[2]), ww = square(q[3]);
  const Scalar xy = two * (q[0] * q[1]), xz = two * (q[0] * q[2]), yz = two * (q[1] * q[2]);
  const Scalar wx = two * (q[3] * q[0]), wy = two * (q[3] * q[1]), wz = two * (q[3] * q[2]);
  const Scalar scale = reciprocal(xx + yy + zz + ww, 1.0);
  return {{{scale * ((ww + xx) - (yy + zz)), scale * (xy - wz), scale * (xz + wy)},
           {scale * (xy + wz), scale * ((ww + yy) - (xx + zz)), scale * (yz - wx)},
           {scale * (xz - wy), scale * (yz + wx), scale * ((ww + zz) - (xx + yy))}}};
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CHARTS_H
