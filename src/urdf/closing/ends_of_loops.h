// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_ENDS_OF_LOOPS_H
#define PARALLEL_ASPECTS_URDF_CLOSING_ENDS_OF_LOOPS_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/chain.h"
#include "urdf/description/closure.h"

namespace parallel_aspects {

/// The base and the operational point must be on bodies of the loops. Serial joints that are in between, as
/// of a turntable or a wrist, and actuated joints outside of the loops are added to `problems`, each with the
/// link to name in place. Needs no assembled configuration.
void check_ends_of_loops(const ClosureSystem& system, const ActuatedJoints& actuated_joints,
                         const SourceNames& files, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_ENDS_OF_LOOPS_H
