// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/singular_curves.h"

#include "aspects/constraints/constraint_clearance.h"
#include "model/angles.h"
#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

// In coordinates of which each goes over a turn.
constexpr double longest_step = 0.02, shortest_step = 1e-5;
constexpr double farthest_seed = 0.15;  // from the pose that was traced to the curve
constexpr double least_cosine = 0.97;   // between the tangents at both ends of a step
constexpr int most_steps = 10000, most_corrections = 12;
constexpr double correction = 1e-9;   // small enough
constexpr double difference = 1e-5;   // of coordinates, for derivatives
constexpr double dependence = 1e-10;  // of the gradients of the equations
constexpr int buckets = 240;          // a turn, wider than a step
constexpr int grid_of_free_cranks = 120;

int bucket(double angle, int more) {
  const double share = std::remainder(angle, full_turn) / full_turn + 0.5;
  return (static_cast<int>(share * buckets) + more + buckets) % buckets;
}

// The turn of an angle that is inside the limits, or else the angle itself.
double turned_into(const JointLimits& limits, double angle) {
  if (std::isfinite(limits.lower)) return angle + full_turn * std::ceil((limits.lower - angle) / full_turn);
  if (std::isfinite(limits.upper)) return angle + full_turn * std::floor((limits.upper - angle) / full_turn);
  return std::remainder(angle, full_turn);
}

}  // namespace

bool SingularPiece::is_of(const WorkingMode& other) const noexcept {
  WorkingMode same = mode;
  if (kind == BoundaryKind::serial) same.set_sign(leg, other.sign(leg));
  return same == other;
}

SingularCurves::SingularCurves(const AspectMap& map, const JointProjection& projection)
    : robot_(*map.manipulator()),
      projection_(projection),
      slice_(robot_, *map.slice()),
      held_(*map.slice()->joint) {
  const JointWindow& window = projection.window();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const bool is_angle = robot_.leg(projection.legs()[i]).actuated_by_angle();
    units_[i] = is_angle ? 1.0 : (window.upper[k] - window.lower[k]) / full_turn;
  }
}

void SingularCurves::follow(const BoundarySegment& near, const WorkingMode& mode) {
  if (near.kind == BoundaryKind::parallel || near.kind == BoundaryKind::serial)
    follow({near.kind, near.leg}, 0.5 * (near.from + near.to), mode);
}

// The least B_jj^2 of a grid is near each zero of it that no change of its sign shows.
void SingularCurves::follow_free_cranks() {
  constexpr int n = grid_of_free_cranks;
  const auto point = [](int column, int row) {
    return Vector2d(-pi + full_turn * column / n, -pi + full_turn * row / n);
  };
  for (const std::size_t j : projection_.legs()) {
    const Leg& leg = robot_.leg(j);
    if (!leg.kind().has_crank) continue;
    const auto square = [&](int column, int row) {
      return squared_inverse_entry(leg, slice_.pose(point(column, row)).transform(leg.anchor));
    };
    const auto is_least = [&](int column, int row) {
      const double here = square(column, row);
      for (int side = 0; side < 9; ++side)
        if (square(column + side % 3 - 1, row + side / 3 - 1) < here) return false;
      return here >= 0.0;
    };
    for (int cell = 0; cell < n * n; ++cell)
      if (is_least(cell % n, cell / n))
        for (const WorkingMode& mode : working_modes(robot_))
          follow({BoundaryKind::serial, j}, point(cell % n, cell / n), mode);
  }
}

JointVector SingularCurves::actuated(const Coordinates& at) const {
  JointVector q(static_cast<Eigen::Index>(robot_.leg_count()));
  q[static_cast<Eigen::Index>(held_.leg)] = held_.value;
  for (std::size_t i = 0; i < 2; ++i)
    q[static_cast<Eigen::Index>(projection_.legs()[i])] = units_[i] * at[static_cast<Eigen::Index>(2 + i)];
  return q;
}

SingularCurves::Coordinates SingularCurves::coordinates(const Vector2d& point,
                                                        const WorkingMode& mode) const {
  const Pose pose = slice_.pose(point);
  Coordinates at;
  at.head<2>() = point;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t j = projection_.legs()[i];
    const Leg& leg = robot_.leg(j);
    at[static_cast<Eigen::Index>(2 + i)] =
        joint_value(leg, pose.transform(leg.anchor), mode.sign(j)) / units_[i];
  }
  return at;
}

// Of the equations of both legs that move, and of the condition.
Eigen::Vector3d SingularCurves::residual(const Condition& condition, const Coordinates& at) const {
  const Pose pose = slice_.pose(at.head<2>());
  const JointVector q = actuated(at);
  Eigen::Vector3d result;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t j = projection_.legs()[i];
    result[static_cast<Eigen::Index>(i)] = robot_.leg(j).residual(pose, q[static_cast<Eigen::Index>(j)]);
  }
  result[2] = condition.kind == BoundaryKind::parallel
                  ? direct_determinant(robot_, pose, q)
                  : inverse_diagonal(robot_, pose, q)[static_cast<Eigen::Index>(condition.leg)];
  return result;
}

// A row for each coordinate, by differences.
Eigen::Matrix<double, 4, 3> SingularCurves::gradients(const Condition& condition,
                                                      const Coordinates& at) const {
  Eigen::Matrix<double, 4, 3> result;
  for (int k = 0; k < 4; ++k) {
    const Coordinates more = difference * Coordinates::Unit(k);
    const Eigen::Vector3d change = residual(condition, at + more) - residual(condition, at - more);
    result.row(k) = change.transpose() / (2.0 * difference);
  }
  return result;
}

