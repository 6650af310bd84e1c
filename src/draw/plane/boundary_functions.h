// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PLANE_BOUNDARY_FUNCTIONS_H
#define PARALLEL_ASPECTS_DRAW_PLANE_BOUNDARY_FUNCTIONS_H

#include "draw/plane/map_pictures.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// The functions of a pose whose zeros bound the aspects of one working mode, for drawing: det A, then each
/// B_jj^2, then the distance of each limited actuated joint from its limits, then how far each other
/// constraint is from being broken. In an aspect all are positive, but det A, which has the aspect's sign.
/// Where a joint is held, its value is that everywhere, and the pose decides the sign of its B_jj: so there
/// B_jj stands in place of its square, times the sign that it has in the working mode.
class BoundaryFunctions {
 public:
  struct Function {
    BoundaryKind kind;
    std::size_t leg;
  };
  static constexpr int most = 1 + 6 + 12 + static_cast<int>(all_constraint_kinds.size());
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;

  /// The manipulator must outlive the object.
  BoundaryFunctions(const Manipulator& manipulator, const WorkingMode& mode,
                    const std::optional<HeldJoint>& held = std::nullopt);

  const std::vector<Function>& list() const noexcept { return functions_; }

  Values values(const Pose& pose) const;

 private:
  void add_limits(const JointVector& q, Values& result) const;

  const Manipulator& robot_;
  const WorkingMode mode_;
  const std::optional<HeldJoint> held_;
  std::vector<Function> functions_;
  std::vector<ConstraintKind> constraints_;  // of the last functions
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PLANE_BOUNDARY_FUNCTIONS_H
