// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/boundary_curves.h"

#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"

#include <cmath>
#include <functional>
#include <optional>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

Pose pose_at(const Vector2d& point) {
  Pose pose;
  pose.position << point, 0.0;
  return pose;
}

// A function of the pose whose zero set bounds the mode.
struct Boundary {
  BoundaryKind kind;
  std::size_t leg;
  std::function<double(const Vector2d&)> value;
};

class Tracer {
 public:
  Tracer(const AspectMap& map, const WorkingMode& mode) : map_(map), robot_(*map.manipulator()), mode_(mode) {
    boundaries_.push_back({BoundaryKind::parallel, 0, [this](const Vector2d& x) { return determinant(x); }});
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) add_leg(j);
  }

  std::vector<BoundarySegment> trace() {
    map_.visit_undecided_leaves(mode_, [this](const Box& box) { trace_in(box); });
    return std::move(segments_);
  }

 private:
  void add_leg(std::size_t j) {
    const Leg& leg = robot_.leg(j);
    boundaries_.push_back({BoundaryKind::serial, j, [&leg](const Vector2d& x) {
                             return squared_inverse_entry(leg, pose_at(x).transform(leg.anchor));
                           }});
    for (const double limit : {leg.limits.lower, leg.limits.upper})
      if (std::isfinite(limit))
        boundaries_.push_back({BoundaryKind::limit, j, [this, j, limit](const Vector2d& x) {
                                 return drives(x)[static_cast<Eigen::Index>(j)] - limit;
                               }});
  }

  JointVector drives(const Vector2d& x) const {
    JointVector q(robot_.leg_count());
    for (std::size_t j = 0; j < robot_.leg_count(); ++j)
      q[static_cast<Eigen::Index>(j)] =
          drive_value(robot_.leg(j), pose_at(x).transform(robot_.leg(j).anchor), mode_.sign(j));
    return q;
  }

  double determinant(const Vector2d& x) const { return direct_determinant(robot_, pose_at(x), drives(x)); }

  // Two triangles a leaf: linear interpolation in a triangle has no ambiguous case.
  void trace_in(const Box& box) {
    const Vector2d a(box.lower[0], box.lower[1]), b(box.upper[0], box.lower[1]);
    const Vector2d c(box.upper[0], box.upper[1]), d(box.lower[0], box.upper[1]);
    for (const Boundary& boundary : boundaries_) {
      trace_in(boundary, {a, b, c}, box.width(0));
      trace_in(boundary, {a, c, d}, box.width(0));
    }
  }

  void trace_in(const Boundary& boundary, const std::array<Vector2d, 3>& corners, double width) {
    std::array<double, 3> values;
    for (std::size_t i = 0; i < 3; ++i) values[i] = boundary.value(corners[i]);
    std::array<Vector2d, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3 && count < 2; ++i) {
      const double first = values[i], second = values[(i + 1) % 3];
      if ((first > 0.0) == (second > 0.0)) continue;
      ends[count++] = corners[i] + first / (first - second) * (corners[(i + 1) % 3] - corners[i]);
    }
    if (count == 2) keep(boundary, ends[0], ends[1], width);
  }

  void keep(const Boundary& boundary, const Vector2d& from, const Vector2d& to, double width) {
    const Vector2d along = to - from, middle = 0.5 * (from + to);
    if (!(along.norm() > 1e-12 * width) || !on_closure_of_mode(boundary, middle)) return;
    const Vector2d left = Vector2d(-along.y(), along.x()).normalized();
    segments_.push_back({boundary.kind,
                         boundary.leg,
                         from,
                         to,
                         {aspect_beside(middle, left, width), aspect_beside(middle, -left, width)}});
  }

  bool on_closure_of_mode(const Boundary& boundary, const Vector2d& x) const {
    for (const Boundary& other : boundaries_)
      if (other.kind == BoundaryKind::serial &&
          (boundary.kind != BoundaryKind::serial || other.leg != boundary.leg) && !(other.value(x) >= 0.0))
        return false;
    const JointVector q = drives(x);
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      const bool own = boundary.kind == BoundaryKind::limit && boundary.leg == j;
      if (!own && !robot_.leg(j).limits.contain(q[static_cast<Eigen::Index>(j)])) return false;
    }
    return true;
  }

  int aspect_beside(const Vector2d& x, const Vector2d& direction, double width) const {
    for (const double steps : {1.0, 2.0, 4.0}) {
      const Location found = map_.locate(pose_at(x + steps * width * direction), mode_);
      if (found.status == LocationStatus::inside) return found.aspect;
    }
    return 0;
  }

  const AspectMap& map_;
  const Manipulator& robot_;
  const WorkingMode mode_;
  std::vector<Boundary> boundaries_;
  std::vector<BoundarySegment> segments_;
};

}  // namespace

std::vector<BoundarySegment> boundary_segments(const AspectMap& map, const WorkingMode& mode) {
  if (map.manipulator()->task_space() != TaskSpace::T2) return {};
  return Tracer(map, mode).trace();
}

}  // namespace parallel_aspects
