// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PLANE_JOINT_RANGE_H
#define PARALLEL_ASPECTS_DRAW_PLANE_JOINT_RANGE_H

#include "model/angles.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// What is left of a convex polygon on one side of a plane across an axis (Sutherland and Hodgman): below the
/// bound where `side` is 1, above it where `side` is -1.
template <class Point>
std::vector<Point> cut_across(const std::vector<Point>& polygon, Eigen::Index axis, double bound,
                              double side) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double a = side * (here[axis] - bound), b = side * (next[axis] - bound);
    if (a <= 0.0) kept.push_back(here);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) kept.push_back(here + a / (a - b) * (next - here));
  }
  return kept;
}

/// Actuated values that are drawn, of two or three joints: one turn, -pi to pi, for an angle without limits,
/// else what the aspects take, or in three dimensions the limits. Opposite ends of a full turn are the same.
template <int Joints>
struct JointRange {
  using Point = Eigen::Matrix<double, Joints, 1>;

  Point lower;                       ///< least values [rad or m]
  Point upper;                       ///< greatest values [rad or m]
  std::array<bool, Joints> turns{};  ///< whether the joint is an angle that wraps

  /// Values brought into the range where they wrap.
  Point wrapped(const Point& q) const noexcept {
    Point inside = q;
    for (std::size_t i = 0; i < turns.size(); ++i)
      if (const auto k = static_cast<Eigen::Index>(i); turns[i]) inside[k] = std::remainder(q[k], full_turn);
    return inside;
  }

  /// The copy of q, a number of turns away, that is closest to the reference.
  Point near(const Point& reference, Point q) const {
    for (std::size_t i = 0; i < turns.size(); ++i)
      if (const auto k = static_cast<Eigen::Index>(i); turns[i])
        q[k] = reference[k] + std::remainder(q[k] - reference[k], full_turn);
    return q;
  }

  /// Every copy of a convex polygon, a turn apart, that meets the range, cut at its ends; where `ends_of_all`
  /// at those of joints that do not wrap, too.
  std::vector<std::vector<Point>> copies_of(const std::vector<Point>& polygon, bool ends_of_all) const {
    std::vector<std::vector<Point>> copies{polygon};
    for (std::size_t i = 0; i < turns.size(); ++i) {
      if (!turns[i] && !ends_of_all) continue;
      const auto k = static_cast<Eigen::Index>(i);
      std::vector<std::vector<Point>> parts;
      for (const std::vector<Point>& copy : copies)
        for (int turn = turns[i] ? -1 : 0; turn <= (turns[i] ? 1 : 0); ++turn) {
          std::vector<Point> part = copy;
          for (Point& corner : part) corner[k] += turn * full_turn;
          part = cut_across(cut_across(part, k, upper[k], 1.0), k, lower[k], -1.0);
          if (part.size() > 2) parts.push_back(std::move(part));
        }
      copies = std::move(parts);
    }
    return copies;
  }

  /// A short straight line as it is seen in the range: where it leaves by one end of a full turn, the rest
  /// comes in by the opposite one.
  std::vector<std::array<Point, 2>> pieces(const Point& from, const Point& to) const {
    const Point start = wrapped(from), beyond = start + (to - from), end = wrapped(beyond);
    if (beyond.isApprox(end)) return {{start, end}};
    return {{cut(end, end - (to - from)), end}, {start, cut(start, beyond)}};
  }

 private:
  // Where the way from a point of the range to one beyond it leaves the range.
  Point cut(const Point& from, const Point& beyond) const {
    double share = 1.0;
    for (Eigen::Index i = 0; i < Joints; ++i) {
      const double bound = beyond[i] > from[i] ? upper[i] : lower[i];
      if (beyond[i] > upper[i] || beyond[i] < lower[i])
        share = std::min(share, (bound - from[i]) / (beyond[i] - from[i]));
    }
    return from + share * (beyond - from);
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PLANE_JOINT_RANGE_H
