// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/boundary_curves.h"

#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

// det A, then each B_jj^2, then the distance of each limited drive from its limits. Zero sets bound the mode.
constexpr int most_functions = 1 + 2 + 4;
using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_functions, 1>;

struct Function {
  BoundaryKind kind;
  std::size_t leg;
};

struct Vertex {
  Vector2d point;
  Values values;
};
using Polygon = std::vector<Vertex>;

Vertex between(const Vertex& a, const Vertex& b, Eigen::Index function) {
  const double t = a.values[function] / (a.values[function] - b.values[function]);
  return {a.point + t * (b.point - a.point), a.values + t * (b.values - a.values)};
}

// What is left of a convex polygon where sign * function >= 0 (Sutherland and Hodgman).
Polygon clipped(const Polygon& polygon, Eigen::Index function, double sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double a = sign * here.values[function], b = sign * next.values[function];
    if (a >= 0.0) kept.push_back(here);
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) kept.push_back(between(here, next, function));
  }
  return kept;
}

Vector2d middle_of(const Polygon& polygon) {
  Vector2d sum = Vector2d::Zero();
  for (const Vertex& vertex : polygon) sum += vertex.point;
  return sum / static_cast<double>(polygon.size());
}

class Tracer {
 public:
  Tracer(const AspectMap& map, const WorkingMode& mode)
      : map_(map), robot_(*map.manipulator()), mode_(mode), functions_{{BoundaryKind::parallel, 0}} {
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) functions_.push_back({BoundaryKind::serial, j});
    for (std::size_t j = 0; j < robot_.leg_count(); ++j)
      for (const double limit : {robot_.leg(j).limits.lower, robot_.leg(j).limits.upper})
        if (std::isfinite(limit)) functions_.push_back({BoundaryKind::limit, j});
  }

  BoundaryPicture trace() {
    map_.visit_undecided_leaves(mode_, [this](const Box& box) { trace_in(box); });
    return std::move(picture_);
  }

 private:
  // Two triangles a leaf: linear interpolation in a triangle has no ambiguous case.
  void trace_in(const Box& box) {
    const Vertex a = vertex({box.lower[0], box.lower[1]}), b = vertex({box.upper[0], box.lower[1]});
    const Vertex c = vertex({box.upper[0], box.upper[1]}), d = vertex({box.lower[0], box.upper[1]});
    for (const Polygon& triangle : {Polygon{a, b, c}, Polygon{a, c, d}})
      for (const double sign : {1.0, -1.0}) add_part(triangle, sign, box.width(0));
  }

  Vertex vertex(const Vector2d& point) const { return {point, values(point)}; }

  Values values(const Vector2d& point) const {
    Pose pose;
    pose.position << point, 0.0;
    JointVector q(robot_.leg_count());
    Values result(functions_.size());
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      const Leg& leg = robot_.leg(j);
      const auto row = static_cast<Eigen::Index>(j);
      q[row] = drive_value(leg, pose.transform(leg.anchor), mode_.sign(j));
      result[1 + row] = squared_inverse_entry(leg, pose.transform(leg.anchor));
    }
    result[0] = direct_determinant(robot_, pose, q);
    add_limits(q, result);
    return result;
  }

  void add_limits(const JointVector& q, Values& result) const {
    Eigen::Index row = 1 + static_cast<Eigen::Index>(robot_.leg_count());
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      const JointLimits& limits = robot_.leg(j).limits;
      const double value = q[static_cast<Eigen::Index>(j)];
      if (std::isfinite(limits.lower)) result[row++] = value - limits.lower;
      if (std::isfinite(limits.upper)) result[row++] = limits.upper - value;
    }
  }

  // The part of a triangle in the mode and sign of det A: a sliver, and those of its sides that bound it.
  void add_part(const Polygon& triangle, double sign, double width) {
    Polygon part = clipped(triangle, 0, sign);
    for (std::size_t k = 1; k < functions_.size(); ++k)
      part = clipped(part, static_cast<Eigen::Index>(k), 1.0);
    if (part.size() < 3) return;
    const int aspect = located(middle_of(part));
    if (aspect != 0) {
      picture_.slivers.push_back({aspect, {}});
      for (const Vertex& vertex : part) picture_.slivers.back().corners.push_back(vertex.point);
    }
    for (std::size_t i = 0; i < part.size(); ++i) add_side(part[i], part[(i + 1) % part.size()], width);
  }

  // A side bounds the mode where one function vanishes all along it.
  void add_side(const Vertex& from, const Vertex& to, double width) {
    const Vector2d along = to.point - from.point;
    if (!(along.norm() > 1e-9 * width)) return;
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      const double tolerance = 1e-12 * (from.values.cwiseAbs().sum() + to.values.cwiseAbs().sum());
      if (std::abs(from.values[row]) > tolerance || std::abs(to.values[row]) > tolerance) continue;
      const Vector2d middle = 0.5 * (from.point + to.point),
                     left = Vector2d(-along.y(), along.x()).normalized();
      picture_.segments.push_back({functions_[k].kind,
                                   functions_[k].leg,
                                   from.point,
                                   to.point,
                                   {beside(middle, left, width), beside(middle, -left, width)}});
      return;
    }
  }

  int beside(const Vector2d& point, const Vector2d& direction, double width) const {
    for (const double steps : {0.1, 1.0, 2.0})
      if (const int aspect = located(point + steps * width * direction)) return aspect;
    return 0;
  }

  int located(const Vector2d& point) const {
    Pose pose;
    pose.position << point, 0.0;
    const Location found = map_.locate(pose, mode_);
    return found.status == LocationStatus::inside ? found.aspect : 0;
  }

  const AspectMap& map_;
  const Manipulator& robot_;
  const WorkingMode mode_;
  std::vector<Function> functions_;
  BoundaryPicture picture_;
};

}  // namespace

BoundaryPicture trace_boundary(const AspectMap& map, const WorkingMode& mode) {
  if (map.manipulator()->task_space() != TaskSpace::T2) return {};
  return Tracer(map, mode).trace();
}

}  // namespace parallel_aspects
