// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_PLATFORM_MOTION_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_PLATFORM_MOTION_H

#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// How the platform moves, found from its velocities at an assembled configuration.
struct PlatformMotion {
  TaskSpace space = TaskSpace::T2;
  /// The link of the operational point turns, but its orientation is no degree of freedom (T2, T3): legs must
  /// meet in the point.
  bool point_platform = false;
  Eigen::Isometry3d task_frame = Eigen::Isometry3d::Identity();  ///< in the base frame [m]
  Eigen::Isometry3d platform =
      Eigen::Isometry3d::Identity();  ///< platform frame there, in the base frame [m]
  HingePair hinges{};                 ///< of R2
  Chain hinge_chain;          ///< of R1 and R2: the passive joints whose values are the pose coordinates
  Eigen::Index mobility = 0;  ///< degrees of freedom of the whole mechanism
  Eigen::Index idle = 0;  ///< those that move neither an actuated joint nor the platform, as a rod that spins
};

/// The motion of the platform. Nothing, and a message in `problems`, when the mobility is not the number of
/// actuated joints or the motion is none of the task spaces.
std::optional<PlatformMotion> find_platform_motion(const ClosureSystem& system, const Assembly& assembly,
                                                   const ActuatedJoints& actuated_joints,
                                                   const SourceNames& files, Problems& problems);

/// Why a platform turns though legs hold it by rods in pairs, as those of a Delta: the pair whose ends are
/// farthest from a parallelogram, or that all are parallelograms which are turned against each other. Nothing
/// where no leg has a pair of rods. `size`: of the robot [m].
std::optional<std::string> reason_to_turn(const std::vector<LegChains>& legs, double size);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_PLATFORM_MOTION_H
