// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/boundary_functions.h"
#include "draw/plane/map_pictures.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

using Values = BoundaryFunctions::Values;

struct Vertex {
  Vector2d point;
  Values values;
  double index = 0.0;  // with the sign of det A, so that it is smooth across det A = 0
};
using VertexPolygon = std::vector<Vertex>;

Vertex between(const Vertex& a, const Vertex& b, Eigen::Index function) {
  const double t = a.values[function] / (a.values[function] - b.values[function]);
  return {a.point + t * (b.point - a.point), a.values + t * (b.values - a.values),
          a.index + t * (b.index - a.index)};
}

// What is left of a convex polygon where sign * function >= 0 (Sutherland and Hodgman).
VertexPolygon clipped(const VertexPolygon& polygon, Eigen::Index function, double sign) {
  VertexPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double a = sign * here.values[function], b = sign * next.values[function];
    if (a >= 0.0) kept.push_back(here);
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) kept.push_back(between(here, next, function));
  }
  return kept;
}

Vector2d middle_of(const VertexPolygon& polygon) {
  Vector2d sum = Vector2d::Zero();
  for (const Vertex& vertex : polygon) sum += vertex.point;
  return sum / static_cast<double>(polygon.size());
}

class Tracer {
 public:
  Tracer(const AspectMap& map, const WorkingMode& mode, const PoseSlice& slice, Cells merging,
         const IndexLevels& levels)
      : map_(map),
        mode_(mode),
        slice_(slice),
        merging_(merging),
        levels_(levels),
        functions_(*map.manipulator(), mode, slice.held_joint()) {}

  BoundaryPicture trace_grid(const Eigen::AlignedBox2d& bounds, int cells) {
    const Vector2d step = bounds.sizes() / cells;
    const auto row_at = [&](int row) {
      std::vector<Vertex> vertices;
      for (int column = 0; column <= cells; ++column)
        vertices.push_back(vertex(bounds.min() + step.cwiseProduct(Vector2d(column, row))));
      return vertices;
    };
    std::vector<Vertex> below = row_at(0);
    for (int row = 1; row <= cells; ++row) {
      const std::vector<Vertex> above = row_at(row);
      trace_row(below, above);
      below = above;
    }
    return std::move(picture_);
  }

 private:
  // Neighbouring cells that lie wholly in one aspect are filled as one.
  void trace_row(const std::vector<Vertex>& below, const std::vector<Vertex>& above) {
    int filled = 0;
    std::size_t begin = 0;
    const auto fill_until = [&](std::size_t end) {
      if (filled != 0)
        picture_.slivers.push_back(
            {filled, {below[begin].point, below[end].point, above[end].point, above[begin].point}});
      filled = 0;
    };
    for (std::size_t i = 0; i + 1 < below.size(); ++i) {
      const bool whole = crosses_nothing({below[i], below[i + 1], above[i + 1], above[i]});
      const int aspect = whole ? located(0.5 * (below[i].point + above[i + 1].point)) : 0;
      if (aspect != filled || merging_ == Cells::single) {
        fill_until(i);
        begin = i;
        filled = aspect;
      }
      if (!whole) trace_in(below[i], below[i + 1], above[i + 1], above[i]);
      if (aspect != 0) {
        add_levels({below[i], below[i + 1], above[i + 1]}, aspect);
        add_levels({below[i], above[i + 1], above[i]}, aspect);
      }
    }
    fill_until(below.size() - 1);
  }

  bool crosses_nothing(const VertexPolygon& cell) const {
    const double sign = cell.front().values[0];
    return std::all_of(cell.begin(), cell.end(), [&](const Vertex& vertex) {
      return slice_.holds(vertex.point) && sign * vertex.values[0] > 0.0 &&
             vertex.values.tail(vertex.values.size() - 1).minCoeff() > 0.0;
    });
  }

  // Two triangles a cell: linear interpolation in a triangle has no ambiguous case.
  void trace_in(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
    for (const Vertex& corner : {a, b, c, d})
      if (!slice_.holds(corner.point)) return;
    for (const VertexPolygon& triangle : {VertexPolygon{a, b, c}, VertexPolygon{a, c, d}})
      for (const double sign : {1.0, -1.0}) add_part(triangle, sign, (b.point - a.point).norm());
  }

