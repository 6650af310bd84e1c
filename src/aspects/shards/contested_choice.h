// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_CONTESTED_CHOICE_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_CONTESTED_CHOICE_H

#include "aspects/file/byte_stream.h"
#include "aspects/shards/shard_merge.h"
#include "aspects/shards/shard_tree.h"

#include <cstddef>
#include <map>
#include <vector>

namespace parallel_aspects {

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_CONTESTED_CHOICE_H
