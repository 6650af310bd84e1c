// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_SEARCH_RESULT_H
#define PARALLEL_ASPECTS_DISTANCE_SEARCH_RESULT_H

#include "distance/point_dual.h"
#include "parallel_aspects/distance/boundary_distances.h"

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_SEARCH_RESULT_H
