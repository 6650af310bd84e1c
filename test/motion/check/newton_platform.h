// SPDX-License-Identifier: BSD-3-Clause
// Trajectories of actuated joints followed by Newton's method in extended precision, by formulas of the
// tests' own.
#ifndef PARALLEL_ASPECTS_TEST_MOTION_CHECK_NEWTON_PLATFORM_H
#define PARALLEL_ASPECTS_TEST_MOTION_CHECK_NEWTON_PLATFORM_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

namespace parallel_aspects::test {

using Number = long double;
using Vector = Eigen::Matrix<Number, 3, 1>;
using Numbers = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
using JointWaypoints = std::vector<JointWaypoint>;

constexpr double never = std::numeric_limits<double>::infinity();

// f_j of a leg in extended precision, from the dimensions alone.
inline Number residual(const Leg& leg, const Vector& anchor, Number q) {
  struct Distance {
    const Leg& leg;
    Vector anchor;
    Number q;
    Number operator()(const RevoluteActuation& crank) const {
      const Vector e1 = crank.zero_direction.cast<Number>(), e2 = crank.axis.cast<Number>().cross(e1);
      const Vector tip = crank.center.cast<Number>() + crank.radius * (std::cos(q) * e1 + std::sin(q) * e2);
      return (anchor - tip).squaredNorm() - Number(leg.rod_length) * leg.rod_length;
    }
    Number operator()(const PrismaticActuation& rail) const {
      return (anchor - rail.origin.cast<Number>() - q * rail.direction.cast<Number>()).squaredNorm() -
             Number(leg.rod_length) * leg.rod_length;
    }
    Number operator()(const StrutActuation& strut) const {
      const Number length = strut.length_at_zero + strut.sense * q;
      return (anchor - strut.base.cast<Number>()).squaredNorm() - length * length;
    }
    Number operator()(const ElbowActuation&) const { return 0; }
  };
  return std::visit(Distance{leg, anchor, q}, leg.actuation);
}

// Follows the platform by Newton's method in small steps; derivatives are central differences.
class Platform {
 public:
  Platform(const Manipulator& robot, const Pose& pose)
      : robot_(robot),
        n_(static_cast<Eigen::Index>(robot.leg_count())),
        position_(pose.position.cast<Number>()),
        turn_(pose.orientation.toRotationMatrix().cast<Number>()) {}

  // False where Newton's method goes far or does not converge, or where the slopes change by so much that it
  // may have slipped to another assembly mode: those meet where the slopes are singular.
  bool follow(const Numbers& q, Number most_change = 0.5L) {
    Number moved = 0;
    const Matrix before = slopes(q);
    for (int i = 0; i < 30; ++i) {
      const Numbers off = residuals(q, Numbers::Zero(n_));
      const Numbers step = -(slopes(q).partialPivLu().solve(off));
      if (!step.allFinite()) return false;
      moved += step.norm();
      place(step, position_, turn_);
      if (step.norm() < 1e-15L * robot_.get().size())
        return moved < 0.003L * robot_.get().size() &&
               (before.partialPivLu().solve(slopes(q)) - Matrix::Identity(n_, n_)).norm() < most_change;
    }
    return false;
  }

  Number determinant(const Numbers& q) const { return slopes(q).determinant(); }

  // -df/dq, which has the sign of B_jj.
  Number entry(std::size_t j, Number q) const {
    const Leg& leg = robot_.get().leg(j);
    const Vector anchor = position_ + turn_ * leg.anchor.cast<Number>();
    return (residual(leg, anchor, q - h) - residual(leg, anchor, q + h)) / (2 * h);
  }

 private:
  static constexpr Number h = 1e-6L;

  // By rotation vector and displacement, as far as the space moves.
  void place(const Numbers& step, Vector& position, Eigen::Matrix<Number, 3, 3>& turn) const {
    Vector w = Vector::Zero(), v = Vector::Zero();
    switch (robot_.get().task_space()) {
      case TaskSpace::SE2:
        w.z() = step[0];
        v.head<2>() = step.tail<2>();
        break;
      case TaskSpace::SO3:
        w = step;
        break;
      case TaskSpace::SE3:
        w = step.head<3>();
        v = step.tail<3>();
        break;
      case TaskSpace::T1:
      case TaskSpace::T2:
      case TaskSpace::T3:
        v.head(n_) = step;
        break;
      case TaskSpace::R1:
      case TaskSpace::R2:
        throw std::logic_error("platforms on hinges are not looked at here");
    }
    position += v;
    if (w.norm() > 0) turn = Eigen::AngleAxis<Number>(w.norm(), w.normalized()).toRotationMatrix() * turn;
  }

  Numbers residuals(const Numbers& q, const Numbers& step) const {
    Vector position = position_;
    Eigen::Matrix<Number, 3, 3> turn = turn_;
    place(step, position, turn);
    Numbers values(n_);
    for (Eigen::Index j = 0; j < n_; ++j) {
      const Leg& leg = robot_.get().leg(static_cast<std::size_t>(j));
      values[j] = residual(leg, position + turn * leg.anchor.cast<Number>(), q[j]);
    }
    return values;
  }

