// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_REFINEMENT_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_REFINEMENT_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/components/components.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace parallel_aspects {

/// What `prepare_refinement` expects of the base map: leaves of many degrees of freedom are too many to look
/// into all.
constexpr Detail detail_of_base_map(std::size_t dimension) noexcept {
  return dimension <= 2 ? Detail::parts : Detail::centers;
}

/// Whether a mode looks into all of its undecided leaves for what is hidden there. It does with up to two
/// degrees of freedom, and divides what stays indeterminate at points until nothing can hide. With more of
/// them boundaries meet along curves, and no depth would end that: it does where the leaves are few, and else
/// looks only into those where components could meet.
bool looks_everywhere(const PoseTree& tree, std::size_t mode, const ComponentPolicy& policy) noexcept;

/// Finds what is whole in the undecided leaves of a mode that looks everywhere. Ends early when cancelled.
void look_into_leaves(PoseTree& tree, const BoxClassifier& classifier, std::size_t mode,
                      const MapControl& control);

/// Divides leaves where components of one working mode and sign meet until they are joined or apart, and
/// leaves near no component until they show one or vanish; ends at `deepest_level`. Where two components meet
/// in more and more leaves with each level, they touch along a curve or surface and no depth tells them
/// apart: such leaves are left undecided early. All modes go in step, on all threads of the calling arena;
/// the result does not depend on their number. False when cancelled.
bool refine_contested(PoseTree& tree, const BoxClassifier& classifier,
                      const std::vector<std::unique_ptr<LeafGraph>>& graphs, std::uint32_t base_level,
                      std::uint32_t deepest_level, const MapControl& control, const ComponentPolicy& policy);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_REFINEMENT_H
