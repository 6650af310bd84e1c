// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_ANSWER_PICTURES_H
#define PARALLEL_ASPECTS_ROS_PICTURES_ANSWER_PICTURES_H

#include "parallel_aspects/aspects/regular_workspace.h"
#include "parallel_aspects/motion/plan_path.h"

#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {

/// A path as a line, in the colours of `index_color`, that the operational point draws, in the base frame,
/// with a ball at its start, its goal and each crossing of a gate; where the platform only turns, the end of
/// its z axis draws it, at `radius` [m]. It begins by deleting whatever its topic drew before. The path has
/// one point or more.
visualization_msgs::MarkerArray path_markers(const Manipulator& manipulator, const PlannedPath& path,
                                             const PoseBetween& between, double radius);

/// A regular shape of positions as it is proved, in the base frame and in the colour of its aspect; flat
/// where one or two positions are free. It begins by deleting whatever its topic drew before, and has nothing
/// more where none was found.
visualization_msgs::MarkerArray workspace_markers(const AspectMap& map, const WorkspaceQuestion& question,
                                                  const RegularWorkspace& workspace);

/// Where its center is, with the axes of the task frame, in the base frame.
Eigen::Isometry3d center_in_base(const AspectMap& map, const RegularWorkspace& workspace);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_ANSWER_PICTURES_H
