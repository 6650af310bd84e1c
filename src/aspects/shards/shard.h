// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_H

#include "aspects/map/map_plan.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Where the aspects of a working mode are taken from.
struct ComputedMode {
  std::size_t computed = 0;  ///< index of the mode that is computed
  int sign = 1;              ///< that its signs of det A are multiplied by
};

/// A map that is computed in shards: the boxes that halving every root so many times gives, each with all
/// working modes that are computed. The division depends on the robot and the options alone, not on who
/// computes what.
struct ShardPlan {
  MapPlan map;                       ///< of the modes that are computed
  std::vector<WorkingMode> modes;    ///< all that are asked for
  std::vector<ComputedMode> images;  ///< of each of these
  std::uint32_t level = 0;           ///< of the shards in the tree
  unsigned threads = 1;              ///< of a process; 0 for one a core
  std::string key;                   ///< what the shards are of, as text

  std::size_t count() const noexcept;
  NodePlace place(std::size_t shard) const noexcept;
};

/// Fills `plan`; the message says why that cannot be, and is empty otherwise.
std::string make_shard_plan(const Manipulator& manipulator, MapOptions options, std::uint32_t level,
                            ShardPlan& plan);

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

/// A folder where the shards of one map are kept, a file each, before any refinement: whoever computes the
/// map again takes them up. All processes of a computation must see it.
class ShardFolder {
 public:
  /// The plan must outlive this.
  ShardFolder(const std::string& path, const ShardPlan& plan) : path_(path), plan_(plan) {}

  /// Makes the folder where there is none. Why it cannot be used, such as that it holds the shards of another
  /// map; empty where it can. One process does this before the others read and write.
  std::string claim() const;

  /// The shard that is kept here. Nothing where there is none; where its file is of no use, `problem` says
  /// why.
  std::optional<PoseTree> read(std::size_t shard, std::string& problem) const;

  /// Empty when done, else why not.
  std::string write(std::size_t shard, const PoseTree& tree) const;

 private:
  std::string file_of(std::size_t shard) const;

  std::string path_;
  const ShardPlan& plan_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_H
