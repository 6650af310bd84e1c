// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_REACHED_POSES_H
#define PARALLEL_ASPECTS_ASK_REACHED_POSES_H

#include "parallel_aspects/ask/robot_description.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Geometry>

#include <vector>

namespace parallel_aspects::ask {

/// Poses that the legs reach within all that bounds the robot, in any working mode, singular or not. As found
/// by looking at many: about right, and not proved.
struct ReachedPoses {
  Eigen::AlignedBox3d positions;  ///< of the operational point, over all orientations [m]
  int drawn = 0, count = 0;       ///< random poses where the flood has been, and how many of them are reached
};

/// Whether the legs reach a pose.
bool is_reached(const Manipulator& manipulator, const Pose& pose);

/// Floods a grid of poses from `home`, which must be reached; the grid becomes as fine as some ten thousand
/// poses allow. Then random poses are drawn where it has been, and those that are farthest are pushed on.
ReachedPoses flooded_from(const Manipulator& manipulator, const Pose& home);

/// Of the entries of a twist, as `displaced` takes it: turns about the axes of the task frame through the
/// operational point first, at most half a turn; then displacements.
std::vector<CoordinateRange> ranges_alone(const Manipulator& manipulator, const Pose& home);

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_REACHED_POSES_H
