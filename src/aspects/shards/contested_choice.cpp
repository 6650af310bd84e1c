// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/contested_choice.h"

#include "aspects/components/component_policy.h"

#include <algorithm>

namespace parallel_aspects {

ContestedChoice::ContestedChoice(const std::vector<std::size_t>& undecided) {
  const ComponentPolicy policy;
  for (const std::size_t leaves : undecided)
    budget_.push_back(policy.least_budget + leaves / policy.undecided_leaves_for_one);
}

void ContestedChoice::choose(std::size_t mode, const ContestedLeaves& leaves,
                             std::map<std::size_t, DivisionRound>& next) {
  if (leaves.size() > budget_[mode]) return;
  budget_[mode] -= leaves.size();
  divided_ += leaves.size();
  for (const ShardLeaf& each : leaves) {
    DivisionRound& round = next[each.shard];
    round.leaves.resize(budget_.size());
    round.leaves[mode].push_back(each.leaf);
  }
}

std::vector<ShardTask> ContestedChoice::choose(const std::vector<MergedSign>& merged) {
  std::map<std::size_t, DivisionRound> next;
  for (std::size_t i = 0; i < merged.size(); ++i)
    for (const ContestedLeaves& leaves : merged[i].contested) choose(i / 2, leaves, next);
  std::vector<ShardTask> tasks;
  for (auto& [shard, round] : next) {
    for (std::vector<NodeIndex>& leaves : round.leaves) {
      std::sort(leaves.begin(), leaves.end());
      leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    }
    history_[shard].push_back(std::move(round));
    tasks.push_back({shard, history_[shard]});
  }
  return tasks;
}

std::vector<bool> ShardTask::modes(std::size_t count) const {
  std::vector<bool> modes(count, rounds.empty());
  if (!rounds.empty())
    for (std::size_t mode = 0; mode < count; ++mode) modes[mode] = !rounds.back().leaves[mode].empty();
  return modes;
}

Bytes bytes_of(const std::vector<ShardTask>& tasks) {
  ByteWriter writer;
  writer.put_u32(static_cast<std::uint32_t>(tasks.size()));
  for (const ShardTask& task : tasks) {
    writer.put_u64(task.shard);
    writer.put_u32(static_cast<std::uint32_t>(task.rounds.size()));
    for (const DivisionRound& round : task.rounds) {
      writer.put_u32(static_cast<std::uint32_t>(round.leaves.size()));
      for (const std::vector<NodeIndex>& leaves : round.leaves) {
        writer.put_u32(static_cast<std::uint32_t>(leaves.size()));
        for (const NodeIndex leaf : leaves) writer.put_u32(leaf);
      }
    }
  }
  return writer.bytes();
}

std::vector<ShardTask> shard_tasks(const Bytes& bytes) {
  ByteReader reader(bytes.data(), bytes.size());
  std::vector<ShardTask> tasks(reader.take_count(1));
  for (ShardTask& task : tasks) {
    task.shard = reader.take_u64();
    task.rounds.resize(reader.take_count(1));
    for (DivisionRound& round : task.rounds) {
      round.leaves.resize(reader.take_count(1));
      for (std::vector<NodeIndex>& leaves : round.leaves) {
        leaves.resize(reader.take_count(index_size));
        for (NodeIndex& leaf : leaves) leaf = reader.take_u32();
      }
    }
  }
  return tasks;
}

}  // namespace parallel_aspects
