// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_REFINEMENT_H
#define PARALLEL_ASPECTS_ASPECTS_REFINEMENT_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/box_classifier.h"
#include "parallel_aspects/aspects/leaf_graph.h"
#include "parallel_aspects/aspects/pose_tree.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace parallel_aspects {

/// Whether so few freedoms are left that the map looks into all undecided leaves for what is hidden there,
/// and divides what stays open at points until nothing can hide. With more of them boundaries meet along
/// curves, no depth would end it, and only leaves where components could meet are looked into.
constexpr bool looks_everywhere(std::size_t dimension) noexcept { return dimension <= 2; }

/// What `refine_contested` expects of the base map.
constexpr Detail detail_of_base_map(std::size_t dimension) noexcept {
  return looks_everywhere(dimension) ? Detail::parts : Detail::centers;
}

/// Divides leaves where components of one working mode and sign meet until they are joined or apart, and
/// leaves near no component until they show one or vanish; ends at `deepest_level`. Where two components meet
/// in more and more leaves with each level, they touch along a curve or surface and no depth tells them
/// apart: such leaves are left undecided early. All modes go in step, on all threads of the calling arena;
/// the result does not depend on their number. False when cancelled.
bool refine_contested(PoseTree& tree, const BoxClassifier& classifier,
                      const std::vector<std::unique_ptr<LeafGraph>>& graphs, std::uint32_t base_level,
                      std::uint32_t deepest_level, const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_REFINEMENT_H
