// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/kept_parts.h"

#include "aspects/shards/shard_merge.h"
#include "aspects/shards/shard_record.h"

#include <utility>

namespace parallel_aspects {

KeptParts::KeptParts(const ShardPlan& plan)
    : plan_(plan), records_(2 * plan.map.modes.size()), is_new_(records_.size(), false) {}

void KeptParts::take(const std::vector<ShardTask>& tasks, PartResults&& results) {
  for (std::size_t part = 0; part < results.size(); ++part)
    for (std::size_t i = 0; i < results[part].size(); ++i) {
      if (results[part][i].empty()) continue;
      records_[part].resize(plan_.count());
      records_[part][tasks[i].shard] = std::move(results[part][i]);
      is_new_[part] = true;
    }
}

Bytes KeptParts::merge(std::size_t part) {
  if (!is_new_[part]) return {};
  is_new_[part] = false;
  std::vector<SignRecord> shards;
  shards.reserve(records_[part].size());
  for (const Bytes& record : records_[part]) shards.push_back(sign_record(record));
  return bytes_of(merge_shards(*plan_.map.space, plan_.level, shards));
}

}  // namespace parallel_aspects
