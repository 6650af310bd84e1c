// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_CONFIGURATION_AT_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_CONFIGURATION_AT_H

#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace parallel_aspects::test {

/// A second way from a pose and a working mode to joint values and indices, with nothing of the library but
/// the dimensions of the robot. Legs with an actuated elbow are left out.
template <class Number>
class ConfigurationAt {
 public:
  using Vector = Eigen::Matrix<Number, 3, 1>;
  using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

  ConfigurationAt(const Manipulator& robot, const Pose& pose, const WorkingMode& mode)
      : robot_(robot), turned_(rotation(pose.orientation)) {
    for (std::size_t j = 0; j < robot.leg_count(); ++j) {
      const Leg& leg = robot.leg(j);
      anchor_ = pose.position.cast<Number>() + turned_ * leg.anchor.cast<Number>();
      leg_ = &leg;
      sign_ = static_cast<Number>(mode.sign(j));
      rods_[j] = std::visit([this](const auto& actuation) { return rod(actuation); }, leg.actuation);
      q_[j] = value_;
    }
  }

  /// How far the leg that is nearest to a serial singularity is from it: the square of a sine, negative out
  /// of reach.
  Number squared_serial() const { return squared_serial_; }
  bool reaches() const { return squared_serial_ > 0; }

  /// By how much the actuated joint nearest to a limit is within its range; of those that have one.
  Number within_limits() const {
    Number least = 1;
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      const JointLimits& limits = robot_.leg(j).limits;
      if (limits.limited()) least = std::min(least, within(j, q_[j], limits));
    }
    return least;
  }

  /// det A over the product of the norms of its rows, with its sign.
  Number parallel() const {
    if (robot_.task_space() == TaskSpace::T1) return rods_[0].x() / rods_[0].norm();
    Matrix matrix = rows();
    for (Eigen::Index j = 0; j < matrix.rows(); ++j) matrix.row(j) /= matrix.row(j).norm();
    return determinant_of(matrix);
  }

  /// det A, with moments about the operational point.
  Number determinant() const {
    if (robot_.task_space() == TaskSpace::T1) return rods_[0].x();
    return std::pow(length(), static_cast<Number>(rotations())) * determinant_of(rows());
  }

 private:
  using Rotation = Eigen::Matrix<Number, 3, 3>;

  static Rotation rotation(const Eigen::Quaterniond& quaternion) {
    return Eigen::Quaternion<Number>(static_cast<Number>(quaternion.w()), static_cast<Number>(quaternion.x()),
                                     static_cast<Number>(quaternion.y()), static_cast<Number>(quaternion.z()))
        .toRotationMatrix();
  }

  static Number squared(Number value) { return value * value; }

  /// The square of a sine, from which the root is taken.
  Number entry(Number square) {
    squared_serial_ = std::min(squared_serial_, square);
    return sign_ * std::sqrt(std::max(square, Number(0)));
  }

  /// The elbow is on one side of the line from the centre to the anchor or on the other: B_jj = u.c' turns.
  Vector rod(const RevoluteActuation& crank) {
    const Vector axis = crank.axis.cast<Number>(), d = anchor_ - crank.center.cast<Number>();
    const Vector flat = d - d.dot(axis) * axis, across = axis.cross(flat);
    const Number r = crank.radius, l = leg_->rod_length;
    const Number square = flat.squaredNorm();
    const Number along = (d.squaredNorm() + r * r - l * l) / 2;  // of the crank, times flat
    const Number height = entry((r * r * square - along * along) / squared(r * l)) * r * l;
    const Vector arm = (along * flat - height * across) / square;
    const Vector zero = crank.zero_direction.cast<Number>();
    value_ = std::atan2(axis.cross(zero).dot(arm), zero.dot(arm));
    return d - arm;
  }

  Vector rod(const PrismaticActuation& rail) {
    const Vector direction = rail.direction.cast<Number>(), d = anchor_ - rail.origin.cast<Number>();
    const Number along = d.dot(direction), l = leg_->rod_length;
    value_ = along - entry(1 - (d.squaredNorm() - along * along) / (l * l)) * l;
    return d - value_ * direction;
  }

  Vector rod(const StrutActuation& strut) {
    const Vector d = anchor_ - strut.base.cast<Number>();
    value_ = (d.norm() - static_cast<Number>(strut.length_at_zero)) * static_cast<Number>(strut.sense);
    return d;
  }

  Vector rod(const ElbowActuation&) { throw std::logic_error("an elbow has no formula here"); }

  /// An angle counts with all its full turns.
  Number within(std::size_t j, Number value, const JointLimits& limits) const {
    const Number turn = robot_.leg(j).actuated_by_angle() ? 2 * static_cast<Number>(EIGEN_PI) : 0;
    Number best = -1e300;
    for (int n = -2; n <= 2; ++n)
      best = std::max(best, std::min(value + n * turn - static_cast<Number>(limits.lower),
                                     static_cast<Number>(limits.upper) - value - n * turn));
    return best;
  }

  std::size_t rotations() const { return rotational_degrees_of_freedom(robot_.task_space()); }
  bool moves() const { return robot_.leg_count() > rotations(); }

  Vector middle() const {
    Vector sum = Vector::Zero();
    if (!moves()) return sum;
    for (const Leg& leg : robot_.legs()) sum += leg.anchor.cast<Number>();
    return sum / static_cast<Number>(robot_.leg_count());
  }

  Number length() const {
    if (!moves() || rotations() == 0) return 1;
    Number sum = 0;
    for (const Leg& leg : robot_.legs()) sum += (leg.anchor.cast<Number>() - middle()).squaredNorm();
    return std::sqrt(sum / static_cast<Number>(robot_.leg_count()));
  }

  /// Moments about the middle of the anchors, over their root mean square distance from it.
  Matrix rows() const {
    const auto n = static_cast<Eigen::Index>(robot_.leg_count()),
               turning = static_cast<Eigen::Index>(rotations());
    const Vector center = middle();
    const Number over_length = 1 / length();
    Matrix rows(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Vector& u = rods_[static_cast<std::size_t>(j)];
      if (turning > 0) {
        const Vector from = robot_.leg(static_cast<std::size_t>(j)).anchor.cast<Number>() - center;
        const Vector moment = (turned_ * from).cross(u) * over_length;
        for (Eigen::Index i = 0; i < turning; ++i) rows(j, i) = moment[3 - turning + i];
      }
      for (Eigen::Index i = turning; i < n; ++i) rows(j, i) = u[i - turning];
    }
    return rows;
  }

  static Number determinant_of(const Matrix& m) {
    if (m.rows() == 2) return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    if (m.rows() != 3) return m.determinant();
    return m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
           m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
           m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
  }

  const Manipulator& robot_;
  Rotation turned_;
  std::array<Vector, 6> rods_;
  std::array<Number, 6> q_{};
  Number squared_serial_ = 1;

  // Of the leg that is looked at.
  const Leg* leg_ = nullptr;
  Vector anchor_;
  Number sign_ = 1, value_ = 0;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_CONFIGURATION_AT_H
