// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/shard_rounds.h"

#include "aspects/components/component_policy.h"
#include "aspects/components/disjoint_sets.h"
#include "aspects/shards/shard_record.h"
#include "aspects/tree/neighbour_leaves.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

bool is_before(const NodePlace& a, const NodePlace& b) noexcept {
  return std::tie(a.root, a.level, a.cell) < std::tie(b.root, b.level, b.cell);
}

/// A leaf on the border of its shard, with its label among those of all shards.
struct BorderNode {
  NodePlace place;
  ShardLeaf leaf;
  std::uint32_t label;
  bool is_inside;
};

/// Two leaves that share a face, with labels among those of all shards.
struct Touch {
  ShardLeaf leaf, other_leaf;
  std::uint32_t label, other_label;
};

class Merge {
 public:
  Merge(const PoseSpace& space, std::uint32_t shard_level, const std::vector<SignRecord>& shards)
      : space_(space), shard_level_(shard_level), shards_(shards) {
    for (const SignRecord& shard : shards) {
      first_label_.push_back(static_cast<std::uint32_t>(is_component_.size()));
      for (std::uint32_t label = 0; label < shard.label_count(); ++label)
        is_component_.push_back(label < shard.components.size());
      result_.undecided.add(shard.undecided);
    }
    sets_ = DisjointSets(is_component_.size());
  }

  MergedSign run() {
    take_contacts();
    join_borders();
    unite_loose();
    number_components();
    collect_meetings();
    count_apart();
    return std::move(result_);
  }

 private:
  void take_contacts() {
    for (std::size_t s = 0; s < shards_.size(); ++s)
      for (const SignRecord::Contact& contact : shards_[s].contacts)
        touches_.push_back({{s, contact.leaf},
                            {s, contact.other_leaf},
                            first_label_[s] + contact.label,
                            first_label_[s] + contact.other_label});
  }

  void join_borders() {
    std::vector<BorderNode> nodes;
    for (std::size_t s = 0; s < shards_.size(); ++s)
      for (const SignRecord::BorderLeaf& leaf : shards_[s].border)
        nodes.push_back({leaf.place, {s, leaf.leaf}, first_label_[s] + leaf.label, leaf.is_inside});
    std::sort(nodes.begin(), nodes.end(),
              [](const BorderNode& a, const BorderNode& b) { return is_before(a.place, b.place); });
    for (const BorderNode& node : nodes)
      for (std::size_t axis = 0; axis < space_.dimension(); ++axis)
        for (const bool upper : {false, true})
          if (const auto across = place_across(space_, node.place, {axis, upper}))
            if (!is_in_one_shard(node.place, *across))
              if (const BorderNode* other = find(nodes, *across)) join(node, *other);
  }

  // What touches within a shard its record says.
  bool is_in_one_shard(const NodePlace& a, const NodePlace& b) const noexcept {
    const std::uint32_t below = a.level - shard_level_;
    for (std::size_t i = 0; i < space_.dimension(); ++i)
      if (a.cell[i] >> below != b.cell[i] >> below) return false;
    return a.root == b.root;
  }

  /// The leaf that has this place or holds it; none is larger than a shard. Where the leaves there are
  /// smaller they find this one.
  const BorderNode* find(const std::vector<BorderNode>& nodes, NodePlace place) const {
    for (;; --place.level) {
      const auto at = std::lower_bound(
          nodes.begin(), nodes.end(), place,
          [](const BorderNode& node, const NodePlace& each) { return is_before(node.place, each); });
      if (at != nodes.end() && !is_before(place, at->place)) return &*at;
      if (place.level == shard_level_) return nullptr;
      for (std::uint32_t& cell : place.cell) cell >>= 1U;
    }
  }

  void join(const BorderNode& a, const BorderNode& b) {
    if (a.label == b.label) return;
    if (a.is_inside && b.is_inside)
      sets_.unite(a.label, b.label);
    else
      touches_.push_back({a.leaf, b.leaf, a.label, b.label});
  }

  void unite_loose() {
    for (const Touch& touch : touches_)
      if (!is_component_[touch.label] && !is_component_[touch.other_label])
        sets_.unite(touch.label, touch.other_label);
  }

  void number_components() {
    component_.assign(is_component_.size(), 0);
    for (std::size_t s = 0; s < shards_.size(); ++s)
      for (std::uint32_t label = 0; label < shards_[s].components.size(); ++label) {
        const std::uint32_t each = first_label_[s] + label, set = sets_.find(each);
        if (set == each) {
          component_[set] = result_.components.size();
          result_.components.emplace_back();
        }
        result_.components[component_[set]].add(shards_[s].components[label]);
      }
  }

