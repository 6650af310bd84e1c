// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_SOLUTION_PROOF_H
#define PARALLEL_ASPECTS_ARMS_SOLUTION_PROOF_H

#include "interval/dual.h"
#include "interval/interval.h"
#include "parallel_aspects/arms/serial_arm.h"

#include "arms/arm_determinant.h"
#include <array>
#include <vector>

namespace parallel_aspects {

/// Krawczyk's test of inverse solutions: whether exactly one is in a small box about joint values.
class SolutionProof {
 public:
  /// For this frame of the operational point.
  SolutionProof(const SerialArm& arm, const Eigen::Isometry3d& tip);

  /// Whether it is proved that in a box of half width 1e-6 rad (or of the reach), or a smaller one, there is
  /// exactly one solution.
  bool has_one_near(const Eigen::VectorXd& q) const;

 private:
  using Number = Dual<max_arm_joints, Interval>;
  using Numbers = std::array<Number, 3>;
  struct Frame {
    std::array<Numbers, 3> axes;  // columns
    Numbers origin;
  };

  std::vector<Number> equations(const Eigen::VectorXd& q, double half) const;
  Frame tip_over(const Eigen::VectorXd& q, double half) const;
  bool is_unique_within(const Eigen::VectorXd& q, double half) const;

  const SerialArm& arm_;
  Eigen::Isometry3d goal_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_SOLUTION_PROOF_H
