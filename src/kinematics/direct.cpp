// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/direct.h"

#include <algorithm>

#include "parallel_aspects/kinematics/direct_t2.h"
#include "parallel_aspects/kinematics/jacobians.h"

namespace parallel_aspects {
namespace {

DirectResult solve(const Manipulator& manipulator, const JointVector& q) {
  switch (manipulator.task_space()) {
    case TaskSpace::T2:
      return direct_t2(manipulator, q);
    case TaskSpace::SE2:
    case TaskSpace::T3:
    case TaskSpace::SO3:
    case TaskSpace::SE3:
      break;
  }
  return {};
}

void complete(const Manipulator& manipulator, const JointVector& q, AssemblyMode& mode) {
  const double size = manipulator.size();
  mode.determinant = direct_determinant(manipulator, mode.pose, q);
  mode.residual = residuals(manipulator, mode.pose, q).cwiseAbs().maxCoeff() / (size * size);
}

}  // namespace

DirectResult direct(const Manipulator& manipulator, const JointVector& q) {
  if (q.size() != static_cast<Eigen::Index>(manipulator.leg_count()) || !q.allFinite()) return {};
  DirectResult result = solve(manipulator, q);
  for (AssemblyMode& mode : result.solutions) complete(manipulator, q, mode);
  std::stable_sort(
      result.solutions.begin(), result.solutions.end(),
      [](const AssemblyMode& a, const AssemblyMode& b) { return a.determinant > b.determinant; });
  return result;
}

const char* name(DirectStatus status) noexcept {
  switch (status) {
    case DirectStatus::solved:
      return "solved";
    case DirectStatus::continuum:
      return "continuum";
    case DirectStatus::unsolved:
      return "unsolved";
  }
  return "unknown";
}

}  // namespace parallel_aspects
