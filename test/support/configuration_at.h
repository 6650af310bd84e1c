// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_CONFIGURATION_AT_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_CONFIGURATION_AT_H

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <stdexcept>

namespace parallel_aspects::test {

/// A second way from a pose and a working mode to joint values and indices, with nothing of the library but
/// the dimensions of the robot. Legs with an actuated elbow are left out. For double and long double.
template <class Number>
class ConfigurationAt {
 public:
  using Vector = Eigen::Matrix<Number, 3, 1>;
  using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

  ConfigurationAt(const Manipulator& robot, const Pose& pose, const WorkingMode& mode);

  /// How far the leg that is nearest to a serial singularity is from it: the square of a sine, negative out
  /// of reach.
  Number squared_serial() const { return squared_serial_; }
  bool reaches() const { return squared_serial_ > 0; }

  /// By how much the actuated joint nearest to a limit is within its range; of those that have one.
  Number within_limits() const;

  /// det A over the product of the norms of its rows, with its sign.
  Number parallel() const;

  /// det A, with moments about the operational point.
  Number determinant() const;

 private:
  using Rotation = Eigen::Matrix<Number, 3, 3>;

  static Rotation rotation(const Eigen::Quaterniond& quaternion);

  static Number squared(Number value) { return value * value; }

  /// The square of a sine, from which the root is taken.
  Number entry(Number square);

  /// The elbow is on one side of the line from the centre to the anchor or on the other: B_jj = u.c' turns.
  Vector rod(const RevoluteActuation& crank);

  Vector rod(const PrismaticActuation& rail);

  Vector rod(const StrutActuation& strut);

  Vector rod(const ElbowActuation&) { throw std::logic_error("an elbow has no formula here"); }

  /// An angle counts with all its full turns.
  Number within(std::size_t j, Number value, const JointLimits& limits) const;

  std::size_t rotations() const { return rotational_degrees_of_freedom(robot_.task_space()); }
  bool moves() const { return robot_.leg_count() > rotations(); }

  Vector middle() const;

  Number length() const;

  /// Moments about the middle of the anchors, over their root mean square distance from it.
  Matrix rows() const;

  static Number determinant_of(const Matrix& m);

  const Manipulator& robot_;
  Rotation turned_;
  std::array<Vector, 6> rods_;
  std::array<Number, 6> q_{};
  Number squared_serial_ = 1;

  // Of the leg that is examined.
  const Leg* leg_ = nullptr;
  Vector anchor_;
  Number sign_ = 1, value_ = 0;
};

extern template class ConfigurationAt<double>;
extern template class ConfigurationAt<long double>;

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_CONFIGURATION_AT_H
