// SPDX-License-Identifier: BSD-3-Clause
#include "support/configuration_at.h"

#include "support/elimination.h"
#include <algorithm>
#include <cmath>
#include <variant>

namespace parallel_aspects::test {

template <class Number>
ConfigurationAt<Number>::ConfigurationAt(const Manipulator& robot, const Pose& pose, const WorkingMode& mode)
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

template <class Number>
Number ConfigurationAt<Number>::within_limits() const {
  Number least = 1;
  for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
    const JointLimits& limits = robot_.leg(j).limits;
    if (limits.limited()) least = std::min(least, within(j, q_[j], limits));
  }
  return least;
}

template <class Number>
Number ConfigurationAt<Number>::parallel() const {
  if (robot_.task_space() == TaskSpace::T1) return rods_[0].x() / rods_[0].norm();
  Matrix matrix = rows();
  for (Eigen::Index j = 0; j < matrix.rows(); ++j) matrix.row(j) /= matrix.row(j).norm();
  return determinant_of(matrix);
}

template <class Number>
Number ConfigurationAt<Number>::determinant() const {
  if (robot_.task_space() == TaskSpace::T1) return rods_[0].x();
  return std::pow(length(), static_cast<Number>(rotations())) * determinant_of(rows());
}

template <class Number>
typename ConfigurationAt<Number>::Rotation ConfigurationAt<Number>::rotation(
    const Eigen::Quaterniond& quaternion) {
  return Eigen::Quaternion<Number>(static_cast<Number>(quaternion.w()), static_cast<Number>(quaternion.x()),
                                   static_cast<Number>(quaternion.y()), static_cast<Number>(quaternion.z()))
      .toRotationMatrix();
}

template <class Number>
Number ConfigurationAt<Number>::entry(Number square) {
  squared_serial_ = std::min(squared_serial_, square);
  return sign_ * std::sqrt(std::max(square, Number(0)));
}

template <class Number>
typename ConfigurationAt<Number>::Vector ConfigurationAt<Number>::rod(const RevoluteActuation& crank) {
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

template <class Number>
typename ConfigurationAt<Number>::Vector ConfigurationAt<Number>::rod(const PrismaticActuation& rail) {
  const Vector direction = rail.direction.cast<Number>(), d = anchor_ - rail.origin.cast<Number>();
  const Number along = d.dot(direction), l = leg_->rod_length;
  value_ = along - entry(1 - (d.squaredNorm() - along * along) / (l * l)) * l;
  return d - value_ * direction;
}

template <class Number>
typename ConfigurationAt<Number>::Vector ConfigurationAt<Number>::rod(const StrutActuation& strut) {
  const Vector d = anchor_ - strut.base.cast<Number>();
  value_ = (d.norm() - static_cast<Number>(strut.length_at_zero)) * static_cast<Number>(strut.sense);
  return d;
}

template <class Number>
Number ConfigurationAt<Number>::within(std::size_t j, Number value, const JointLimits& limits) const {
  const Number turn = robot_.leg(j).actuated_by_angle() ? 2 * static_cast<Number>(EIGEN_PI) : 0;
  Number best = -1e300;
  for (int n = -2; n <= 2; ++n)
    best = std::max(best, std::min(value + n * turn - static_cast<Number>(limits.lower),
                                   static_cast<Number>(limits.upper) - value - n * turn));
  return best;
}

template <class Number>
typename ConfigurationAt<Number>::Vector ConfigurationAt<Number>::middle() const {
  Vector sum = Vector::Zero();
  if (!moves()) return sum;
  for (const Leg& leg : robot_.legs()) sum += leg.anchor.cast<Number>();
  return sum / static_cast<Number>(robot_.leg_count());
}

template <class Number>
Number ConfigurationAt<Number>::length() const {
  if (!moves() || rotations() == 0) return 1;
  Number sum = 0;
  for (const Leg& leg : robot_.legs()) sum += (leg.anchor.cast<Number>() - middle()).squaredNorm();
  return std::sqrt(sum / static_cast<Number>(robot_.leg_count()));
}

template <class Number>
typename ConfigurationAt<Number>::Matrix ConfigurationAt<Number>::rows() const {
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

template <class Number>
Number ConfigurationAt<Number>::determinant_of(const Matrix& m) {
  if (m.rows() == 2) return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  if (m.rows() != 3) return determinant_by_elimination(m);
  return m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
         m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
         m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
}

template class ConfigurationAt<double>;
template class ConfigurationAt<long double>;

}  // namespace parallel_aspects::test
