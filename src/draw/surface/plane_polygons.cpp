// SPDX-License-Identifier: BSD-3-Clause
#include "draw/surface/plane_polygons.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Positive where the way from a over b to c turns left.
double turn_of(const Vector2d& a, const Vector2d& b, const Vector2d& c) { return cross(b - a, c - b); }

bool holds(const PlaneLoop& loop, const Points& points, const Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector2d &a = points[loop[i]], &b = points[loop[(i + 1) % loop.size()]];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

bool crosses(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const auto side = [](double value) { return value > 0.0; };
  return side(cross(b - a, c - a)) != side(cross(b - a, d - a)) &&
         side(cross(d - c, a - c)) != side(cross(d - c, b - c));
}

/// One outer loop with its holes.
class PolygonWithHoles {
 public:
  PolygonWithHoles(PlaneLoop outer, std::vector<PlaneLoop> holes, const Points& points)
      : points_(points), polygon_(std::move(outer)), holes_(std::move(holes)) {
    const auto rightmost = [&](const PlaneLoop& hole) {
      double most = -std::numeric_limits<double>::infinity();
      for (const std::uint32_t corner : hole) most = std::max(most, points_[corner].x());
      return most;
    };
    std::sort(holes_.begin(), holes_.end(),
              [&](const PlaneLoop& a, const PlaneLoop& b) { return rightmost(a) > rightmost(b); });
    while (!holes_.empty()) join_first_hole();
  }

  void add_triangles(std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::size_t here = 0, refused = 0;
    while (polygon_.size() > 3) {
      here %= polygon_.size();
      const std::size_t before = (here + polygon_.size() - 1) % polygon_.size(),
                        after = (here + 1) % polygon_.size();
      if (refused < polygon_.size() && !is_ear(before, here, after)) {
        ++refused;
        ++here;
        continue;
      }
      triangles.push_back({polygon_[before], polygon_[here], polygon_[after]});
      polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(here));
      refused = 0;
      ++here;  // so that triangles are not all at one corner
    }
    if (polygon_.size() == 3) triangles.push_back({polygon_[0], polygon_[1], polygon_[2]});
  }

 private:
  const Vector2d& at(std::size_t i) const { return points_[polygon_[i % polygon_.size()]]; }

  // A bridge from its rightmost corner, there and back.
  void join_first_hole() {
    PlaneLoop hole = std::move(holes_.front());
    holes_.erase(holes_.begin());
    std::rotate(
        hole.begin(),
        std::max_element(hole.begin(), hole.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return points_[a].x() < points_[b].x(); }),
        hole.end());
    const std::size_t here = end_of_bridge(points_[hole.front()], hole);
    hole.push_back(hole.front());
    hole.push_back(polygon_[here]);
    polygon_.insert(polygon_.begin() + static_cast<std::ptrdiff_t>(here) + 1, hole.begin(), hole.end());
  }

  // The nearest corner that is seen from there.
  std::size_t end_of_bridge(const Vector2d& from, const PlaneLoop& hole) const {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < polygon_.size(); ++i) order.emplace_back((at(i) - from).squaredNorm(), i);
    std::sort(order.begin(), order.end());
    for (const auto& [distance, i] : order)
      if (opens_to(i, from) && sees(from, i, polygon_) && sees(from, i, hole)) return i;
    return order.front().second;
  }

  // Whether the inside of the corner is on the way to that point: corners of bridges are there twice.
  bool opens_to(std::size_t i, const Vector2d& point) const {
    const Vector2d &before = at(i + polygon_.size() - 1), &here = at(i), &after = at(i + 1);
    const bool left_of_first = turn_of(before, here, point) > 0.0,
               left_of_second = turn_of(here, after, point) > 0.0;
    return turn_of(before, here, after) > 0.0 ? left_of_first && left_of_second
                                              : left_of_first || left_of_second;
  }

  bool sees(const Vector2d& from, std::size_t corner, const PlaneLoop& loop) const {
    const Vector2d& to = at(corner);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector2d &a = points_[loop[i]], &b = points_[loop[(i + 1) % loop.size()]];
      if (a == to || b == to || a == from || b == from) continue;
      if (crosses(from, to, a, b)) return false;
    }
    return true;
  }

  bool is_ear(std::size_t before, std::size_t here, std::size_t after) const {
    const Vector2d &a = at(before), &b = at(here), &c = at(after);
    if (!(turn_of(a, b, c) > 0.0)) return false;
    return std::none_of(polygon_.begin(), polygon_.end(), [&](std::uint32_t corner) {
      const Vector2d& p = points_[corner];
      if (p == a || p == b || p == c) return false;
      return cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0;
    });
  }

  const Points& points_;
  PlaneLoop polygon_;
  std::vector<PlaneLoop> holes_;
};

}  // namespace

double doubled_area(const PlaneLoop& loop, const Points& points) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += cross(points[loop[i]] - points[loop[0]], points[loop[(i + 1) % loop.size()]] - points[loop[0]]);
  return sum;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<PlaneLoop>& loops,
                                                       const Points& points) {
  std::vector<std::pair<double, PlaneLoop>> outer;
  std::vector<PlaneLoop> holes;
  for (const PlaneLoop& loop : loops) {
    const double area = doubled_area(loop, points);
    if (area < 0.0)
      holes.push_back(loop);
    else
      outer.emplace_back(area, loop);
  }
  std::sort(outer.begin(), outer.end());  // what holds a hole most closely comes first
  std::vector<std::vector<PlaneLoop>> holes_of(outer.size());
  for (PlaneLoop& hole : holes) {
    const auto around = std::find_if(outer.begin(), outer.end(), [&](const auto& each) {
      return holds(each.second, points, points[hole.front()]);
    });
    if (around != outer.end()) {
      holes_of[static_cast<std::size_t>(around - outer.begin())].push_back(std::move(hole));
    } else {  // by rounding alone
      outer.emplace_back(0.0, std::move(hole));
      holes_of.emplace_back();
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < outer.size(); ++i)
    PolygonWithHoles(outer[i].second, std::move(holes_of[i]), points).add_triangles(triangles);
  return triangles;
}

}  // namespace parallel_aspects