  Matrix slopes(const Numbers& q) const {
    Matrix matrix(n_, n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
      const Numbers step = h * Numbers::Unit(n_, k);
      matrix.col(k) = (residuals(q, step) - residuals(q, -step)) / (2 * h);
    }
    return matrix;
  }

  std::reference_wrapper<const Manipulator> robot_;
  Eigen::Index n_;
  Vector position_;
  Eigen::Matrix<Number, 3, 3> turn_;
};

// Between two waypoints, by the conditions at both ends: a linear system for the coefficients.
inline Numbers values_at(const JointWaypoint& from, const JointWaypoint& to, Number time) {
  const bool velocities = from.velocity.size() > 0 && to.velocity.size() > 0;
  const bool accelerations = velocities && from.acceleration.size() > 0 && to.acceleration.size() > 0;
  const Eigen::Index order = accelerations ? 3 : velocities ? 2 : 1, size = 2 * order;
  const Number duration = Number(to.time) - from.time, at = time - from.time;
  Matrix conditions(size, size);
  for (Eigen::Index k = 0; k < order; ++k)
    for (Eigen::Index i = 0; i < size; ++i) {
      Number factor = i >= k ? 1 : 0;
      for (Eigen::Index m = 0; m < k; ++m) factor *= Number(i - m);
      conditions(k, i) = i == k ? factor : 0;
      conditions(order + k, i) = i >= k ? factor * std::pow(duration, Number(i - k)) : 0;
    }
  Numbers result(from.q.size());
  for (Eigen::Index j = 0; j < from.q.size(); ++j) {
    Numbers ends(size);
    ends[0] = from.q[j], ends[order] = to.q[j];
    if (order > 1) ends[1] = from.velocity[j], ends[order + 1] = to.velocity[j];
    if (order > 2) ends[2] = from.acceleration[j], ends[order + 2] = to.acceleration[j];
    const Numbers coefficients = conditions.fullPivLu().solve(ends);
    Number sum = 0;
    for (Eigen::Index i = size; i-- > 0;) sum = sum * at + coefficients[i];
    result[j] = sum;
  }
  return result;
}

struct Seen {
  double violation = never;  // of the first sample that has one
  double lost = never;       // where Newton's method lost the platform
};

inline bool has_violation(const Manipulator& robot, const Platform& platform, const Numbers& q,
                          const std::vector<Number>& entries, Number determinant) {
  for (std::size_t j = 0; j < entries.size(); ++j) {
    const Number value = q[static_cast<Eigen::Index>(j)];
    const JointLimits& limits = robot.leg(j).limits;
    if (platform.entry(j, value) * entries[j] < 0 || value < limits.lower - 1e-12L ||
        value > limits.upper + 1e-12L)
      return true;
  }
  return platform.determinant(q) * determinant < 0;
}

constexpr int halvings = 24;  // of a step, as near as a fold can be followed

// Halves what is too far for Newton's method.
inline bool advance(Platform& platform, const JointWaypoint& from, const JointWaypoint& to, Number begin,
                    Number end, int depth) {
  Platform there = platform;
  if (there.follow(values_at(from, to, end))) {
    platform = there;
    return true;
  }
  const Number middle = (begin + end) / 2;
  return depth > 0 && advance(platform, from, to, begin, middle, depth - 1) &&
         advance(platform, from, to, middle, end, depth - 1);
}

// At the start only the rounding of the pose is taken away, whatever that changes next to det A = 0.
inline bool begin(Platform& platform, const JointWaypoint& first) {
  return platform.follow(first.q.cast<Number>(), 1e9L);
}

inline Seen watch(const Manipulator& robot, const JointWaypoints& waypoints, const Pose& start, int samples) {
  Platform platform(robot, start);
  if (!begin(platform, waypoints.front())) return {};  // too near to det A = 0 to say anything
  std::vector<Number> entries;
  Number determinant = 0;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
    for (int k = 0; k <= samples; ++k) {
      const JointWaypoint &from = waypoints[i], &to = waypoints[i + 1];
      const double time = from.time + (to.time - from.time) * k / samples;
      const Numbers q = values_at(from, to, time);
      const double before = from.time + (to.time - from.time) * std::max(0, k - 1) / samples;
      if (!advance(platform, from, to, before, time, halvings)) return {never, time};
      if (entries.empty()) {
        determinant = platform.determinant(q);
        for (std::size_t j = 0; j < robot.leg_count(); ++j)
          entries.push_back(platform.entry(j, q[static_cast<Eigen::Index>(j)]));
      }
      if (has_violation(robot, platform, q, entries, determinant)) return {time, never};
    }
  return {};
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_MOTION_CHECK_NEWTON_PLATFORM_H
