// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_SEARCH_RESULT_H
#define PARALLEL_ASPECTS_DISTANCE_SEARCH_RESULT_H

#include "distance/point_dual.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace parallel_aspects {

/// What a search knows, in coordinates of a local_chart.
template <std::size_t N>
struct SearchResult {
  DistanceStatus status = DistanceStatus::unavailable;
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  bool upper_proved = false;
  Coordinates<N> witness{};
  std::size_t leg = 0;
  LimitEnd end = LimitEnd::lower;
  int boxes = 0;

  bool has_witness() const noexcept { return std::isfinite(upper); }

  /// Takes what is nearer.
  bool offer(const Coordinates<N>& y, double distance, bool proved) noexcept {
    if (!(distance < upper)) return false;
    witness = y;
    upper = distance;
    upper_proved = proved;
    return true;
  }

  static SearchResult touching() noexcept {
    SearchResult result;
    result.status = DistanceStatus::touching;
    return result;
  }

  static SearchResult absent() noexcept {
    SearchResult result;
    result.status = DistanceStatus::absent;
    result.lower = std::numeric_limits<double>::infinity();
    return result;
  }
};

/// A radius that every pose is within, or that is looked no farther than.
struct SearchRange {
  double radius = 0.0;
  bool holds_all = false;  ///< every pose that all legs can reach is proved to be within
};

/// |y|, rounded up or down as the thread rounds.
template <std::size_t N>
double length(const Coordinates<N>& y) noexcept {
  return std::sqrt(dot<N>(y, y));
}

/// The box that two points span, widened by nothing.
template <std::size_t N>
std::array<Interval, N> hull(const Coordinates<N>& a, const Coordinates<N>& b) noexcept {
  std::array<Interval, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = Interval(std::min(a[i], b[i]), std::max(a[i], b[i]));
  return result;
}

/// y + distance * direction.
template <std::size_t N>
Coordinates<N> moved(const Coordinates<N>& y, double distance, const Coordinates<N>& direction) noexcept {
  Coordinates<N> result = y;
  for (std::size_t i = 0; i < N; ++i) result[i] += distance * direction[i];
  return result;
}

/// The inverse solution of the pose; joint values and status are filled by it. There is nothing to search for
/// where a leg does not reach.
inline InverseSolution begin_distances(const Manipulator& robot, const Pose& pose, const WorkingMode& mode,
                                       BoundaryDistances& result) noexcept {
  InverseSolution solution = inverse(robot, pose, mode);
  result.q = solution.q;
  result.status = solution.status == InverseStatus::out_of_reach ? ConfigurationStatus::out_of_reach
                  : solution.status == InverseStatus::solved     ? ConfigurationStatus::measured
                                                                 : ConfigurationStatus::outside_limits;
  return solution;
}

/// Where the pose is of the boundary itself, by this leg.
inline BoundaryDistance touching(std::size_t leg) noexcept {
  BoundaryDistance result;
  result.status = DistanceStatus::touching;
  result.leg = leg;
  return result;
}

/// The joint values at the witness of a distance, and how far they are from q.
inline void add_joints_of_witness(const Manipulator& robot, const WorkingMode& mode, const JointVector& q,
                                  BoundaryDistance& found) noexcept {
  found.witness_q.resize(q.size());
  found.joint_displacement.resize(q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    const Leg& leg = robot.leg(index);
    const double to = joint_value(leg, found.witness.transform(leg.anchor), mode.sign(index)),
                 way = to - q[j];
    found.witness_q[j] = to;
    found.joint_displacement[j] =
        leg.actuated_by_angle() && !leg.limits.limited() ? std::remainder(way, 2.0 * EIGEN_PI) : way;
  }
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_SEARCH_RESULT_H
