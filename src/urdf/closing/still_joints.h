// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_STILL_JOINTS_H
#define PARALLEL_ASPECTS_URDF_CLOSING_STILL_JOINTS_H

#include "urdf/closing/assembly.h"

#include <vector>

namespace parallel_aspects {

/// The joints inside the loops that these hold still, for each joint value: as those that only take up
/// misalignment in a planar robot. Found from where the mechanism is after a step of each of its motions.
std::vector<bool> still_joints(const ClosureSystem& system, const Assembly& assembly);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_STILL_JOINTS_H
