// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_JOINT_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_JOINT_CORRECTIONS_H

#include "urdf/closing/resolved_config.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// The axes of the siblings of a joint, each turned about the middle of the legs from where its leg starts on
/// the base to where that of the joint does, while all joints are zero; in the frame of the joint. Nothing
/// where siblings have one axis in their own frames, which is what tells then.
std::vector<Eigen::Vector3d> turned_axes(const Tree& tree, const ResolvedConfig& resolved,
                                         const LoopJoints& loops, std::size_t joint);

/// Of the type and the axis of a joint: those of its siblings first, then other types, and axes along the
/// coordinates.
Corrections joint_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                              std::size_t joint, const SourceNames& files);

/// Passive slides next to another one along the same direction, as of a telescope of which one stage is
/// actuated: all of them fixed.
Corrections series_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                               const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_JOINT_CORRECTIONS_H
