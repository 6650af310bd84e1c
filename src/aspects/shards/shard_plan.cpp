// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/shard_plan.h"

#include "aspects/file/map_key.h"
#include "aspects/map/proof_revision.h"
#include "parallel_aspects/model/version.h"

namespace parallel_aspects {
namespace {

/// More of them would cost more than they save: each is a file.
constexpr std::size_t max_shards = std::size_t{1} << 18;

/// The modes whose aspects are no images of others.
std::vector<WorkingMode> find_images(const MapPlan& all, std::vector<ComputedMode>& images) {
  const std::vector<ModeSource> sources = find_mode_sources(all.symmetries, all.modes.size());
  std::vector<WorkingMode> computed;
  std::vector<std::size_t> index(sources.size());
  for (std::size_t mode = 0; mode < sources.size(); ++mode) {
    const auto& [representative, symmetry] = sources[mode];
    if (symmetry == nullptr) {
      index[mode] = computed.size();
      computed.push_back(all.modes[mode]);
    }
    images.push_back({index[representative], symmetry == nullptr ? 1 : symmetry->determinant_sign});
  }
  return computed;
}

std::string key_of(const Manipulator& manipulator, const ShardPlan& plan) {
  return "package " + std::string(package_version) + ", proofs " + std::to_string(proof_revision) + "\n" +
         map_key(manipulator, plan.map.space->region(), plan.map.resolution, plan.map.depth,
                 plan.map.deepest_level) +
         coverage_key(plan.map.slice, plan.map.modes) + "shards of level " + std::to_string(plan.level) +
         "\n";
}

}  // namespace

std::size_t ShardPlan::count() const noexcept {
  return map.space->root_count() << (map.space->dimension() * level);
}

NodePlace ShardPlan::place(std::size_t shard) const noexcept {
  NodePlace place{{}, level, 0};
  const std::size_t last = (std::size_t{1} << level) - 1;
  for (std::size_t i = 0; i < map.space->dimension(); ++i, shard >>= level)
    place.cell[i] = static_cast<std::uint32_t>(shard & last);
  place.root = static_cast<RootIndex>(shard);
  return place;
}

std::string make_shard_plan(const Manipulator& manipulator, MapOptions options, std::uint32_t level,
                            ShardPlan& plan) {
  MapPlan all;
  std::string problem = make_map_plan(manipulator, options, all);
  if (!problem.empty()) return problem;
  plan.modes = all.modes;
  options.modes = find_images(all, plan.images);
  options.use_symmetry = false;
  problem = make_map_plan(manipulator, options, plan.map);
  if (!problem.empty()) return problem;
  plan.level = level;
  plan.threads = options.threads;
  if (level > plan.map.depth)
    return "Shards of level " + std::to_string(level) +
           " are finer than the map, whose leaves are of level " + std::to_string(plan.map.depth) +
           "; give a lower level.";
  if (plan.map.space->dimension() * level > 18 || plan.count() > max_shards)
    return "Shards of level " + std::to_string(level) + " are more than " + std::to_string(max_shards) +
           "; give a lower level.";
  plan.key = key_of(manipulator, plan);
  return "";
}

}  // namespace parallel_aspects
