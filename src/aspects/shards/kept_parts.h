// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_KEPT_PARTS_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_KEPT_PARTS_H

#include "aspects/file/byte_stream.h"
#include "aspects/shards/contested_choice.h"
#include "aspects/shards/shard_plan.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Bytes by part, then by task; nothing for parts that another process keeps.
using PartResults = std::vector<std::vector<Bytes>>;

/// The parts of a map that this process puts together. What shards tell of them stays packed, and is unpacked
/// for one part at a time.
class KeptParts {
 public:
  /// The plan must outlive this.
  explicit KeptParts(const ShardPlan& plan);

  std::size_t count() const noexcept { return records_.size(); }

  /// Keeps what the shards of these tasks tell in place of what they told before.
  void take(const std::vector<ShardTask>& tasks, PartResults&& results);

  /// The `MergedSign` of a part as bytes; empty where nothing is new since the last call.
  Bytes merge(std::size_t part);

 private:
  const ShardPlan& plan_;
  std::vector<std::vector<Bytes>> records_;  // by part, then by shard
  std::vector<bool> is_new_;                 // of a part
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_KEPT_PARTS_H
