// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_LOCAL_CHART_H
#define PARALLEL_ASPECTS_DISTANCE_LOCAL_CHART_H

#include "distance/anchor_metric.h"
#include "distance/cell.h"
#include "distance/centered_leg.h"
#include "distance/point_dual.h"
#include "legs/leg_rows.h"
#include "legs/planar_leg.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace parallel_aspects {

/// The poses about one pose, in coordinates y [m] in which D = |y| (see AnchorMetric): first the displacement
/// of the centroid of the anchors along the axes of the task frame, then the rotation. Poses a half turn or
/// less away all have coordinates. Scalar is Interval, Affine or PointDual; all but the last, and
/// `move_to`, need a live `RoundingUpward`.
template <TaskSpace space>
class LocalChart {
 public:
  static constexpr bool planar = traits(space).planar;
  static constexpr std::size_t turns = traits(space).rotations, moves = traits(space).translations;
  static constexpr std::size_t size = moves + turns;
  static constexpr std::size_t dimension = planar ? 2 : 3;

  using DistanceLeg =
      std::conditional_t<planar, PlanarLeg,
                         std::conditional_t<space == TaskSpace::SE3, CenteredLeg, SpatialLeg>>;
  template <class Scalar>
  using Vector = std::array<Scalar, dimension>;
  template <class Scalar>
  using Rotation = std::array<Vector<Scalar>, dimension>;  // rows

  explicit LocalChart(const Manipulator& manipulator);

  const AnchorMetric& metric() const noexcept { return metric_; }

  /// The anchor of leg j moves about the centroid by this much at most, a metre of |r| of the rotation r.
  double turning(std::size_t j) const noexcept { return turning_[j]; }

  /// Makes `pose` the origin of the coordinates.
  void move_to(const Pose& pose) noexcept;

  /// The origin.
  const Pose& pose() const noexcept { return pose_; }

  /// Encloses the operational point.
  Vector<Interval> operational_point(const std::array<Interval, size>& y) const noexcept;

  /// The pose with these coordinates, in floating point.
  Pose pose_at(const Coordinates<size>& y) const noexcept;

  /// The twist (w, v) with which the ray towards `y` starts, a metre of the ray.
  TaskVector direction_to(const Coordinates<size>& y) const noexcept;

  /// How the coordinates change at the origin for a twist (w, v), in floating point: the inverse of
  /// `direction_to`.
  Coordinates<size> rate_of(const TaskVector& twist) const noexcept;

  /// From the operational point to the centroid of the anchors, in floating point, task frame [m].
  const Eigen::Vector3d& center_at_pose() const noexcept { return center_at_pose_; }

  /// The rotation of these coordinates.
  template <class Scalar>
  Rotation<Scalar> rotation(const Scalar* turn) const noexcept;

  /// b_j, turned.
  template <class Scalar>
  Vector<Scalar> arm(std::size_t j, const Rotation<Scalar>& rotation) const noexcept;

  /// The anchor less the base point of leg j, as far as the rotation decides.
  template <class Scalar>
  Vector<Scalar> turned_displacement(std::size_t j, const Vector<Scalar>& arm) const noexcept {
    Vector<Scalar> d;
    for (std::size_t i = 0; i < dimension; ++i) {
      if constexpr (turns == 0)
        d[i] = Scalar(displacements_[j][i]);
      else
        d[i] = arm[i] + Scalar(offsets_[j][i]);
    }
    return d;
  }

  /// d = anchor less base point.
  template <class Scalar>
  Vector<Scalar> displacement(std::size_t j, const Vector<Scalar>& arm,
                              const std::array<Scalar, size>& y) const noexcept {
    Vector<Scalar> d = turned_displacement(j, arm);
    for (std::size_t i = 0; i < moves; ++i) d[i] = d[i] + y[i];
    return d;
  }

  /// B_jj^2 and the row of A of every leg, moments about the centroid of the anchors.
  template <class Scalar>
  void find_rows(const std::array<Scalar, size>& y,
                 std::array<LegRows<Scalar, size>, size>& rows) const noexcept;

  /// Whether a box, of all coordinates or of those of the rotation, is proved to hold no pose: |v| > 1.
  template <std::size_t N>
  bool is_beyond_half_turn(const std::array<Interval, N>& box) const noexcept {
    if constexpr (turns == 0) return false;
    std::array<Interval, 3> turn{};
    for (std::size_t i = 0; i < turns; ++i) turn[3 - turns + i] = box[N - turns + i];
    return squared_half_turn(turn).lower() > 1.0;
  }

  /// Whether y is on the border of the coordinates, |v| >= 1, or beyond, to rounding.
  bool is_about_half_turn(const Coordinates<size>& y) const noexcept {
    if constexpr (turns == 0) return false;
    std::array<Interval, 3> turn{};
    for (std::size_t i = 0; i < turns; ++i) turn[3 - turns + i] = Interval(y[moves + i]);
    return squared_half_turn(turn).upper() > 1.0 - 1e-9;
  }

  /// d at the origin of the coordinates.
  const Vector<Interval>& displacement_at_origin(std::size_t j) const noexcept { return displacements_[j]; }

 private:
  // |v|^2
  Interval squared_half_turn(const std::array<Interval, 3>& turn) const noexcept {
    Interval sum;
    for (std::size_t i = 3 - (turns == 1 ? 1 : 3); i < 3; ++i) {
      Interval v;
      for (std::size_t k = 0; k < 3; ++k) v += half_turns_[i][k] * turn[k];
      sum += square(v);
    }
    return sum;
  }

