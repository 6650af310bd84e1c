// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_JOINT_ASSEMBLY_H
#define PARALLEL_ASPECTS_MOTION_CHECK_JOINT_ASSEMBLY_H

#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "tracking/pose_certifier.h"

#include <array>
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

/// Whether it is proved that no pose at all goes with any joint values in `q`: in T1, T2 and T3, where each
/// leg keeps the operational point on a sphere, and these have no common point. False in other task spaces.
/// Needs a live `RoundingUpward`.
bool proved_unassembled(const Manipulator& manipulator, const std::array<Interval, max_legs>& q) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_JOINT_ASSEMBLY_H
