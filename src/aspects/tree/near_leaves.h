// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_NEAR_LEAVES_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_NEAR_LEAVES_H

#include "aspects/tree/inside_marks.h"
#include "aspects/tree/pose_tree.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// The few inside leaves of one working mode and sign that are nearest to a position within its root box,
/// nearest first.
struct NearLeaves {
  static constexpr std::size_t most = 6;

  struct Item {
    NodeIndex leaf;
    double squared_distance;
  };

  std::array<Item, most> items{};
  std::size_t count = 0;
};

/// Finds them by descending the tree and leaving out what is too far, and what the marks of the tree show to
/// hold none, where they are there. Neither allocates nor throws.
NearLeaves near_inside_leaves(const PoseTree& tree, std::size_t mode, int sign, const MapPosition& position,
                              const InsideMarks* marks = nullptr) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_NEAR_LEAVES_H
