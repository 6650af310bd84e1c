// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_LEAF_VIEW_H
#define PARALLEL_ASPECTS_DISTANCE_LEAF_VIEW_H

#include "distance/anchor_metric.h"
#include "distance/cell.h"
#include "distance/search_result.h"
#include "distance/singular_leaves.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

/// The pose of a center.
template <TaskSpace space>
Pose pose_of(const LeafCenter& center, const AnchorMetric& metric) noexcept {
  constexpr std::size_t moves = traits(space).translations, turns = traits(space).rotations;
  Pose pose;
  if constexpr (turns == 1) pose.orientation = Eigen::Quaterniond(center[3], 0.0, 0.0, center[2]);
  if constexpr (turns == 3) pose.orientation = Eigen::Quaterniond(center[3], center[0], center[1], center[2]);
  pose.orientation.normalize();
  const Eigen::Vector3d arm = pose.orientation * metric.center;
  for (std::size_t i = 0; i < moves; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    pose.position[k] = static_cast<double>(center[i]) - arm[k];
  }
  return pose;
}

/// Centers and leaves as they are seen from one pose, in the coordinates of a local_chart there, and lower
/// bounds of how far they are. With p the quaternion from the pose to a center, a pose of the coordinates
/// (c, r) about the center has the coordinates
///
///     ( c' + c,  w 2 W^-1 p_v + W^-1 (p_w I + [p_v]x) W r ),   w = sqrt(1 - |W r|^2 / 4),
///
/// about the pose, or their rotation negated. Here W = `half_turns` of the metric. These are linear but for
/// w, so that no trigonometry is left, and no seam. Needs a live `RoundingUpward`.
template <TaskSpace space>
class LeafView {
 public:
  static constexpr std::size_t moves = traits(space).translations, turns = traits(space).rotations;
  static constexpr std::size_t size = moves + turns;
  static_assert(size <= 3);

  /// The metric must outlive it.
  explicit LeafView(const AnchorMetric& metric) noexcept : metric_(metric) {
    if constexpr (turns == 1) back_(2, 2) = 1.0 / metric.half_turns(2, 2);
    if constexpr (turns == 3) back_ = metric.half_turns.inverse();
    half_turn_ = 0.5 * metric.half_turns.norm() * (1.0 + 1e-12);
  }

  /// Looks from this pose at centers whose coordinates are at most `extent` [m].
  void look_from(const Pose& pose, double extent) noexcept {
    orientation_ = pose.orientation.normalized();
    origin_ = pose.position + orientation_ * metric_.center;
    // All that is added up here is at most `scale`, in some dozens of operations.
    const double scale = extent + pose.position.cwiseAbs().sum() + 4.0 * metric_.longest_arm +
                         metric_.center.cwiseAbs().sum() +
                         metric_.widest_turn * (1.0 + metric_.half_turns.norm() * back_.norm());
    slack_ = 0x1p-40 * scale;
  }

  /// A center in the coordinates, and p.
  struct Seen {
    Coordinates<size> y{};
    Eigen::Quaterniond by = Eigen::Quaterniond::Identity();
  };

  Seen see(const LeafCenter& center) const noexcept {
    Seen seen;
    for (std::size_t i = 0; i < moves; ++i)
      seen.y[i] = static_cast<double>(center[i]) - origin_[static_cast<Eigen::Index>(i)];
    if constexpr (turns == 1) {
      const double z = center[2], w = center[3], length = near_unit(z * z + w * w);
      seen.by.z() = length * (orientation_.w() * z - orientation_.z() * w);
      seen.by.w() = length * (orientation_.w() * w + orientation_.z() * z);
      seen.y[2] = 2.0 * back_(2, 2) * seen.by.z();
    }
    if constexpr (turns == 3) {
      const Eigen::Quaterniond q(center[3], center[0], center[1], center[2]);
      seen.by = orientation_.conjugate() * q;
      seen.by.coeffs() *= near_unit(q.squaredNorm());
      const Eigen::Vector3d r = 2.0 * (back_ * seen.by.vec());
      for (std::size_t i = 0; i < 3; ++i) seen.y[i] = r[static_cast<Eigen::Index>(i)];
    }
    return seen;
  }

  /// D of a center, but for `slack()`.
  double distance(const LeafCenter& center) const noexcept { return length<size>(see(center).y); }
  double slack() const noexcept { return slack_; }

  /// Proved: nothing in the ball is closer.
  double least_distance(const LeafBall& ball) const noexcept {
    return distance(ball.center) - (slack_ + static_cast<double>(ball.radius));
  }

  /// Proved: no singularity in the leaf is closer. Where the ball is beyond `enough`, that is all that is
  /// examined.
  double least_distance(const SingularLeaf& leaf, double enough) const noexcept {
    const Seen seen = see(leaf.center);
    const double radius = leaf.radius, in_ball = length<size>(seen.y) - (slack_ + radius);
    if (in_ball >= enough || !leaf.has_plane()) return in_ball;
    const Coordinates<size> normal = normal_of(leaf);
    return std::max(in_ball, along(toward_nearest(seen, normal, leaf), seen, normal, leaf));
  }

