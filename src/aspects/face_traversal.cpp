// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/face_traversal.h"

#include <cstdint>

namespace parallel_aspects {
namespace {

struct Span {
  std::uint32_t begin, end;
};

// Along one coordinate, in units of the deepest level.
Span span(const NodePlace& place, std::size_t i) noexcept {
  const std::uint32_t shift = PoseTree::deepest_level - place.level;
  return {place.cell[i] << shift, (place.cell[i] + 1) << shift};
}

}  // namespace

bool share_face(const PoseTree& tree, NodeIndex a, NodeIndex b) noexcept {
  std::size_t touching = 0, overlapping = 0;
  for (std::size_t i = 0; i < tree.dimension(); ++i) {
    const Span one = span(tree.place(a), i), other = span(tree.place(b), i);
    if (one.end == other.begin || other.end == one.begin)
      ++touching;
    else if (one.begin < other.end && other.begin < one.end)
      ++overlapping;
  }
  return touching == 1 && overlapping + 1 == tree.dimension();
}

}  // namespace parallel_aspects