// Newton's method of three equations in four unknowns, by the shortest steps.
std::optional<SingularCurves::Point> SingularCurves::corrected(const Condition& condition,
                                                               Coordinates at) const {
  for (int n = 0; n < most_corrections; ++n) {
    Eigen::Matrix<double, 4, 3> slopes = gradients(condition, at);
    const Eigen::Array3d sizes = slopes.colwise().norm().transpose();
    slopes.array().rowwise() /= sizes.transpose();
    const Eigen::Vector3d value = residual(condition, at).array() / sizes;
    const LineOfSolutions line = line_of_solutions(slopes, value);
    if (!(line.least_pivot > dependence)) return std::nullopt;
    const Coordinates step = -line.nearest;
    if (!(step.norm() < 1.0)) return std::nullopt;
    at += step;
    if (step.norm() < correction) return Point{at, line.along};
  }
  return std::nullopt;
}

void SingularCurves::follow(const Condition& condition, const Vector2d& point, const WorkingMode& mode) {
  const std::optional<Point> start = corrected(condition, coordinates(point, mode));
  if (!start || (start->at.head<2>() - point).norm() > farthest_seed || is_known(condition, start->at))
    return;
  if (!walk(condition, *start, 1.0)) walk(condition, *start, -1.0);
}

// Whether it comes back to the start.
bool SingularCurves::walk(const Condition& condition, const Point& start, double sense) {
  Point here = start;
  Coordinates direction = sense * start.tangent;
  double step = longest_step, length = 0.0;
  for (int n = 0; n < most_steps && step > shortest_step; ++n) {
    const std::optional<Point> next = corrected(condition, here.at + step * direction);
    if (!next || !((next->at - here.at).norm() < 1.5 * step) ||
        !(std::abs(next->tangent.dot(direction)) > least_cosine)) {
      step *= 0.5;
      continue;
    }
    add(condition, here.at, next->at);
    length += (next->at - here.at).norm();
    direction = std::copysign(1.0, next->tangent.dot(direction)) * next->tangent;
    here = *next;
    if (length > 3.0 * longest_step && way(here.at, start.at).norm() < longest_step &&
        sense * direction.dot(start.tangent) > 0.5) {
      add(condition, here.at, start.at);
      return true;
    }
    step = std::min(longest_step, 1.5 * step);
  }
  return false;
}

void SingularCurves::add(const Condition& condition, const Coordinates& from, const Coordinates& to) {
  known_[key(condition, from, 0, 0)].push_back(from);
  const Coordinates along = way(from, to);
  const Coordinates middle = from + 0.5 * along;
  const Pose pose = slice_.pose(middle.head<2>());
  JointVector q = actuated(middle);
  SingularPiece piece{condition.kind, condition.leg, WorkingMode(robot_.leg_count()), {}, {}};
  const TaskVector entries = inverse_diagonal(robot_, pose, q);
  for (std::size_t j = 0; j < robot_.leg_count(); ++j)
    piece.mode.set_sign(j, entries[static_cast<Eigen::Index>(j)] < 0.0 ? -1 : 1);
  if (!fits(pose, q)) return;
  const Vector2d at(q[static_cast<Eigen::Index>(projection_.legs()[0])],
                    q[static_cast<Eigen::Index>(projection_.legs()[1])]);
  const Vector2d change = along.tail<2>().cwiseProduct(Vector2d(units_[0], units_[1]));
  piece.poses = {from.head<2>(), from.head<2>() + along.head<2>()};
  piece.actuated = {at - 0.5 * change, at + 0.5 * change};
  pieces_.push_back(piece);
}

// Turns joint values into their limits; whether the configuration keeps them and all constraints.
bool SingularCurves::fits(const Pose& pose, JointVector& q) const {
  for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
    const Leg& leg = robot_.leg(j);
    double& value = q[static_cast<Eigen::Index>(j)];
    if (leg.actuated_by_angle() && j != held_.leg) value = turned_into(leg.limits, value);
    if (!leg.limits.contain(value) || !leg.can_have(value)) return false;
  }
  return std::all_of(all_constraint_kinds.begin(), all_constraint_kinds.end(), [&](ConstraintKind kind) {
    return !robot_.constraint_kinds()[index_of(kind)] || constraint_clearance(robot_, kind, pose, q) >= 0.0;
  });
}

// To the copy of the end, a number of turns away, that is closest.
SingularCurves::Coordinates SingularCurves::way(const Coordinates& from, const Coordinates& to) const {
  Coordinates result = to - from;
  for (int k = 0; k < 4; ++k)
    if (k < 2 || robot_.leg(projection_.legs()[static_cast<std::size_t>(k - 2)]).actuated_by_angle())
      result[k] = std::remainder(result[k], full_turn);
  return result;
}

SingularCurves::Key SingularCurves::key(const Condition& condition, const Coordinates& at, int right,
                                        int up) const {
  return {condition.kind, condition.leg, bucket(at[0], right), bucket(at[1], up)};
}

bool SingularCurves::is_known(const Condition& condition, const Coordinates& at) const {
  for (int side = 0; side < 9; ++side) {
    const auto found = known_.find(key(condition, at, side % 3 - 1, side / 3 - 1));
    if (found == known_.end()) continue;
    for (const Coordinates& each : found->second)
      if (way(each, at).norm() < 0.75 * longest_step) return true;
  }
  return false;
}

}  // namespace parallel_aspects
