// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/gate_line.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects::tools {
namespace {

constexpr double rim_to_line = 4.0;  // from the rim of a circle to the middle of a line [px]
constexpr double bulge_step = 12.0, bulge_unit = 0.02;  // of control points from the chord [px]; share of it
constexpr int bulge_steps = 24;
constexpr double sampled_every = 4.0;  // along a line [px]

/// How far the control points lie from the chord, in steps.
struct Bulge {
  int first = 0, second = 0;

  /// Even arcs before those with a turning point.
  int cost() const {
    const int difference = first - second;
    return first * first + second * second + difference * difference;
  }
};

std::vector<Bulge> bulges_by_cost() {
  std::vector<Bulge> bulges;
  for (int first = -bulge_steps; first <= bulge_steps; ++first)
    for (int second = -bulge_steps; second <= bulge_steps; ++second) bulges.push_back({first, second});
  std::stable_sort(bulges.begin(), bulges.end(),
                   [](const Bulge& a, const Bulge& b) { return a.cost() < b.cost(); });
  return bulges;
}

GateLine bent_line(const PagePoint& from, const PagePoint& to, const Bulge& bulge) {
  const PagePoint chord = to - from;
  const PagePoint across = PagePoint(-chord.y(), chord.x()).normalized();
  const double step = bulge_step + bulge_unit * chord.norm();
  return {{from, from + chord / 3.0 + bulge.first * step * across,
           to - chord / 3.0 + bulge.second * step * across, to}};
}

bool is_clear_of(const GateLine& line, const std::vector<NodeCircle>& others,
                 const Eigen::AlignedBox2d& bounds) {
  double length = 0.0;  // at least that of the curve
  for (std::size_t i = 1; i < line.points.size(); ++i) length += (line.points[i] - line.points[i - 1]).norm();
  const int samples = std::max(2, static_cast<int>(length / sampled_every));
  for (int i = 0; i <= samples; ++i) {
    const PagePoint at = line.at(static_cast<double>(i) / samples);
    if (!bounds.contains(at)) return false;
    for (const NodeCircle& other : others)
      if ((at - other.middle).norm() < other.radius + rim_to_line) return false;
  }
  return true;
}

}  // namespace

PagePoint GateLine::at(double share) const {
  const double rest = 1.0 - share;
  return rest * rest * rest * points[0] + 3.0 * rest * rest * share * points[1] +
         3.0 * rest * share * share * points[2] + share * share * share * points[3];
}

bool GateLine::is_straight() const {
  const PagePoint chord = points[3] - points[0];
  const auto beside = [&](const PagePoint& point) {
    const PagePoint away = point - points[0];
    return std::abs(chord.x() * away.y() - chord.y() * away.x()) > 1e-9 * chord.squaredNorm();
  };
  return !beside(points[1]) && !beside(points[2]);
}

std::optional<GateLine> line_between(const std::vector<NodeCircle>& circles, std::size_t first,
                                     std::size_t second, const Eigen::AlignedBox2d& bounds) {
  static const std::vector<Bulge> bulges = bulges_by_cost();
  std::vector<NodeCircle> others;
  for (std::size_t i = 0; i < circles.size(); ++i)
    if (i != first && i != second) others.push_back(circles[i]);
  for (const Bulge& bulge : bulges) {
    const GateLine line = bent_line(circles[first].middle, circles[second].middle, bulge);
    if (is_clear_of(line, others, bounds)) return line;
  }
  return std::nullopt;
}

}  // namespace parallel_aspects::tools
