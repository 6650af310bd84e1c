// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_JOINT_CORNERS_H
#define PARALLEL_ASPECTS_MOTION_PLAN_JOINT_CORNERS_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/vectors.h"
#include "parallel_aspects/motion/plan_path.h"

#include <vector>

namespace parallel_aspects {

/// Appends corners of the actuated joints [rad or m] such that straight motions of these between corners take
/// the platform along the poses of a planned path, from one corner to the next with det A away from zero,
/// certified by continuation; serial singularities are passed in one motion. The first corner is left out
/// where there are corners already, of which the last is at the start of the path. False where something is
/// not certified; then `corners` is of no use.
bool append_joint_corners(const PathPlanner& planner, const Manipulator& manipulator, const PlannedPath& path,
                          std::vector<JointVector>& corners);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_JOINT_CORNERS_H
