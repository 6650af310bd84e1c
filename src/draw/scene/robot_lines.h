// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SCENE_ROBOT_LINES_H
#define PARALLEL_ASPECTS_DRAW_SCENE_ROBOT_LINES_H

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace parallel_aspects {

/// How far the viewer looks down on a robot that is not planar [rad].
inline constexpr double view_pitch = 0.3;

/// Of the ball of rotations that the display draws beside a robot which only turns, and which takes as much
/// room: its radius over the robot's size, and the distance of its middle from the robot over that radius.
inline constexpr double ball_radius = 0.15, ball_distance = 1.8;

/// The frame that pictures of the robot are drawn in, in its base frame: the task frame, but with the axes of
/// the base in R1 and R2, where those of the task frame may point anywhere.
Eigen::Isometry3d drawing_frame(const Manipulator& robot) noexcept;

/// Turns what is in the task frame into the drawing frame.
Eigen::Matrix3d drawing_axes(const Manipulator& robot) noexcept;

/// How long a turn of a robot of SE2 is drawn across the plane: as long as the robot is wide [m].
double turn_length(const Manipulator& manipulator) noexcept;

/// Of the sphere around the platform of a robot of R2 on which the display draws where its normal points [m].
double sphere_radius(const Manipulator& robot) noexcept;

/// The share of its radius that one sheet of it lies farther in, and the other farther out.
inline constexpr double between_sheets = 0.08;

/// Of a legend above all that a robot reaches: height of its letters over that of what is seen, and from line
/// to line over that.
inline constexpr double legend_height = 0.027, legend_pitch = 1.35;

/// How large the robot is drawn: of SO3, whose model is a unit sphere, by the `radius` of the sphere that it
/// takes [m].
double drawn_size(const Manipulator& robot, double radius) noexcept;

/// How wide the lines of a skeleton are, over the size of the robot.
inline constexpr double skeleton_width = 0.012;

/// Legs and platform of the model as segments in the drawing frame, two points each [m]: what a robot looks
/// like whose URDF has no visuals. `radius`: of the sphere that a robot of SO3 takes, whose model has no size
/// [m].
std::vector<Eigen::Vector3d> skeleton_of(const Manipulator& robot, const Pose& pose, const JointVector& q,
                                         double radius);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SCENE_ROBOT_LINES_H
