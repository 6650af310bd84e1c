// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/sharded_map.h"

#include "aspects/shards/shard.h"
#include "aspects/shards/shard_rounds.h"
#include "parallel_aspects/model/problems.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <numeric>

namespace parallel_aspects {
namespace {

/// What one process does with a task.
class ShardWork {
 public:
  ShardWork(const ShardPlan& plan, const ShardFolder& folder, const MapControl& control,
            const ShardNotes& notes)
      : plan_(plan), folder_(folder), notes_(notes) {
    quiet_.cancelled = control.cancelled;
  }

  /// The records as bytes; empty where cancelled.
  std::vector<Bytes> perform(const ShardTask& task) const {
    tbb::task_arena arena(plan_.threads == 0 ? tbb::task_arena::automatic : static_cast<int>(plan_.threads));
    return arena.execute([&] { return records_of_task(task); });
  }

 private:
  std::vector<Bytes> records_of_task(const ShardTask& task) const {
    std::optional<PoseTree> tree = base_of(task.shard);
    if (!tree) return {};
    divide_shard(*tree, *plan_.map.classifier, task.rounds);
    const std::vector<bool> modes = task.modes(plan_.map.modes.size());
    return records_of(*tree, plan_.place(task.shard), modes, quiet_).value_or(std::vector<Bytes>());
  }

  std::optional<PoseTree> base_of(std::size_t shard) const {
    std::string problem;
    std::optional<PoseTree> tree = folder_.read(shard, problem);
    if (!problem.empty() && notes_) notes_(problem);
    if (tree) return tree;
    tree = grow_shard(plan_, shard, quiet_);
    if (!tree) return tree;
    problem = folder_.write(shard, *tree);
    if (!problem.empty()) throw InvalidDescription({problem});
    return tree;
  }

  const ShardPlan& plan_;
  const ShardFolder& folder_;
  const ShardNotes& notes_;
  MapControl quiet_;  // a shard's own progress is not shown
};

/// Indices of components, the largest first.
std::vector<std::size_t> order_of(const std::vector<LeafTotal>& components) {
  std::vector<std::size_t> order(components.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&components](std::size_t a, std::size_t b) {
    return components[a].measure > components[b].measure;
  });
  return order;
}

void add_sign(ShardedMap& map, const WorkingMode& mode, int sign, const MergedSign& merged) {
  const std::vector<std::size_t> order = order_of(merged.components);
  std::vector<int> id(order.size());
  for (const std::size_t component : order) {
    map.aspects.push_back({mode, sign, merged.components[component]});
    id[component] = static_cast<int>(map.aspects.size());
  }
  for (const auto& [a, b] : merged.unresolved)
    map.unresolved.emplace_back(std::min(id[a], id[b]), std::max(id[a], id[b]));
  map.proved_count += merged.apart;
}

ShardedMap assembled(const ShardPlan& plan, const std::vector<MergedSign>& merged) {
  ShardedMap map;
  for (std::size_t mode = 0; mode < plan.modes.size(); ++mode) {
    const ComputedMode& image = plan.images[mode];
    for (const int sign : {1, -1})
      add_sign(map, plan.modes[mode], sign, merged[part_of(image.computed, sign * image.sign)]);
    map.undecided.add(merged[part_of(image.computed, 1)].undecided);
  }
  std::sort(map.unresolved.begin(), map.unresolved.end());
  return map;
}

std::size_t count_of(const LeafTotal& total) {
  return std::accumulate(total.of_level.begin(), total.of_level.end(), std::size_t{0});
}

/// What the first process does between rounds.
class Assembly {
 public:
  explicit Assembly(const ShardPlan& plan) : plan_(plan), merged_(2 * plan.map.modes.size()) {}

  /// Parts that are empty are as they were.
  void take(const std::vector<Bytes>& merged) {
    for (std::size_t part = 0; part < merged.size(); ++part)
      if (!merged[part].empty()) merged_[part] = merged_sign(merged[part]);
  }

  std::vector<ShardTask> choose() {
    if (!choice_) {
      std::vector<std::size_t> undecided;
      for (std::size_t mode = 0; mode < plan_.map.modes.size(); ++mode)
        undecided.push_back(count_of(merged_[part_of(mode, 1)].undecided));
      choice_.emplace(undecided);
    }
    return choice_->choose(merged_);
  }

  ShardedMap map() const {
    ShardedMap map = assembled(plan_, merged_);
    if (choice_) map.divided_leaves = choice_->divided();
    return map;
  }

 private:
  const ShardPlan& plan_;
  std::vector<MergedSign> merged_;  // by part
  std::optional<ContestedChoice> choice_;
};

std::vector<ShardTask> all_shards(const ShardPlan& plan) {
  std::vector<ShardTask> tasks(plan.count());
  for (std::size_t shard = 0; shard < tasks.size(); ++shard) tasks[shard].shard = shard;
  return tasks;
}

}  // namespace

std::optional<PartResults> LoneCrew::perform(std::size_t count, std::size_t parts, const ShardFunction& work,
                                             const MapControl& control) {
  PartResults results(parts, std::vector<Bytes>(count));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Bytes> result = work(i);
    if (is_cancelled(control)) return std::nullopt;
    for (std::size_t part = 0; part < parts; ++part) results[part][i] = std::move(result[part]);
    if (control.progress) control.progress(static_cast<double>(i + 1) / static_cast<double>(count));
  }
  return results;
}

std::vector<Bytes> LoneCrew::gather(std::size_t parts, const PartFunction& work) {
  std::vector<Bytes> results;
  for (std::size_t part = 0; part < parts; ++part) results.push_back(work(part));
  return results;
}

// A round divides by one level, so that no leaf comes to lie below the deepest.
std::optional<ShardedMap> compute_sharded_map(const ShardPlan& plan, const std::string& folder,
                                              ShardCrew& crew, const MapControl& control,
                                              const ShardNotes& notes) {
  const ShardFolder shards(folder, plan);
  const std::string problem = crew.is_first() ? shards.claim() : std::string();
  const Bytes refused = crew.tell_all(Bytes(problem.begin(), problem.end()));
  if (!refused.empty()) throw InvalidDescription({std::string(refused.begin(), refused.end())});
  const ShardWork work(plan, shards, control, notes);
  KeptParts kept(plan);
  Assembly assembly(plan);
  std::vector<ShardTask> tasks = all_shards(plan);
  const std::size_t max_rounds = plan.map.deepest_level - plan.map.depth;
  const MapControl quiet{{}, control.cancelled};
  for (std::size_t round = 0;; ++round) {
    auto results = crew.perform(
        tasks.size(), kept.count(), [&](std::size_t i) { return work.perform(tasks[i]); },
        round == 0 ? control : quiet);
    if (!results) return std::nullopt;
    kept.take(tasks, std::move(*results));
    assembly.take(crew.gather(kept.count(), [&kept](std::size_t part) { return kept.merge(part); }));
    const bool may_divide = crew.is_first() && round < max_rounds;
    tasks = shard_tasks(
        crew.tell_all(may_divide ? bytes_of(assembly.choose()) : bytes_of(std::vector<ShardTask>())));
    if (!tasks.empty()) continue;
    if (!crew.is_first()) return ShardedMap();
    ShardedMap map = assembly.map();
    map.rounds = round;
    return map;
  }
}

}  // namespace parallel_aspects
