// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_SKELETON_H
#define PARALLEL_ASPECTS_ROS_PICTURES_SKELETON_H

#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Core>

#include <vector>

namespace parallel_aspects {

/// How wide the lines of a skeleton are, over the size of the robot.
inline constexpr double skeleton_width = 0.012;

/// Legs and platform of the model as segments in the task frame, two points each [m]: what a robot looks like
/// whose URDF has no visuals. `radius`: of the sphere that a robot of SO3 takes, whose model has no size [m].
std::vector<Eigen::Vector3d> skeleton_of(const Manipulator& robot, const Pose& pose, const JointVector& q,
                                         double radius);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_SKELETON_H
