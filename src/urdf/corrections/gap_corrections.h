// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_GAP_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_GAP_CORRECTIONS_H

#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"

namespace parallel_aspects {

/// Of the origin of a joint: the place or the rotation of its siblings first, then a coordinate of the other
/// sign, millimetres, a place or an rpy that the frames beside it make a pattern with, the rpy of another
/// frame, one of the other sign or without one of its angles.
Corrections gap_corrections(const Tree& tree, const LoopJoints& loops, std::size_t joint,
                            const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_GAP_CORRECTIONS_H
