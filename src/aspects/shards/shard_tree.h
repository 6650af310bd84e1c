// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_TREE_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_TREE_H

#include "aspects/shards/shard_plan.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_control.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The leaves to divide in one shard in one round, by mode that is computed.
struct DivisionRound {
  std::vector<std::vector<NodeIndex>> leaves;
};

/// A shard's part of the map's tree before any refinement. The tree is one of the whole space, so that boxes
/// are those of the whole map to the last digit; all of it but the shard counts as outside. Throws
/// `InvalidDescription` where the shard alone is too large; nothing where cancelled.
std::optional<PoseTree> grow_shard(const ShardPlan& plan, std::size_t shard, const MapControl& control);

/// Divides the leaves of one round after the other, and classifies their children.
void divide_shard(PoseTree& tree, const BoxClassifier& classifier, const std::vector<DivisionRound>& rounds);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_TREE_H
