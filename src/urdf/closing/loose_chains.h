// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_LOOSE_CHAINS_H
#define PARALLEL_ASPECTS_URDF_CLOSING_LOOSE_CHAINS_H

#include "urdf/closing/chain.h"

#include <vector>

namespace parallel_aspects {

/// The parts between base and platform that keep the platform from no motion, by the rank of their twists,
/// though `mechanism.still` are fixed; the chains of each.
std::vector<std::vector<Chain>> chains_that_hold_nothing(const AssembledMechanism& mechanism,
                                                         const ActuatedJoints& actuated_joints,
                                                         const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_LOOSE_CHAINS_H
