// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SURFACE_JOINT_SURFACE_H
#define PARALLEL_ASPECTS_DRAW_SURFACE_JOINT_SURFACE_H

#include "draw/surface/aspect_surface.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Of the limits of joints, where they have any.
using JointBlock = JointRange<3>;

/// The actuated joints that put the platform there in a working mode, within the block where they wrap; where
/// a leg does not reach, as near to it as it gets.
Eigen::Vector3d values_in(const JointBlock& block, const Manipulator& robot, const Pose& pose,
                          const WorkingMode& mode);

/// Whether the aspects of this map are drawn in joint space too.
bool has_joint_surfaces(const AspectMap& map) noexcept;

/// Of a map that has them.
JointBlock joint_block(const AspectMap& map);

/// The joint projection of the surface of an aspect, to be drawn: its triangles under the inverse kinematics
/// of the working mode, cut at the faces of the block. It is closed but for these.
struct JointSurface {
  int aspect = 0;  ///< id
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::optional<BoundaryKind>> bounds;  ///< by triangle: what the aspect ends at there
};

JointSurface joint_surface_of(const AspectMap& map, const AspectSurface& surface, const JointBlock& block);

/// What the aspect ends at in a triangle of its surface: what most of its corners found.
std::optional<BoundaryKind> bound_of(const AspectSurface& surface, std::size_t triangle);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SURFACE_JOINT_SURFACE_H
