// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/shard.h"

#include "aspects/file/bytes.h"
#include "aspects/file/map_key.h"
#include "aspects/file/part_records.h"
#include "aspects/map/map_computation.h"
#include "aspects/map/proof_revision.h"
#include "interval/interval.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/model/version.h"

#include <filesystem>
#include <system_error>

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

namespace {

void set_all(PoseTree& tree, NodeIndex node, LeafState state) {
  for (std::size_t mode = 0; mode < tree.mode_count(); ++mode) tree.state(node, mode) = state;
}

/// The child of a node of that level on the way to a place.
NodeIndex rank_towards(const NodePlace& place, std::uint32_t level, std::size_t dimension) noexcept {
  NodeIndex rank = 0;
  for (std::size_t i = 0; i < dimension; ++i) rank |= (place.cell[i] >> (place.level - level - 1) & 1U) << i;
  return rank;
}

/// Leaves the node of that place pending, and closes everything beside it.
void divide_towards(PoseTree& tree, const NodePlace& place) {
  for (NodeIndex root = 0; root < tree.root_count(); ++root)
    if (root != place.root) set_all(tree, root, LeafState::outside());
  NodeIndex node = place.root;
  for (std::uint32_t level = 0; level < place.level; ++level) {
    const NodeIndex first = tree.add_children(node);
    set_all(tree, node, LeafState::divided());
    node = first + rank_towards(place, level, tree.dimension());
    for (NodeIndex child = first; child < first + tree.children_per_node(); ++child)
      set_all(tree, child, child == node ? LeafState::pending() : LeafState::outside());
  }
}

/// Children of a leaf may be no more than the leaf itself, whatever their own enclosures say.
void classify_children(PoseTree& tree, const BoxClassifier& classifier, NodeIndex node, std::size_t mode,
                       LeafState before) {
  const NodeIndex first = tree.first_child(node);
  for (NodeIndex child = first; child < first + tree.children_per_node(); ++child) {
    classifier.classify(tree.place(child).root, tree.box(child), ModeSet{1} << mode, Detail::centers,
                        tree.states(child));
    LeafState& state = tree.state(child, mode);
    for (const int sign : {1, -1})
      if (!before.may_be(sign) && state.may_be(sign)) state = state.without(sign);
  }
}

void divide_round(PoseTree& tree, const BoxClassifier& classifier, const DivisionRound& round) {
  for (std::size_t mode = 0; mode < round.leaves.size(); ++mode) {
    for (const NodeIndex node : round.leaves[mode]) {
      const LeafState before = tree.state(node, mode);
      if (!before.is_undecided()) continue;
      tree.divide(node, [mode](std::size_t each) { return each == mode; });
      classify_children(tree, classifier, node, mode, before);
    }
  }
}

}  // namespace

std::optional<PoseTree> grow_shard(const ShardPlan& plan, std::size_t shard, const MapControl& control) {
  PoseTree tree(plan.map.space, plan.map.modes.size());
  divide_towards(tree, plan.place(shard));
  const BaseMapStatus status =
      grow_base_map(tree, *plan.map.classifier, plan.map.depth - plan.level, Detail::centers, control);
  if (status == BaseMapStatus::too_large)
    throw InvalidDescription({"A shard takes more than " + std::to_string(max_nodes / 1'000'000) +
                              " million boxes at this resolution; give a higher level of shards."});
  if (status != BaseMapStatus::complete) return std::nullopt;
  return tree;
}

void divide_shard(PoseTree& tree, const BoxClassifier& classifier, const std::vector<DivisionRound>& rounds) {
  const RoundingUpward rounding;
  for (const DivisionRound& round : rounds) divide_round(tree, classifier, round);
}

namespace {

constexpr std::size_t largest_key = std::size_t{1} << 24, largest_shard = std::size_t{1} << 32;

Bytes as_bytes(const std::string& text) { return {text.begin(), text.end()}; }

}  // namespace

std::string ShardFolder::claim() const {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (!std::filesystem::is_directory(path_, error))
    return "Folder '" + path_ + "' cannot be made; give one that can be written to.";
  const std::string key_file = path_ + "/map.key";
  Bytes held;
  if (!std::filesystem::exists(key_file, error)) {
    const std::string problem = replace_file(key_file, as_bytes(plan_.key));
    return problem.empty()
               ? ""
               : "File '" + key_file + "' is not written, since " + problem + "; give another folder.";
  }
  const std::string problem = read_whole_file(key_file, largest_key, held);
  const std::string key(held.begin(), held.end());
  if (problem.empty() && key == plan_.key) return "";
  const std::string line = line_missing_in(plan_.key, key);
  return "Folder '" + path_ + "' holds the shards of another map" +
         (line.empty() ? std::string() : ", with \"" + line + "\"") + "; give another folder, or remove it.";
}

std::string ShardFolder::file_of(std::size_t shard) const {
  return path_ + "/shard_" + std::to_string(shard);
}

std::optional<PoseTree> ShardFolder::read(std::size_t shard, std::string& problem) const {
  const std::string path = file_of(shard);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return std::nullopt;
  Bytes file, bytes;
  problem = read_whole_file(path, largest_shard, file);
  if (problem.empty()) problem = unpack(file, bytes);
  std::optional<PoseTree> tree;
  if (problem.empty()) {
    ByteReader reader(bytes.data(), bytes.size());
    const bool is_this = reader.take_text() == plan_.key && reader.take_u64() == shard;
    const TreeRecord record = take_tree(reader);
    if (is_this && reader.ok() && reader.left() == 0)
      tree = PoseTree::from_record(plan_.map.space, plan_.map.modes.size(), record);
    if (!tree) problem = is_this ? "its contents contradict themselves" : "it is of another shard";
  }
  if (!problem.empty())
    problem = "Shard file '" + path + "' is not used, since " + problem + "; it is computed anew.";
  return tree;
}

std::string ShardFolder::write(std::size_t shard, const PoseTree& tree) const {
  ByteWriter writer;
  writer.put_text(plan_.key);
  writer.put_u64(shard);
  put_tree(tree.record(), writer);
  const std::string path = file_of(shard);
  const std::string problem = replace_file(path, packed(writer.bytes()));
  return problem.empty() ? ""
                         : "Shard file '" + path + "' is not written, since " + problem +
                               "; give a folder that can be written to and has room.";
}

}  // namespace parallel_aspects
