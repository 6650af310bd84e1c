// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_JOINT_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_JOINT_CORRECTIONS_H

#include "urdf/corrections/correction.h"
#include "urdf/corrections/loop_joints.h"

namespace parallel_aspects {

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
