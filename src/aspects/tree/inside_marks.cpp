// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/inside_marks.h"

namespace parallel_aspects {

// Children come after their parents, and have no states of modes that end above them.
InsideMarks::InsideMarks(const PoseTree& tree)
    : bytes_((2 * tree.mode_count() + 7) / 8), marks_(bytes_ * tree.node_count(), 0) {
  for (NodeIndex node = static_cast<NodeIndex>(tree.node_count()); node-- > 0;) {
    std::uint8_t* own = marks_.data() + node * bytes_;
    for (std::size_t mode = 0; mode < tree.mode_count(); ++mode) {
      const LeafState state = tree.state(node, mode);
      if (!state.is_inside()) continue;
      const std::size_t bit = 2 * mode + (state.is_inside(1) ? 1 : 0);
      own[bit / 8] = static_cast<std::uint8_t>(own[bit / 8] | 1U << bit % 8);
    }
    const NodeIndex first = tree.first_child(node);
    if (first == no_node) continue;
    const std::uint8_t* below = marks_.data() + first * bytes_;
    for (std::size_t i = 0; i < tree.children_per_node() * bytes_; ++i)
      own[i % bytes_] = static_cast<std::uint8_t>(own[i % bytes_] | below[i]);
  }
}

}  // namespace parallel_aspects
