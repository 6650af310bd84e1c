// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_ROBOT_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_ROBOT_SYMMETRY_H

#include "aspects/symmetry/rigid_symmetry.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// A reflection or rotation g that takes a manipulator onto itself, as far as aspects are concerned: where
/// leg j can be at a pose with a sign s of B_jj, leg `leg_image[j]` can be at the image of the pose with the
/// sign `entry_sign[j]` s, and det A there is that at the pose times a number of the sign `determinant_sign`.
/// So g takes S(s, sigma) onto S(g s, determinant_sign sigma), aspects onto aspects (docs/maps.md has the
/// proof). This is exact: a theorem about the numbers of the manipulator.
struct RobotSymmetry {
  RigidSymmetry motion;
  std::vector<std::size_t> leg_image;
  std::vector<int> entry_sign;  ///< each 1 or -1
  int determinant_sign = 1;

  WorkingMode image(const WorkingMode& mode) const;
};

/// Those that are found among `find_rigid_symmetries` of the task space and region, the identity too where it
/// changes working modes, as with actuated elbows. Numbers must match without any tolerance: of the legs with
/// their limits, and of all constraints.
std::vector<RobotSymmetry> find_robot_symmetries(const Manipulator& manipulator, const Box& region);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_ROBOT_SYMMETRY_H