  void collect_meetings() {
    std::map<std::pair<std::size_t, std::size_t>, ContestedLeaves> between;
    std::map<std::uint32_t, std::pair<std::set<std::size_t>, ContestedLeaves>> loose;
    for (const Touch& touch : touches_) {
      const std::uint32_t a = sets_.find(touch.label), b = sets_.find(touch.other_label);
      if (a == b) continue;
      ContestedLeaves* leaves = nullptr;
      if (is_component_[a] && is_component_[b]) {
        leaves = &between[std::minmax(component_[a], component_[b])];
      } else {
        auto& group = loose[is_component_[a] ? b : a];
        group.first.insert(component_[is_component_[a] ? a : b]);
        leaves = &group.second;
      }
      leaves->insert(leaves->end(), {touch.leaf, touch.other_leaf});
    }
    for (auto& [pair, leaves] : between) add_contested(pair.first, pair.second, leaves);
    for (auto& [set, group] : loose) add_group(group.first, group.second);
    std::sort(result_.unresolved.begin(), result_.unresolved.end());
    const auto end = std::unique(result_.unresolved.begin(), result_.unresolved.end());
    result_.unresolved.erase(end, result_.unresolved.end());
  }

  void add_contested(std::size_t a, std::size_t b, ContestedLeaves& leaves) {
    result_.unresolved.emplace_back(a, b);
    keep(leaves);
  }

  /// All that one loose group touches could be connected through it.
  void add_group(const std::set<std::size_t>& touched, ContestedLeaves& leaves) {
    if (touched.size() < 2) return;
    for (auto a = touched.begin(); a != touched.end(); ++a)
      for (auto b = std::next(a); b != touched.end(); ++b) result_.unresolved.emplace_back(*a, *b);
    keep(leaves);
  }

  // Where a contact has many leaves it lies along a curve, has twice as many with each level, and no depth
  // ends it.
  void keep(ContestedLeaves& leaves) {
    std::sort(leaves.begin(), leaves.end());
    leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    if (leaves.size() <= ComponentPolicy().max_leaves_of_a_point_between)
      result_.contested.push_back(std::move(leaves));
  }

  void count_apart() {
    DisjointSets clusters(result_.components.size());
    for (const auto& [a, b] : result_.unresolved)
      clusters.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    for (std::uint32_t i = 0; i < result_.components.size(); ++i) result_.apart += clusters.find(i) == i;
  }

  const PoseSpace& space_;
  std::uint32_t shard_level_;
  const std::vector<SignRecord>& shards_;
  std::vector<std::uint32_t> first_label_;  // of a shard
  std::vector<bool> is_component_;          // of a label
  DisjointSets sets_;                       // of labels: components that are joined, loose groups that touch
  std::vector<Touch> touches_;
  std::vector<std::size_t> component_;  // of a set
  MergedSign result_;
};

}  // namespace

MergedSign merge_shards(const PoseSpace& space, std::uint32_t shard_level,
                        const std::vector<SignRecord>& shards) {
  return Merge(space, shard_level, shards).run();
}

Bytes bytes_of(const MergedSign& merged) {
  ByteWriter writer;
  write(merged.undecided, writer);
  writer.put_u32(static_cast<std::uint32_t>(merged.components.size()));
  for (const LeafTotal& component : merged.components) write(component, writer);
  writer.put_u32(static_cast<std::uint32_t>(merged.unresolved.size()));
  for (const auto& [a, b] : merged.unresolved) {
    writer.put_u64(a);
    writer.put_u64(b);
  }
  writer.put_u64(merged.apart);
  writer.put_u32(static_cast<std::uint32_t>(merged.contested.size()));
  for (const ContestedLeaves& leaves : merged.contested) {
    writer.put_u32(static_cast<std::uint32_t>(leaves.size()));
    for (const ShardLeaf& each : leaves) {
      writer.put_u64(each.shard);
      writer.put_u32(each.leaf);
    }
  }
  return writer.bytes();
}

MergedSign merged_sign(const Bytes& bytes) {
  constexpr std::size_t least_total = 9, pair_size = 16, leaf_size = 12;
  ByteReader reader(bytes.data(), bytes.size());
  MergedSign merged;
  merged.undecided = read_total(reader);
  merged.components.resize(reader.take_count(least_total));
  for (LeafTotal& component : merged.components) component = read_total(reader);
  merged.unresolved.resize(reader.take_count(pair_size));
  for (auto& [a, b] : merged.unresolved) {
    a = reader.take_u64();
    b = reader.take_u64();
  }
  merged.apart = reader.take_u64();
  merged.contested.resize(reader.take_count(index_size));
  for (ContestedLeaves& leaves : merged.contested) {
    leaves.resize(reader.take_count(leaf_size));
    for (ShardLeaf& each : leaves) {
      each.shard = reader.take_u64();
      each.leaf = reader.take_u32();
    }
  }
  return merged;
}

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
