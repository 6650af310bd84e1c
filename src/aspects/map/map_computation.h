// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_MAP_COMPUTATION_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_MAP_COMPUTATION_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/components/component_policy.h"
#include "aspects/symmetry/map_symmetry.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace parallel_aspects {

enum class BaseMapStatus { complete, cancelled, too_large };

/// A base map that needs more nodes is given up: some gigabytes of memory.
inline constexpr std::size_t max_nodes = 30'000'000;

/// Classifies the pending nodes of `tree` and divides what stays undecided, level by level, down to `depth`,
/// on all threads of the calling arena; the result does not depend on their number. At `depth` that much
/// detail is asked for. Unless complete, the tree is unfinished. Of boxes and working modes that `symmetries`
/// take to each other one is classified.
BaseMapStatus grow_base_map(PoseTree& tree, const BoxClassifier& classifier, std::uint32_t depth,
                            Detail detail, const MapControl& control,
                            const std::vector<MapSymmetry>& symmetries = {});

/// The same as the public one, by a policy of one's own: for measuring what each part of it is good for.
MapResult compute_aspect_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                             const MapControl& control, const ComponentPolicy& policy);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_MAP_COMPUTATION_H
