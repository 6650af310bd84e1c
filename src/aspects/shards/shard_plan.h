// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_PLAN_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_PLAN_H

#include "aspects/map/map_plan.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <cstddef>
#include <cstdint>
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_PLAN_H
