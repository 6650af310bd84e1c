// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_INDEX_AT_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_INDEX_AT_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace parallel_aspects::test {

/// A second way to the indices of singularities, in extended precision.
class IndexAt {
 public:
  using Number = long double;
  using Vector = Eigen::Matrix<Number, 3, 1>;
  using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;

  IndexAt(const Manipulator& robot, const Pose& pose, const JointVector& q);

  /// The volume that unit rows span: the root of the determinant of their products.
  Number parallel() const;

  Number determinant() const { return std::abs(signed_determinant()); }

  Number signed_determinant() const;

  /// Of the leg that is nearest to a serial singularity: the sine of an angle, or 1.
  Number serial() const;

 private:
  std::size_t rotations() const { return rotational_degrees_of_freedom(robot_.task_space()); }
  bool moves() const { return robot_.leg_count() > rotations(); }

  Number length() const;

  /// Moments over the characteristic length.
  Matrix all_rows() const;

  Number sine(std::size_t j) const;

  const Manipulator& robot_;
  Eigen::Matrix<Number, 3, 3> turned_;
  const JointVector& q_;
  Vector middle_ = Vector::Zero();
  std::vector<Vector> anchors_, rods_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_INDEX_AT_H
