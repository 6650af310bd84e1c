// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_INVERSE_H
#define PARALLEL_ASPECTS_KINEMATICS_INVERSE_H

#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// B_jj^2 of a leg whose anchor is at `point` (task frame) [m^4, or m^2 for a joint value in m]. Negative
/// where the leg cannot reach: B_jj^2 = 0 is the serial singularity, stretched or folded, and the same for
/// all working modes.
double squared_inverse_entry(const Leg& leg, const Eigen::Vector3d& point) noexcept;

/// The joint value that puts the leg's anchor at `point` with the given sign of B_jj [rad or m]; an angle
/// comes in
/// (-pi, pi], or a whole number of turns away where that is what the joint limits ask for.
/// Where the leg cannot reach, the value of the closest configuration (B_jj = 0). With the sign 0 it is the
/// value that both branches have where B_jj = 0.
double joint_value(const Leg& leg, const Eigen::Vector3d& point, int sign) noexcept;

/// What became of an inverse problem.
enum class InverseStatus {
  solved,          ///< every leg reaches, within its limits
  out_of_reach,    ///< a leg cannot reach; `leg` says which
  outside_limits,  ///< a joint value is outside its joint limits; `leg` says which
};

/// The joint values of a pose in one working mode.
struct InverseSolution {
  InverseStatus status = InverseStatus::out_of_reach;  ///< whether `q` can be used
  WorkingMode mode;                                    ///< that was asked for
  JointVector q;        ///< one entry a leg [rad or m]; filled unless out of reach
  std::size_t leg = 0;  ///< first leg at fault, unless solved

  /// Whether every leg reaches, within its limits.
  explicit operator bool() const noexcept { return status == InverseStatus::solved; }
};

/// The one inverse solution in this working mode, in closed form.
InverseSolution inverse(const Manipulator& manipulator, const Pose& pose, const WorkingMode& mode) noexcept;

/// One entry for every working mode of `working_modes(manipulator)`, whatever its status.
std::vector<InverseSolution> inverse_in_all_modes(const Manipulator& manipulator, const Pose& pose);

/// "solved", "out of reach" or "outside joint limits".
const char* name(InverseStatus status) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_INVERSE_H
