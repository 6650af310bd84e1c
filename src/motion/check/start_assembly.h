// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_START_ASSEMBLY_H
#define PARALLEL_ASPECTS_MOTION_CHECK_START_ASSEMBLY_H

#include "parallel_aspects/motion/check_trajectory.h"
#include "tracking/pose_certifier.h"

#include <string>

namespace parallel_aspects {

/// Where the platform is at the start of a trajectory of the actuated joints.
struct StartAssembly {
  CertifiedPoint point;
  std::string problem;                  ///< a sentence; empty where the point is certified
  std::vector<PossibleStart> possible;  ///< those that are to be chosen from
};

StartAssembly find_start(const Manipulator& manipulator, const PoseCertifier& certifier, const JointVector& q,
                         const TrajectoryStart& start);

/// Why the stated start pose does not belong to `q`; empty where it does, or none is stated.
std::string start_misfit(const Manipulator& manipulator, const JointVector& q, const TrajectoryStart& start);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_START_ASSEMBLY_H
