// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <vector>

namespace parallel_aspects {

/// One direct solution: a pose that the given joint values can hold.
struct AssemblyMode {
  Pose pose;                 ///< in the task frame
  double determinant = 0.0;  ///< det A there; unit as in `direct_determinant`
  double residual = 0.0;     ///< largest |f_j| over the squared `assembly_scale`, dimensionless
  bool near_singular =
      false;  ///< so close to det A = 0 that its count or pose may depend on rounding (see `direct`)
  /// Some B_jj is zero to rounding, below 1e-6 of |u_j| |c_j'|: a leg is stretched or folded, and the
  /// solution belongs to no working mode. The trivial solutions of the Agile Eye are such, whatever the
  /// actuated joints.
  bool serially_singular = false;
};

/// What became of a direct problem.
enum class DirectStatus {
  solved,     ///< every real solution is in the list, which may be empty
  continuum,  ///< the platform can move with the actuated joints locked; no finite list exists
  unsolved,   ///< the input is not finite, or the list may be incomplete
};

/// The direct solutions for given joint values.
struct DirectResult {
  DirectStatus status = DirectStatus::unsolved;  ///< whether the list is complete
  std::vector<AssemblyMode> solutions;           ///< by falling det A

  /// Whether the list, which may be empty, is complete.
  explicit operator bool() const noexcept { return status == DirectStatus::solved; }
};

/// Every real assembly mode for these actuated joint values (one entry a leg), whatever the joint limits.
/// There are at most 2 (T1, T2, T3), 6 (SE2), 8 (SO3) or 40 (SE3). A strut of negative length assembles
/// nowhere.
///
/// Each is refined until rounding stops it; its residual is below 1e-12. Solutions that have met at a
/// parallel singularity to half the digits come as one, flagged `near_singular`: the smallest singular value
/// of the homogenised A is below 1e-6 there.
DirectResult direct(const Manipulator& manipulator, const JointVector& q);

/// "solved", "continuum" or "unsolved".
const char* name(DirectStatus status) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_H