  // Of a platform in space; squared_move is the square of the length of its move.
  template <class Scalar>
  LegRows<Scalar, size> rows_about_center(std::size_t j, const Vector<Scalar>& b,
                                          const std::array<Scalar, size>& y,
                                          const Scalar& squared_move) const noexcept;

  void turn_half_turns() noexcept;
  static Vector<Interval> interval_vector(const Eigen::Vector3d& vector) noexcept;

  AnchorMetric metric_;
  std::vector<DistanceLeg> legs_;
  std::array<double, size> turning_{};
  std::array<Vector<Interval>, size> platform_arms_, base_points_;
  std::array<Interval, size> squared_arms_, squared_offsets_;     // the squares of their lengths
  Eigen::Matrix3d half_turns_at_pose_ = Eigen::Matrix3d::Zero();  // in the task frame, middle of the next
  std::array<std::array<Interval, 3>, 3> half_turns_, longer_half_turns_;  // the latter sqrt(2) times
  Rotation<Interval> rotation_;
  std::array<Vector<Interval>, size> arms_, offsets_, displacements_;
  Vector<Interval> center_;  // from the operational point to the centroid, as turned at the pose
  Pose pose_;
  Eigen::Vector3d center_at_pose_ = Eigen::Vector3d::Zero();  // from the operational point, task frame
};

template <TaskSpace space>
template <class Scalar>
typename LocalChart<space>::template Rotation<Scalar> LocalChart<space>::rotation(
    const Scalar* turn) const noexcept {
  if constexpr (space == TaskSpace::SE2) {
    const Interval two(2.0);
    const Scalar v = half_turns_[2][2] * turn[0], vv = square(v);
    const Scalar cosine = Scalar(1.0) - two * vv, sine = two * (root(Scalar(1.0) - vv) * v);
    return {{{cosine, -sine}, {sine, cosine}}};
  } else {
    std::array<Scalar, 3> v;  // sqrt(2) times that of the quaternion, which saves factors of two
    for (std::size_t i = 0; i < 3; ++i)
      v[i] = longer_half_turns_[i][0] * turn[0] + longer_half_turns_[i][1] * turn[1] +
             longer_half_turns_[i][2] * turn[2];
    const Scalar xx = square(v[0]), yy = square(v[1]), zz = square(v[2]);
    const Scalar s = root(Scalar(2.0) - (xx + yy + zz));
    const Scalar xy = v[0] * v[1], xz = v[0] * v[2], yz = v[1] * v[2];
    const Scalar wx = s * v[0], wy = s * v[1], wz = s * v[2];
    return {{{Scalar(1.0) - (yy + zz), xy - wz, xz + wy},
             {xy + wz, Scalar(1.0) - (xx + zz), yz - wx},
             {xz - wy, yz + wx, Scalar(1.0) - (xx + yy)}}};
  }
}

template <TaskSpace space>
template <class Scalar>
typename LocalChart<space>::template Vector<Scalar> LocalChart<space>::arm(
    std::size_t j, const Rotation<Scalar>& rotation) const noexcept {
  Vector<Scalar> result;
  for (std::size_t i = 0; i < dimension; ++i) {
    result[i] = arms_[j][0] * rotation[i][0] + arms_[j][1] * rotation[i][1];
    if constexpr (dimension == 3) result[i] = result[i] + arms_[j][2] * rotation[i][2];
  }
  return result;
}

template <TaskSpace space>
template <class Scalar>
void LocalChart<space>::find_rows(const std::array<Scalar, size>& y,
                                  std::array<LegRows<Scalar, size>, size>& rows) const noexcept {
  [[maybe_unused]] Rotation<Scalar> turned;
  if constexpr (turns > 0) turned = rotation(y.data() + moves);
  [[maybe_unused]] Scalar squared_move(0.0);
  if constexpr (space == TaskSpace::SE3) squared_move = square(y[0]) + square(y[1]) + square(y[2]);
  for (std::size_t j = 0; j < size; ++j) {
    Vector<Scalar> b;
    if constexpr (turns > 0) b = arm(j, turned);
    if constexpr (space == TaskSpace::SE3) {
      rows[j] = rows_about_center(j, b, y, squared_move);
    } else {
      const Vector<Scalar> d = displacement(j, b, y);
      if constexpr (planar)
        rows[j] = leg_rows<space>(legs_[j].form(Planar<Scalar>{d[0], d[1]}), b);
      else
        rows[j] = leg_rows<space>(legs_[j].form(d), b);
    }
  }
}

template <TaskSpace space>
template <class Scalar>
LegRows<Scalar, LocalChart<space>::size> LocalChart<space>::rows_about_center(
    std::size_t j, const Vector<Scalar>& b, const std::array<Scalar, size>& y,
    const Scalar& squared_move) const noexcept {
  Vector<Scalar> e;
  Scalar squared_e = squared_move;
  for (std::size_t i = 0; i < dimension; ++i) {
    const Interval& offset = offsets_[j][i];
    e[i] = y[i] + Scalar(offset);
    squared_e = squared_e + (Interval(2.0) * offset) * y[i];
  }
  return legs_[j].rows(b, e, squared_arms_[j], squared_e + Scalar(squared_offsets_[j]));
}

extern template class LocalChart<TaskSpace::T1>;
extern template class LocalChart<TaskSpace::T2>;
extern template class LocalChart<TaskSpace::SE2>;
extern template class LocalChart<TaskSpace::T3>;
extern template class LocalChart<TaskSpace::SO3>;
extern template class LocalChart<TaskSpace::SE3>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_LOCAL_CHART_H
