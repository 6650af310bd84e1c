// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_FOLDER_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_FOLDER_H

#include "aspects/shards/shard_plan.h"
#include "aspects/tree/pose_tree.h"

#include <cstddef>
#include <optional>
#include <string>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_FOLDER_H