  Vertex vertex(const Vector2d& point) const {
    const Pose pose = slice_.pose(point);
    Vertex result{point, functions_.values(pose)};
    if (!levels_.levels.empty()) result.index = std::copysign(index(pose), result.values[0]);
    return result;
  }

  double index(const Pose& pose) const {
    const Manipulator& robot = *map_.manipulator();
    JointVector q(robot.leg_count());
    for (std::size_t j = 0; j < robot.leg_count(); ++j)
      q[static_cast<Eigen::Index>(j)] =
          joint_value(robot.leg(j), pose.transform(robot.leg(j).anchor), mode_.sign(j));
    if (const auto held = slice_.held_joint()) q[static_cast<Eigen::Index>(held->leg)] = held->value;
    switch (levels_.index) {
      case DrawnIndex::parallel:
        return parallel_index(robot, pose, q);
      case DrawnIndex::conditioning:
        break;
    }
    return singularity_indices(robot, pose, q).inverse_condition_number;
  }

  // The part of a triangle in the mode and sign of det A: a sliver, and those of its sides that bound it.
  void add_part(const VertexPolygon& triangle, double sign, double width) {
    VertexPolygon part = clipped(triangle, 0, sign);
    for (std::size_t k = 1; k < functions_.list().size(); ++k)
      part = clipped(part, static_cast<Eigen::Index>(k), 1.0);
    if (part.size() < 3) return;
    const int aspect = located(middle_of(part));
    if (aspect != 0) {
      add_levels(part, aspect);
      picture_.slivers.push_back({aspect, {}});
      for (const Vertex& vertex : part) picture_.slivers.back().corners.push_back(vertex.point);
    }
    for (std::size_t i = 0; i < part.size(); ++i) add_side(part[i], part[(i + 1) % part.size()], width);
  }

  // In a part of a triangle the index is linear, so that each of its lines is straight there.
  void add_levels(const VertexPolygon& part, int aspect) {
    for (const double level : levels_.levels) {
      std::vector<Vector2d> ends;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Vertex &here = part[i], &next = part[(i + 1) % part.size()];
        const double a = std::abs(here.index) - level, b = std::abs(next.index) - level;
        if ((a < 0.0) != (b < 0.0)) ends.push_back(here.point + a / (a - b) * (next.point - here.point));
      }
      if (ends.size() == 2) picture_.levels.push_back({level, aspect, ends[0], ends[1]});
    }
  }

  // A side bounds the mode where one function vanishes all along it.
  void add_side(const Vertex& from, const Vertex& to, double width) {
    const Vector2d along = to.point - from.point;
    if (!(along.norm() > 1e-9 * width)) return;
    for (std::size_t k = 0; k < functions_.list().size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      const double tolerance = 1e-12 * (from.values.cwiseAbs().sum() + to.values.cwiseAbs().sum());
      if (std::abs(from.values[row]) > tolerance || std::abs(to.values[row]) > tolerance) continue;
      const Vector2d middle = 0.5 * (from.point + to.point),
                     left = Vector2d(-along.y(), along.x()).normalized();
      picture_.segments.push_back({functions_.list()[k].kind,
                                   functions_.list()[k].leg,
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
    const Location found = map_.locate(slice_.pose(point), mode_);
    return found.status == LocationStatus::inside ? found.aspect : 0;
  }

  const AspectMap& map_;
  const WorkingMode mode_;
  const PoseSlice slice_;
  const Cells merging_;
  const IndexLevels& levels_;
  const BoundaryFunctions functions_;
  BoundaryPicture picture_;
};

}  // namespace

BoundaryPicture trace_slice(const AspectMap& map, const WorkingMode& mode, const PoseSlice& slice,
                            const Eigen::AlignedBox2d& bounds, int cells, Cells merging,
                            const IndexLevels& levels) {
  return Tracer(map, mode, slice, merging, levels).trace_grid(bounds, cells);
}

}  // namespace parallel_aspects
