// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BASE_MAP_H
#define PARALLEL_ASPECTS_ASPECTS_BASE_MAP_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/box_classifier.h"
#include "parallel_aspects/aspects/pose_tree.h"

#include <cstdint>

namespace parallel_aspects {

/// Classifies the pending nodes of `tree` and divides what stays undecided, level by level, down to `depth`,
/// on all threads of the calling arena; the result does not depend on their number. False when cancelled,
/// with the tree unfinished.
bool grow_base_map(PoseTree& tree, const BoxClassifier& classifier, std::uint32_t depth,
                   const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BASE_MAP_H
