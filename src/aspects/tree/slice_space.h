// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_SLICE_SPACE_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_SLICE_SPACE_H

#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <memory>

namespace parallel_aspects {

/// The poses of a slice: positions [m], then half turns of its angle in [-1, 1], whose ends are glued; or the
/// four cubes of SO3 where orientations are free. `positions` bounds the free positions. A pose that is
/// farther from the slice than rounding has no position in it: `position` is not finite then.
std::shared_ptr<const PoseSpace> make_slice_space(const MapSlice& slice, const Box& positions,
                                                  double characteristic_length);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_SLICE_SPACE_H
