// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_CHAIN_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_CHAIN_CORRECTIONS_H

#include "urdf/corrections/correction.h"

#include <vector>

namespace parallel_aspects {

/// Of chains between base and platform without an actuated joint, those that change least first: other axes
/// of their slides; then joints that they lack for a platform that moves as in one of the task spaces, and
/// slides in the place of joints that turn one after the other, as those of an arm.
std::vector<Corrections> chain_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                           const ClosureSystem& system, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_CHAIN_CORRECTIONS_H
