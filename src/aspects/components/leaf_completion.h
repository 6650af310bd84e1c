// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_COMPLETION_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_COMPLETION_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/components/leaf_graph.h"
#include "aspects/stars/star_finder.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_control.h"

#include <cstddef>

namespace parallel_aspects {

/// Proves of indeterminate leaves that they are whole or empty by stars about poses nearby (see StarFinder),
/// of the leaf or of all its parts, of no more than `max_boxes` for a sign. Those that are neither stay
/// indeterminate. Ends early when cancelled; progress is that of the leaves of this graph.
void complete_leaves(PoseTree& tree, const BoxClassifier& classifier, const StarFinder& stars,
                     std::size_t max_boxes, LeafGraph& graph, const MapControl& control,
                     const ComponentPolicy& policy);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_COMPLETION_H
