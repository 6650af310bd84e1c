// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_MERGE_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_MERGE_H

#include "aspects/shards/shard_record.h"
#include "aspects/tree/pose_space.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// A leaf of a shard.
struct ShardLeaf {
  std::size_t shard = 0;
  NodeIndex leaf = 0;

  friend bool operator<(const ShardLeaf& a, const ShardLeaf& b) noexcept {
    return std::make_pair(a.shard, a.leaf) < std::make_pair(b.shard, b.leaf);
  }
  friend bool operator==(const ShardLeaf& a, const ShardLeaf& b) noexcept {
    return a.shard == b.shard && a.leaf == b.leaf;
  }
};

/// Leaves through which components that are not proved apart could be connected: of two components, or of all
/// that one loose group touches.
using ContestedLeaves = std::vector<ShardLeaf>;

/// The shards of one part put together.
struct MergedSign {
  LeafTotal undecided;                                          ///< leaves of the mode
  std::vector<LeafTotal> components;                            ///< in the order of shards and labels
  std::vector<std::pair<std::size_t, std::size_t>> unresolved;  ///< sorted pairs of components
  std::size_t apart = 0;  ///< sets of components of which any two are proved to be different aspects
  std::vector<ContestedLeaves> contested;  ///< but those of so many leaves that they lie along a curve
};

/// Joins what shares a face across the borders of shards, which lie at this level of the tree. The result
/// depends on the records and their order alone.
MergedSign merge_shards(const PoseSpace& space, std::uint32_t shard_level,
                        const std::vector<SignRecord>& shards);

Bytes bytes_of(const MergedSign& merged);
MergedSign merged_sign(const Bytes& bytes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_MERGE_H
