// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/shard_tree.h"

#include "aspects/map/base_map.h"
#include "interval/interval.h"
#include "parallel_aspects/model/problems.h"

namespace parallel_aspects {
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

}  // namespace parallel_aspects
