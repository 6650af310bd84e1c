// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_ANCHOR_METRIC_H
#define PARALLEL_ASPECTS_DISTANCE_ANCHOR_METRIC_H

#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Core>

namespace parallel_aspects {

/// The metric D^2 = mean |p_j(X) - p_j(X')|^2 of the anchors in coordinates in which it is Euclidean.
///
/// With c the centroid of the anchors, b_j = anchor - c, and the unit quaternion (v, sqrt(1 - |v|^2)) of the
/// rotation between two poses (v in the platform frame of the first), every point moves about c by 2 |v x b|,
/// so that
///
///     D^2 = |c' - c|^2 + 4 v^T J v,   J = mean (|b|^2 I - b b^T),
///
/// exactly and for rotations of any angle. In SO3 the origin takes the place of c. With y = (c' - c, r) and
/// v = `half_turns` r / 2, where half_turns^T J half_turns = I, D = |y|; one number r for SE2.
struct AnchorMetric {
  explicit AnchorMetric(const Manipulator& manipulator);

  /// A point of the platform moves about c by at most this much a metre of |r|: 2 |v x b| = |half_turns r x
  /// b|.
  double turning(const Eigen::Vector3d& point) const;

  bool usable = false;         ///< anchors spread enough to see every rotation of the task space
  Eigen::Vector3d center;      ///< c in the platform frame [m]
  Eigen::Matrix3d half_turns;  ///< [1/m]; of it only the last entry in SE2
  double longest_arm = 0.0;    ///< no |b_j| is longer [m]
  double widest_turn = 0.0;    ///< D of no rotation about c is larger [m]

  /// Proved: |D - |y|| <= `error` |y|, for the rounding of `center` and `half_turns`.
  double error = 0.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_ANCHOR_METRIC_H
