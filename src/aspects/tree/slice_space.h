// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_SLICE_SPACE_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_SLICE_SPACE_H

#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <memory>

namespace parallel_aspects {

/// The poses of a slice: positions [m], then half turns of its angle in [-1, 1], whose ends are glued; or the
/// four cubes of SO3 where orientations are free. `positions` bounds the free positions. A pose that is
/// farther from the slice than rounding has no position in it: `position` is not finite then.
std::shared_ptr<const PoseSpace> make_slice_space(const MapSlice& slice, const Box& positions,
                                                  double characteristic_length);

/// The poses of SE2 with an actuated joint held: one root box of two directions in half turns, that of the
/// rod of its leg and phi, each with its two ends glued. A pose whose rod has its length to within
/// `held_joint_tolerance` counts as the one of the slice in the same direction.
std::shared_ptr<const PoseSpace> make_held_joint_space(const Manipulator& manipulator, const MapSlice& slice);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_SLICE_SPACE_H
