// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_candidates.h"
#include "kinematics/direct/direct_hinges.h"
#include "kinematics/direct/direct_problem.h"
#include "kinematics/direct/direct_se3.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

// A candidate with a larger residual than this after refinement is no solution.
constexpr double assembled = 1e-12;

// With a smaller singular value of A than this, rounding of 1e-16 shows in the pose at 1e-10 or more.
constexpr double nearly_singular = 1e-6;

// With a smaller sine between rod and crank than this, the sign of B_jj may depend on rounding.
constexpr double nearly_stretched = 1e-6;

// Solutions closer than this, relative to the robot, are one solution found twice; nearly singular ones are
// known to half the digits only.
constexpr double same_pose = 1e-9;
constexpr double same_singular_pose = 1e-6;

// Lengths beyond this [m] are no robot's, and their powers overflow.
constexpr double largest_scale = 1e30;

// Approximate poses, among them every real solution.
DirectResult candidates(const Manipulator& manipulator, const JointVector& q) {
  switch (manipulator.task_space()) {
    case TaskSpace::T1:
      return direct_t1(manipulator, q);
    case TaskSpace::T2:
      return direct_t2(manipulator, q);
    case TaskSpace::SE2:
      return direct_se2(manipulator, q);
    case TaskSpace::T3:
      return direct_t3(manipulator, q);
    case TaskSpace::SO3:
      return direct_so3(manipulator, q);
    case TaskSpace::R1:
      return direct_r1(manipulator, q);
    case TaskSpace::R2:
      return direct_r2(manipulator, q);
    case TaskSpace::SE3:
      return direct_se3(manipulator, q);
  }
  return {};
}

bool same(const Manipulator& manipulator, const AssemblyMode& a, const AssemblyMode& b) {
  const double tolerance = a.near_singular && b.near_singular ? same_singular_pose : same_pose;
  return (a.pose.position - b.pose.position).norm() <= tolerance * manipulator.size() &&
         a.pose.orientation.angularDistance(b.pose.orientation) <= tolerance;
}

// Stretched or folded. A strut is neither: its B_jj is its length.
bool any_leg_stretched(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const TaskVector diagonal = inverse_diagonal(manipulator, pose, q);
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    if (std::abs(diagonal[row]) < nearly_stretched * manipulator.leg(j).largest_entry()) return true;
  }
  return false;
}

// Whether the candidate became a solution.
bool add_refined(const Manipulator& manipulator, const JointVector& q, const Pose& candidate,
                 std::vector<AssemblyMode>& solutions) {
  const Refinement refinement = refined(manipulator, candidate, q);
  if (!(refinement.residual <= assembled)) return false;
  const AssemblyMode mode{refinement.pose, direct_determinant(manipulator, refinement.pose, q),
                          refinement.residual, refinement.singular_value < nearly_singular,
                          any_leg_stretched(manipulator, refinement.pose, q)};
  const auto same_as_mode = [&](const AssemblyMode& other) { return same(manipulator, mode, other); };
  if (std::none_of(solutions.begin(), solutions.end(), same_as_mode)) solutions.push_back(mode);
  return true;
}

DirectResult refined_candidates(const Manipulator& manipulator, const JointVector& q,
                                const DirectResult& found) {
  DirectResult result{found.status, {}};
  for (const AssemblyMode& mode : found.solutions) {
    const bool added = add_refined(manipulator, q, mode.pose, result.solutions);
    // Solvers flag candidates that they are sure of, but know only roughly.
    if (!added && mode.near_singular) result.status = DirectStatus::unsolved;
  }
  // Samples of a continuum that none of the legs can follow are a continuum of complex solutions only.
  if (found.status == DirectStatus::continuum && !found.solutions.empty() && result.solutions.empty())
    result.status = DirectStatus::solved;
  return result;
}

bool any_on_continuum(const Manipulator& manipulator, const JointVector& q,
                      const std::vector<AssemblyMode>& solutions) {
  return std::any_of(solutions.begin(), solutions.end(), [&](const AssemblyMode& mode) {
    return mode.near_singular && on_continuum(manipulator, mode.pose, q);
  });
}

// Only its square is left in the equations.
bool has_strut_of_negative_length(const Manipulator& manipulator, const JointVector& q) {
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    if (!manipulator.leg(j).can_have(q[static_cast<Eigen::Index>(j)])) return true;
  return false;
}

}  // namespace

DirectResult direct(const Manipulator& manipulator, const JointVector& q) {
  if (q.size() != static_cast<Eigen::Index>(manipulator.leg_count()) || !q.allFinite()) return {};
  if (!(assembly_scale(manipulator, q) < largest_scale)) return {};
  if (has_strut_of_negative_length(manipulator, q)) return {DirectStatus::solved, {}};
  DirectResult result = refined_candidates(manipulator, q, candidates(manipulator, q));
  if (any_on_continuum(manipulator, q, result.solutions) ||
      (result.status == DirectStatus::unsolved && continuum_found(manipulator, q)))
    result.status = DirectStatus::continuum;
  if (result.status == DirectStatus::continuum) result.solutions.clear();
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
