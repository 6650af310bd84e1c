// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_LEAF_CROSSINGS_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_LEAF_CROSSINGS_H

#include "aspects/boxes/crossing_proof.h"
#include "aspects/map/marked_location.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Where two aspects come close to each other in a leaf.
struct LeafCrossing {
  int from = 0, to = 0;  ///< ids; the path begins in the first, a serial one in both
  bool proved = false;   ///< whether the path is a crossing, as `Neighbours` says
  CrossingPath path;
};

/// In an undecided leaf in which no B_jj vanishes: from positive det A to negative. Needs, as the other, a
/// live `RoundingUpward`.
std::optional<LeafCrossing> find_parallel_crossing(const MarkedMap& map, NodeIndex leaf, std::size_t mode);

/// In an undecided leaf in which B_jj of one leg alone may vanish: between working modes that differ in it,
/// where det A has this sign.
std::optional<LeafCrossing> find_serial_crossing(const MarkedMap& map, NodeIndex leaf, std::size_t mode,
                                                 std::size_t other_mode, std::size_t leg, int sign);

/// The ends of the segments of a path.
std::vector<Pose> poses_of(const PoseSpace& space, const CrossingPath& path);

/// The middle of a path, or where it goes through a glued face.
Pose middle_of(const PoseSpace& space, const CrossingPath& path);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_LEAF_CROSSINGS_H
