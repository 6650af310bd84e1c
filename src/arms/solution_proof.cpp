// SPDX-License-Identifier: BSD-3-Clause
#include "arms/solution_proof.h"

#include "interval/half_turns.h"

#include <Eigen/LU>

#include <cmath>

namespace parallel_aspects {
namespace {

using Number = Dual<max_arm_joints, Interval>;
using Numbers = std::array<Number, 3>;

Numbers constants(const Eigen::Vector3d& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }

Number dot(const Numbers& a, const Eigen::Vector3d& b) {
  return Interval(b.x()) * a[0] + Interval(b.y()) * a[1] + Interval(b.z()) * a[2];
}

Numbers combined(const Number& a, const Numbers& u, const Number& b, const Numbers& v) {
  return {a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
}

Numbers moved(const Numbers& from, const Interval& by, const Numbers& along) {
  return {from[0] + by * along[0], from[1] + by * along[1], from[2] + by * along[2]};
}

Numbers placed(const std::array<Numbers, 3>& axes, const Eigen::Vector3d& v) {
  return moved(moved(moved(constants(Eigen::Vector3d::Zero()), v.x(), axes[0]), v.y(), axes[1]), v.z(),
               axes[2]);
}

}  // namespace

SolutionProof::SolutionProof(const SerialArm& arm, const Eigen::Isometry3d& tip) : arm_(arm), goal_(tip) {}

SolutionProof::Frame SolutionProof::tip_over(const Eigen::VectorXd& q, double half) const {
  const Eigen::Isometry3d& base = arm_.base();
  Frame frame{
      {constants(base.linear().col(0)), constants(base.linear().col(1)), constants(base.linear().col(2))},
      constants(base.translation())};
  for (std::size_t i = 0; i < arm_.size(); ++i) {
    const ArmJoint& joint = arm_.joints()[i];
    const double value = q[static_cast<Eigen::Index>(i)];
    const Interval range(-(half - value), value + half);
    const Turn<Interval> turn =
        joint.turns ? enclosed_turn(joint.turn.value(), 1.0, range) : enclosed_turn(joint.turn.value());
    Number cosine(turn.cosine), sine(turn.sine), offset(Interval(1e-9 * static_cast<double>(joint.offset)));
    if (joint.turns) {
      cosine.gradient[i] = -turn.sine;
      sine.gradient[i] = turn.cosine;
    } else {
      offset = offset + Number::coordinate(range, i);
    }
    const Numbers x = combined(cosine, frame.axes[0], sine, frame.axes[1]),
                  y = combined(-sine, frame.axes[0], cosine, frame.axes[1]), z = frame.axes[2];
    const Numbers up = combined(offset, z, Number(0.0), z);
    for (std::size_t k = 0; k < 3; ++k) frame.origin[k] = frame.origin[k] + up[k];
    frame.origin = moved(frame.origin, Interval(1e-9 * static_cast<double>(joint.length)), x);
    const Turn<Interval> twist = enclosed_turn(joint.twist.value());
    frame.axes = {x, combined(Number(twist.cosine), y, Number(twist.sine), z),
                  combined(Number(-twist.sine), y, Number(twist.cosine), z)};
  }
  const Eigen::Isometry3d& tool = arm_.tool();
  const Numbers shift = placed(frame.axes, tool.translation());
  Frame tip{{placed(frame.axes, tool.linear().col(0)), placed(frame.axes, tool.linear().col(1)),
             placed(frame.axes, tool.linear().col(2))},
            frame.origin};
  for (std::size_t k = 0; k < 3; ++k) tip.origin[k] = tip.origin[k] + shift[k];
  return tip;
}

// As many as the task has coordinates. Near the goal they vanish where the task is done and nowhere else: the
// frame is turned by far less than half a turn.
std::vector<SolutionProof::Number> SolutionProof::equations(const Eigen::VectorXd& q, double half) const {
  const Frame at = tip_over(q, half);
  const Eigen::Matrix3d& wanted = goal_.linear();
  const Eigen::Matrix3d& plane = arm_.plane();
  const auto along = [&](const Eigen::Vector3d& direction) {
    return dot(at.origin, direction) -
           Number(Interval(0.0) + Interval(direction.x()) * Interval(goal_.translation().x()) +
                  Interval(direction.y()) * Interval(goal_.translation().y()) +
                  Interval(direction.z()) * Interval(goal_.translation().z()));
  };
  // (R x) . y - (R y) . x of axes in the goal's frame: twice the sine of a turn about their common normal.
  const auto turned = [&](std::size_t a, std::size_t b) {
    return dot(at.axes[a], wanted.col(static_cast<Eigen::Index>(b))) -
           dot(at.axes[b], wanted.col(static_cast<Eigen::Index>(a)));
  };
  const auto about = [&](const Eigen::Vector3d& axis) {
    Number sum(0.0);
    const Eigen::Vector3d in_tip = wanted.transpose() * axis;
    sum = sum + Interval(in_tip.x()) * turned(1, 2) + Interval(in_tip.y()) * turned(2, 0) +
          Interval(in_tip.z()) * turned(0, 1);
    return sum;
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  switch (arm_.task()) {
    case ArmTask::plane_position:
      return {along(plane.col(0)), along(plane.col(1))};
    case ArmTask::plane_pose:
      return {along(plane.col(0)), along(plane.col(1)), about(plane.col(2))};
    case ArmTask::position:
      return {along(x), along(y), along(z)};
    case ArmTask::orientation:
      return {turned(0, 1), turned(1, 2), turned(2, 0)};
    case ArmTask::direction:
      return {dot(at.axes[2], wanted.col(0)), dot(at.axes[2], wanted.col(1))};
    case ArmTask::position_and_turn:
      return {along(x), along(y), along(z), about(plane.col(2))};
    case ArmTask::position_and_direction:
      return {along(x), along(y), along(z), dot(at.axes[2], wanted.col(0)), dot(at.axes[2], wanted.col(1))};
    case ArmTask::pose:
      break;
  }
  return {along(x), along(y), along(z), turned(0, 1), turned(1, 2), turned(2, 0)};
}

bool SolutionProof::is_unique_within(const Eigen::VectorXd& q, double half) const {
  const std::vector<Number> over = equations(q, half), at = equations(q, 0.0);
  const std::size_t count = over.size();
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd middle(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index k = 0; k < size; ++k) {
      const Interval& each = over[static_cast<std::size_t>(i)].gradient[static_cast<std::size_t>(k)];
      middle(i, k) = 0.5 * (each.lower() + each.upper());
    }
  const Eigen::MatrixXd inverse = middle.inverse();
  if (!inverse.allFinite()) return false;
  for (std::size_t row = 0; row < count; ++row) {
    Interval image(0.0);  // from the middle
    for (std::size_t i = 0; i < count; ++i)
      image = image -
              Interval(inverse(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i))) * at[i].value;
    for (std::size_t k = 0; k < count; ++k) {
      Interval entry(row == k ? 1.0 : 0.0);
      for (std::size_t i = 0; i < count; ++i)
        entry = entry - Interval(inverse(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i))) *
                            over[i].gradient[k];
      image = image + entry * Interval(-half, half);
    }
    if (!(image.lower() > -half && image.upper() < half)) return false;
  }
  return true;
}

bool SolutionProof::has_one_near(const Eigen::VectorXd& q) const {
  const RoundingUpward rounding;
  for (double half = 1e-6; half > 1e-10; half *= 0.1)
    if (is_unique_within(q, half)) return true;
  return false;
}

}  // namespace parallel_aspects
