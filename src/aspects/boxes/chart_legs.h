// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_LEGS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_LEGS_H

#include "aspects/tree/pose_space.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "interval/rotation_rows.h"
#include "legs/planar_leg.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// The rotation at the coordinates `a` of a cube of SO3 (see PoseSpace): of the quaternion with its largest
/// component 1.
template <class Scalar>
RotationRows<Scalar> rotation_of_cube(RootIndex root, const std::array<Scalar, 3>& a) {
  std::array<Scalar, 4> q;
  for (std::size_t component = 0, i = 0; component < 4; ++component)
    q[component] = component == root ? Scalar(1.0) : a[i++];
  const QuaternionRotation<Scalar> rotation(q);
  return rotation.rows(reciprocal(rotation.squared_norm(), 1.0));
}

/// The positions within reach of every leg; each leg allows positions that are at most `reach` from `center`.
class ReachableBox {
 public:
  explicit ReachableBox(std::size_t dimension) : box_{dimension, {}, {}} {
    box_.lower.fill(-HUGE_VAL);
    box_.upper.fill(HUGE_VAL);
  }

  /// Along coordinate i. An infinite reach is no restriction. Needs a live `RoundingUpward`.
  void restrict(std::size_t i, const Interval& center, double reach) {
    assert_rounding_upward();
    if (!std::isfinite(reach)) return;
    // Reaches are rounded sums of lengths.
    const Interval range = center + Interval(1.0 + 1e-12) * Interval(-reach, reach);
    box_.lower[i] = std::max(box_.lower[i], range.lower());
    box_.upper[i] = std::min(box_.upper[i], range.upper());
  }

  /// Nothing where some coordinate is not bounded.
  std::optional<Box> box() const {
    for (std::size_t i = 0; i < box_.dimension; ++i)
      if (!std::isfinite(box_.width(i))) return std::nullopt;
    return box_;
  }

 private:
  Box box_;
};

/// An anchor seen from the leg's base point and from the operational point.
template <class Scalar>
struct AnchorDisplacement {
  Spatial<Scalar> from_base, anchor;
};

template <class Displacement>
const Displacement& from_base(const Displacement& d) {
  return d;
}

template <class Scalar>
const Spatial<Scalar>& from_base(const AnchorDisplacement<Scalar>& d) {
  return d.from_base;
}

/// The legs of a chart, and what every chart asks of them in the same way (see charts.h). A displacement is
/// the vector from the leg's base point to its anchor, or holds it.
template <class OneLeg, std::size_t Dimension>
class ChartLegs {
 public:
  static constexpr std::size_t point_dimension = Dimension;

  template <class Displacement>
  auto form(std::size_t j, const Displacement& d) const {
    return legs_[j].form(from_base(d));
  }

  template <class Displacement>
  auto rod_on_arc(std::size_t j, const Displacement& d, const Turn<Interval>& turn, int sign) const {
    return legs_[j].rod_on_arc(from_base(d), turn, sign);
  }

  template <class Displacement>
  auto squared_rod(std::size_t j, const Displacement& d) const {
    return legs_[j].squared_rod(from_base(d));
  }

  template <class Displacement>
  auto scale(std::size_t j, const Displacement& d) const {
    return legs_[j].scale(from_base(d));
  }

  template <class Displacement, class Scalar>
  LimitFunctions<Scalar> limits(std::size_t j, const Displacement& d, const Scalar& entry, int sign) const {
    return legs_[j].limits(from_base(d), entry, sign);
  }

  template <class Displacement, class Scalar>
  auto link_points(std::size_t j, const Displacement& d, const Scalar& entry, int sign) const {
    return legs_[j].link_points(from_base(d), entry, sign);
  }

  template <class Displacement>
  auto anchor(std::size_t j, const Displacement& d) const {
    using Scalar = std::decay_t<decltype(from_base(d)[0])>;
    Point<Scalar, Dimension> result;
    for (std::size_t i = 0; i < Dimension; ++i) result[i] = from_base(d)[i] + Scalar(legs_[j].base()[i]);
    return result;
  }

 protected:
  explicit ChartLegs(const Manipulator& manipulator) {
    for (const Leg& leg : manipulator.legs()) legs_.emplace_back(leg);
  }

  const OneLeg& leg(std::size_t j) const { return legs_[j]; }

 private:
  std::vector<OneLeg> legs_;
};

using PlanarLegs = ChartLegs<PlanarLeg, 2>;
using SpatialLegs = ChartLegs<SpatialLeg, 3>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_LEGS_H
