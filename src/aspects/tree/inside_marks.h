// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_INSIDE_MARKS_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_INSIDE_MARKS_H

#include "aspects/tree/pose_tree.h"

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_INSIDE_MARKS_H