  /// Encloses the coordinates of the poses of the leaf, as far as they are not about half a turn away.
  Cell<size> cell_about(const Seen& seen, const SingularLeaf& leaf) const noexcept {
    Cell<size> cell;
    std::array<Coordinates<size>, size> columns;
    for (std::size_t k = 0; k < size; ++k) {
      Coordinates<size> axis{};
      axis[k] = 1.0;
      columns[k] = turned(seen, axis);
    }
    for (std::size_t i = 0; i < size; ++i) {
      double squares = 0.0;
      for (std::size_t k = 0; k < size; ++k) squares += columns[k][i] * columns[k][i];
      const bool negated = i >= moves && seen.by.w() < 0.0;  // the shorter way round
      cell.center[i] = negated ? -seen.y[i] : seen.y[i];
      cell.half_width[i] = std::sqrt(squares) * static_cast<double>(leaf.radius) + slack_ +
                           (i >= moves ? loss(leaf) * std::abs(seen.y[i]) : 0.0);
    }
    return cell;
  }

  /// Whether poses of the leaf may be a half turn away.
  bool is_about_half_turn(const Seen& seen, const SingularLeaf& leaf) const noexcept {
    if constexpr (turns == 0) return false;
    return !(std::abs(seen.by.w()) > 2.0 * half_turn_ * static_cast<double>(leaf.radius) + 1e-6);
  }

 private:
  // 1 / sqrt(a) for a near 1, as the squared length of floats that were a unit vector.
  static double near_unit(double a) noexcept { return 1.5 - 0.5 * a; }

  static Coordinates<size> normal_of(const SingularLeaf& leaf) noexcept {
    Coordinates<size> normal;
    for (std::size_t i = 0; i < size; ++i) normal[i] = leaf.normal[i];
    return normal;
  }

  // W^-1 (p_w I + [p_v]x) W r, and that of its transpose.
  Coordinates<size> turned(const Seen& seen, const Coordinates<size>& y) const noexcept {
    Coordinates<size> result = y;
    if constexpr (turns == 1) result[2] = seen.by.w() * y[2];
    if constexpr (turns == 3) {
      const Eigen::Vector3d v = metric_.half_turns * Eigen::Vector3d(y[0], y[1], y[2]);
      const Eigen::Vector3d r = back_ * (seen.by.w() * v + seen.by.vec().cross(v));
      result = {r[0], r[1], r[2]};
    }
    return result;
  }
  Coordinates<size> turned_back(const Seen& seen, const Coordinates<size>& y) const noexcept {
    Coordinates<size> result = y;
    if constexpr (turns == 1) result[2] = seen.by.w() * y[2];
    if constexpr (turns == 3) {
      const Eigen::Vector3d v = back_.transpose() * Eigen::Vector3d(y[0], y[1], y[2]);
      const Eigen::Vector3d r = metric_.half_turns.transpose() * (seen.by.w() * v - seen.by.vec().cross(v));
      result = {r[0], r[1], r[2]};
    }
    return result;
  }

  // 1 - sqrt(1 - x) <= (x + x^2) / 2, with x at least the square of the half turn.
  double loss(const SingularLeaf& leaf) const noexcept {
    if constexpr (turns == 0) return 0.0;
    const double half = half_turn_ * static_cast<double>(leaf.radius), x = std::min(1.0, half * half);
    return 0.5 * (x + x * x);
  }

  // A unit vector to about the nearest point of the disk that ball and plane have in common: any is right.
  Coordinates<size> toward_nearest(const Seen& seen, const Coordinates<size>& normal,
                                   const SingularLeaf& leaf) const noexcept {
    Coordinates<size> origin = turned_back(seen, seen.y);
    for (double& each : origin) each = -each;
    const double offset = leaf.offset, thickness = leaf.thickness, radius = leaf.radius;
    const double at = dot<size>(normal, origin);
    const double height = std::clamp(at, offset - thickness, offset + thickness);
    const double disk = std::sqrt(std::max(0.0, radius * radius - height * height));
    const Coordinates<size> beside = moved<size>(origin, -at, normal);
    const double aside = length<size>(beside), share = aside > disk ? disk / aside : 1.0;
    Coordinates<size> nearest{};
    for (std::size_t i = 0; i < size; ++i) nearest[i] = height * normal[i] + share * beside[i];
    Coordinates<size> result = moved<size>(seen.y, 1.0, turned(seen, nearest));
    const double far = length<size>(result);
    if (!(far > 0.0)) return {};
    for (double& each : result) each /= far;
    return result;
  }

  // Proved for every `to` no longer than 1: D of a singularity in the leaf is at least its part along `to`.
  double along(const Coordinates<size>& to, const Seen& seen, const Coordinates<size>& normal,
               const SingularLeaf& leaf) const noexcept {
    const double offset = leaf.offset, thickness = leaf.thickness, radius = leaf.radius;
    const Coordinates<size> back = turned_back(seen, to);
    const double factor = dot<size>(normal, back) / dot<size>(normal, normal);
    const double aside = length<size>(moved<size>(back, -factor, normal));
    const double least_height = std::max(0.0, std::abs(offset) - thickness) * (1.0 - 1e-6);
    const double disk = std::sqrt(std::max(0.0, radius * radius - least_height * least_height));
    double turn = 0.0;
    for (std::size_t i = moves; i < size; ++i) turn += to[i] * seen.y[i];
    return dot<size>(to, seen.y) + factor * offset -
           (loss(leaf) * std::abs(turn) + std::abs(factor) * thickness + aside * disk + slack_);
  }

  const AnchorMetric& metric_;
  Eigen::Matrix3d back_ = Eigen::Matrix3d::Zero();  // W^-1
  double half_turn_ = 0.0;                          // |v| is at most this times |r|
  Eigen::Quaterniond orientation_ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double slack_ = 0.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_LEAF_VIEW_H
