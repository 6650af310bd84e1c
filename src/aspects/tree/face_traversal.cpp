// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/face_traversal.h"

namespace parallel_aspects {
namespace {

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

}  // namespace parallel_aspects
