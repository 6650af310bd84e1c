// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_ROTATION_SLICE_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_ROTATION_SLICE_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// A slice of SO3 or SE3 in which the platform turns by phi from the orientation that is held, about an axis
/// through its operational point: x, y or z of the task frame, or own-x, own-y or own-z of the platform.
/// Roll, pitch and yaw are all held, and up to two positions may be free; else as `make_slice`.
MapSlice make_rotation_slice(TaskSpace space, const std::vector<HeldCoordinate>& held,
                             const std::string& axis, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_ROTATION_SLICE_H
