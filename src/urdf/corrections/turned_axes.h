// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_TURNED_AXES_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_TURNED_AXES_H

#include "urdf/closing/resolved_config.h"
#include "urdf/corrections/loop_joints.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// The axes of the siblings of a joint, each turned about the middle of the legs from where its leg starts on
/// the base to where that of the joint does, while all joints are zero; in the frame of the joint. Nothing
/// where siblings have one axis in their own frames, which is what tells then.
std::vector<Eigen::Vector3d> turned_axes(const Tree& tree, const ResolvedConfig& resolved,
                                         const LoopJoints& loops, std::size_t joint);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_TURNED_AXES_H
