// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_ROUNDS_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_ROUNDS_H

#include "aspects/file/bytes.h"
#include "aspects/shards/shard.h"
#include "aspects/shards/shard_record.h"
#include "aspects/tree/pose_space.h"

#include <cstddef>
#include <cstdint>
#include <map>
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

/// A shard to compute, with all rounds of divisions so far.
struct ShardTask {
  std::size_t shard = 0;
  std::vector<DivisionRound> rounds;

  /// Of so many computed modes, those that its last round divides; all where there is no round.
  std::vector<bool> modes(std::size_t count) const;
};

Bytes bytes_of(const std::vector<ShardTask>& tasks);
std::vector<ShardTask> shard_tasks(const Bytes& bytes);

/// Chooses the contested leaves to divide, round by round, within what one mode may divide in all.
class ContestedChoice {
 public:
  /// `undecided`: leaves of each computed mode in the base map.
  explicit ContestedChoice(const std::vector<std::size_t>& undecided);

  /// The shards in which something is to be divided next. `merged` is by part.
  std::vector<ShardTask> choose(const std::vector<MergedSign>& merged);

  std::size_t divided() const noexcept { return divided_; }

 private:
  void choose(std::size_t mode, const ContestedLeaves& leaves, std::map<std::size_t, DivisionRound>& next);

  std::vector<std::size_t> budget_;                            // of leaves, by mode
  std::map<std::size_t, std::vector<DivisionRound>> history_;  // by shard
  std::size_t divided_ = 0;
};

/// Bytes by part, then by task; nothing for parts that another process keeps.
using PartResults = std::vector<std::vector<Bytes>>;

/// The parts of a map that this process puts together. What shards record of them stays packed, and is
/// unpacked for one part at a time.
class KeptParts {
 public:
  /// The plan must outlive this.
  explicit KeptParts(const ShardPlan& plan);

  std::size_t count() const noexcept { return records_.size(); }

  /// Replaces the records of the shards of these tasks by the new ones.
  void take(const std::vector<ShardTask>& tasks, PartResults&& results);

  /// The `MergedSign` of a part as bytes; empty where nothing is new since the last call.
  Bytes merge(std::size_t part);

 private:
  const ShardPlan& plan_;
  std::vector<std::vector<Bytes>> records_;  // by part, then by shard
  std::vector<bool> is_new_;                 // of a part
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_ROUNDS_H
