// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PATH_H
#define PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PATH_H

#include "aspects/map/map_contents.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// How far the platform moves from one pose to another: the distance of the operational point, and the
/// rotation times the characteristic length [m].
double distance_between(const Manipulator& manipulator, const Pose& from, const Pose& to);

/// Poses from one to another through inside leaves of one aspect that share faces: the first, the middles of
/// the faces and of small leaves on the way, and the last. Each lies in the same leaf as the next, but for
/// the ends where they are in no inside leaf. Wide leaves are preferred, since little is near that ends the
/// aspect. Empty where none of the leaves near the one end is connected with one near the other.
std::vector<Pose> find_leaf_path(const AspectMap::Contents& map, int aspect, const Pose& from,
                                 const Pose& to);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PATH_H
