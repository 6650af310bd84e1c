// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/face_traversal.h"

#include <cstdint>

namespace parallel_aspects {
namespace {

constexpr std::uint32_t units = std::uint32_t{1} << PoseTree::deepest_level;  // across a root box

/// A range along one coordinate, in units of the deepest level.
struct Span {
  std::uint32_t begin, end;

  bool overlaps(const Span& other) const noexcept { return begin < other.end && other.begin < end; }
  bool touches(const Span& other) const noexcept { return end == other.begin || other.end == begin; }
  Span flipped() const noexcept { return {units - end, units - begin}; }
};

Span span(const NodePlace& place, std::size_t i) noexcept {
  const std::uint32_t shift = PoseTree::deepest_level - place.level;
  return {place.cell[i] << shift, (place.cell[i] + 1) << shift};
}

bool lies_on(const NodePlace& place, const RootFace& face) noexcept {
  const Span along = span(place, face.axis);
  return place.root == face.root && (face.upper ? along.end == units : along.begin == 0);
}

bool share_glued_face(const Gluing& gluing, std::size_t dimension, const NodePlace& a,
                      const NodePlace& b) noexcept {
  if (!lies_on(a, gluing.first) || !lies_on(b, gluing.second)) return false;
  for (std::size_t i = 0; i < dimension; ++i) {
    if (i == gluing.first.axis) continue;
    const Span along = gluing.flipped[i] ? span(a, i).flipped() : span(a, i);
    if (!along.overlaps(span(b, gluing.axis_of[i]))) return false;
  }
  return true;
}

bool share_inner_face(std::size_t dimension, const NodePlace& a, const NodePlace& b) noexcept {
  if (a.root != b.root) return false;
  std::size_t touching = 0, overlapping = 0;
  for (std::size_t i = 0; i < dimension; ++i) {
    touching += span(a, i).touches(span(b, i));
    overlapping += span(a, i).overlaps(span(b, i));
  }
  return touching == 1 && overlapping + 1 == dimension;
}

NodeIndex bit(std::size_t axis) { return NodeIndex{1} << axis; }

}  // namespace

FacingRanks facing_ranks(std::size_t dimension, std::size_t axis) {
  FacingRanks facing;
  for (NodeIndex rank = 0; rank < bit(dimension); ++rank)
    if ((rank & bit(axis)) == 0) facing.emplace_back(rank + bit(axis), rank);
  return facing;
}

FacingRanks facing_ranks(std::size_t dimension, const Gluing& gluing) {
  FacingRanks facing;
  for (NodeIndex rank = 0; rank < bit(dimension); ++rank) {
    if (((rank & bit(gluing.first.axis)) != 0) != gluing.first.upper) continue;
    NodeIndex other = gluing.second.upper ? bit(gluing.second.axis) : 0;
    for (std::size_t i = 0; i < dimension; ++i)
      if (i != gluing.first.axis && ((rank & bit(i)) != 0) != gluing.flipped[i])
        other |= bit(gluing.axis_of[i]);
    facing.emplace_back(rank, other);
  }
  return facing;
}

bool share_face(const PoseTree& tree, NodeIndex a, NodeIndex b) noexcept {
  const NodePlace &one = tree.place(a), &other = tree.place(b);
  if (share_inner_face(tree.dimension(), one, other)) return true;
  for (const Gluing& gluing : tree.space().gluings())
    if (share_glued_face(gluing, tree.dimension(), one, other) ||
        share_glued_face(gluing, tree.dimension(), other, one))
      return true;
  return false;
}

}  // namespace parallel_aspects
