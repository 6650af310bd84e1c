// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_NEAR_LEAVES_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_NEAR_LEAVES_H

#include "aspects/tree/pose_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// Which nodes of a tree are inside with a sign of det A, or have leaves below them that are, by working
/// mode: what many searches for such leaves need not enter else.
class InsideMarks {
 public:
  explicit InsideMarks(const PoseTree& tree);

  bool holds(NodeIndex node, std::size_t mode, int sign) const noexcept {
    const std::size_t bit = 2 * mode + (sign > 0 ? 1 : 0);
    return (marks_[node * bytes_ + bit / 8] >> bit % 8 & 1U) != 0;
  }

 private:
  std::size_t bytes_;  // of a node
  std::vector<std::uint8_t> marks_;
};

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
