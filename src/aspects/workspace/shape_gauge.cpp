// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/workspace/shape_gauge.h"

#include "interval/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

Interval squared(const Interval& a) { return square(a); }
double squared(double a) { return a * a; }
Interval rooted(const Interval& a) { return square_root(a); }
double rooted(double a) { return std::sqrt(a); }
Interval larger_of(const Interval& a, const Interval& b) {
  return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}
double larger_of(double a, double b) { return std::max(a, b); }

}  // namespace

ShapeGauge::ShapeGauge(const WorkspaceQuestion& question, std::size_t dimension) : dimension_(dimension) {
  const std::vector<double>& ratio = question.ratio;
  const bool is_round = question.shape == RegularShape::disc || question.shape == RegularShape::ball ||
                        question.shape == RegularShape::cylinder;
  for (std::size_t i = 0; i < dimension; ++i) {
    group_[i] = is_round ? 0 : i;
    // Half an edge is as far as the box goes from its center.
    scale_[i] = is_round ? 1.0 : ratio.empty() ? 2.0 : 2.0 * ratio[0] / ratio[i];
  }
  if (question.shape == RegularShape::cylinder) {
    group_[2] = 1;
    scale_[2] = ratio.empty() ? 1.0 : 1.0 / ratio[0];
  }
}

template <class Scalar>
Scalar ShapeGauge::norm(const std::array<Scalar, max_map_dimension>& displacement) const noexcept {
  std::array<Scalar, max_map_dimension> sums{};
  for (std::size_t i = 0; i < dimension_; ++i)
    sums[group_[i]] = sums[group_[i]] + squared(Scalar(scale_[i]) * displacement[i]);
  Scalar largest(0.0);
  for (std::size_t i = 0; i < dimension_; ++i) largest = larger_of(largest, sums[i]);
  return rooted(largest);
}

double ShapeGauge::distance(const MapPoint& center, const Box& box) const noexcept {
  std::array<double, max_map_dimension> displacement{};
  for (std::size_t i = 0; i < dimension_; ++i)
    displacement[i] = std::max({0.0, box.lower[i] - center[i], center[i] - box.upper[i]});
  return norm(displacement);
}

double ShapeGauge::distance_at_least(const MapPoint& center, const Box& box) const noexcept {
  std::array<Interval, max_map_dimension> displacement{};
  for (std::size_t i = 0; i < dimension_; ++i) {
    const Interval below = Interval(box.lower[i]) - Interval(center[i]);
    const Interval above = Interval(center[i]) - Interval(box.upper[i]);
    displacement[i] = larger_of(Interval(0.0), larger_of(below, above));
  }
  return norm(displacement).lower();
}

double ShapeGauge::half_extent(const Box& box) const noexcept {
  const MapPoint middle = box.middle();
  std::array<double, max_map_dimension> displacement{};
  for (std::size_t i = 0; i < dimension_; ++i)
    displacement[i] = std::max(box.upper[i] - middle[i], middle[i] - box.lower[i]);
  return norm(displacement);
}

double ShapeGauge::room(const MapPoint& center, const Box& box) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < dimension_; ++i)
    least = std::min(least, scale_[i] * std::min(box.upper[i] - center[i], center[i] - box.lower[i]));
  return std::max(0.0, least);
}

double ShapeGauge::room_at_least(const MapPoint& center, const Box& box) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < dimension_; ++i) {
    const Interval scale(scale_[i]), c(center[i]);
    least = std::min({least, (scale * (Interval(box.upper[i]) - c)).lower(),
                      (scale * (c - Interval(box.lower[i]))).lower()});
  }
  return std::max(0.0, least);
}

}  // namespace parallel_aspects
