// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/boundary_functions.h"

#include "aspects/constraints/constraint_clearance.h"
#include "draw/plane/palette.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
BoundaryFunctions::BoundaryFunctions(const Manipulator& manipulator, const WorkingMode& mode,
                                     const std::optional<HeldJoint>& held)
    : robot_(manipulator), mode_(mode), held_(held), functions_{{BoundaryKind::parallel, 0}} {
  for (std::size_t j = 0; j < robot_.leg_count(); ++j) functions_.push_back({BoundaryKind::serial, j});
  for (std::size_t j = 0; j < robot_.leg_count(); ++j)
    for (const double limit : {robot_.leg(j).limits.lower, robot_.leg(j).limits.upper})
      if (std::isfinite(limit)) functions_.push_back({BoundaryKind::limit, j});
  for (const BoundaryStyle& style : boundary_styles()) {
    if (!style.constraint || !robot_.constraint_kinds()[index_of(*style.constraint)]) continue;
    functions_.push_back({style.kind, 0});
    constraints_.push_back(*style.constraint);
  }
}

BoundaryFunctions::Values BoundaryFunctions::values(const Pose& pose) const {
  JointVector q(robot_.leg_count());
  Values result(functions_.size());
  for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
    const Leg& leg = robot_.leg(j);
    const auto row = static_cast<Eigen::Index>(j);
    q[row] = joint_value(leg, pose.transform(leg.anchor), mode_.sign(j));
    result[1 + row] = squared_inverse_entry(leg, pose.transform(leg.anchor));
  }
  if (held_) {
    const auto row = static_cast<Eigen::Index>(held_->leg);
    q[row] = held_->value;
    result[1 + row] = mode_.sign(held_->leg) * inverse_diagonal(robot_, pose, q)[row];
  }
  result[0] = direct_determinant(robot_, pose, q);
  add_limits(q, result);
  for (std::size_t k = 0; k < constraints_.size(); ++k)
    result[result.size() - static_cast<Eigen::Index>(constraints_.size() - k)] =
        std::min(robot_.size(), constraint_clearance(robot_, constraints_[k], pose, q));
  return result;
}

void BoundaryFunctions::add_limits(const JointVector& q, Values& result) const {
  Eigen::Index row = 1 + static_cast<Eigen::Index>(robot_.leg_count());
  for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
    const JointLimits& limits = robot_.leg(j).limits;
    const double value = q[static_cast<Eigen::Index>(j)];
    if (std::isfinite(limits.lower)) result[row++] = value - limits.lower;
    if (std::isfinite(limits.upper)) result[row++] = limits.upper - value;
  }
}

}  // namespace parallel_aspects
