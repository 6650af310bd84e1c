// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_PLACE_ACROSS_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_PLACE_ACROSS_H

#include "aspects/tree/pose_space.h"
#include "aspects/tree/pose_tree.h"

#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// One of the faces of a node: that at the lower or at the upper end of a coordinate.
struct NodeFace {
  std::size_t axis = 0;
  bool upper = false;
};

/// The place of the same level on the other side of a face, glued faces of the space included; nothing where
/// the space ends there.
std::optional<NodePlace> place_across(const PoseSpace& space, const NodePlace& place,
                                      const NodeFace& face) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_PLACE_ACROSS_H
