// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_JOINT_SEGMENT_H
#define PARALLEL_ASPECTS_ARMS_JOINT_SEGMENT_H

#include "parallel_aspects/arms/serial_arm.h"

#include <Eigen/Core>

#include "arms/arm_determinant.h"
#include "arms/factor_enclosure.h"
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// What is known of a straight segment of joint values.
struct JointSegmentVerdict {
  std::optional<bool> has_singularity;  ///< nothing where it is not decided
  std::size_t pieces = 0;               ///< that det J was enclosed over
};

/// Proves segments of joint values free of singularities, by enclosures of the factors of det J over pieces
/// of them. Safe to share between threads.
class JointSegments {
 public:
  explicit JointSegments(const SerialArm& arm, const ArmDeterminant& determinant);

  /// From `from` to `to`, as they are: a difference may be more than half a turn.
  JointSegmentVerdict verdict(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;

  /// Signs of all factors there, 1 or -1, by groups; nothing where one is not proved.
  std::optional<std::vector<int>> signs(const Eigen::VectorXd& q) const;

  /// The sign of det J that these make.
  int determinant_sign(const std::vector<int>& signs) const noexcept;

 private:
  JointNumbers<Affine<1>> numbers(const Eigen::VectorXd& from, const Eigen::VectorXd& to, double start,
                                  double end) const;

  const int sign_;
  std::vector<bool> turns_;
  std::vector<EnclosedPolynomial> factors_;
};

/// `to` moved by whole turns of joints that turn freely, so that no difference to `from` is more than half a
/// turn.
Eigen::VectorXd short_way_round(const SerialArm& arm, const Eigen::VectorXd& from, Eigen::VectorXd to);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_JOINT_SEGMENT_H
