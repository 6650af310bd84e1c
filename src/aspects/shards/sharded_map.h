// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARDED_MAP_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARDED_MAP_H

#include "aspects/file/byte_stream.h"
#include "aspects/shards/shard_plan.h"
#include "aspects/shards/shard_record.h"
#include "parallel_aspects/aspects/map_control.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Those who compute together: this process alone, or several that each run the same code.
class ShardCrew {
 public:
  virtual ~ShardCrew() = default;

  /// Whether this process puts the results together.
  virtual bool is_first() const = 0;

  /// Calls `work` for each of 0, 1, ..., count - 1 in one process, whichever is free. In the first process
  /// what it returned, in this order; empty in the others. Nothing, in all of them, where one was cancelled.
  virtual std::optional<std::vector<Bytes>> perform(std::size_t count,
                                                    const std::function<Bytes(std::size_t)>& work,
                                                    const MapControl& control) = 0;

  /// The bytes of the first process, in all of them.
  virtual Bytes tell_all(Bytes bytes) = 0;
};

/// This process alone.
class LoneCrew final : public ShardCrew {
 public:
  bool is_first() const override { return true; }
  std::optional<std::vector<Bytes>> perform(std::size_t count, const std::function<Bytes(std::size_t)>& work,
                                            const MapControl& control) override;
  Bytes tell_all(Bytes bytes) override { return bytes; }
};

/// What the shards of a map show together. Equal for any crew, to the last digit.
struct ShardedMap {
  struct Part {
    WorkingMode mode;
    int determinant_sign = 0;
    LeafTotal inside;  ///< leaves proved to lie in it, and their measure
  };

  std::vector<Part> aspects;  ///< by mode, then positive before negative, then falling measure
  std::vector<std::pair<int, int>>
      unresolved;                  ///< ids, from 1, of pairs that are neither joined nor proved apart
  std::size_t proved_count = 0;    ///< aspects of which any two are proved to be different
  LeafTotal undecided;             ///< of all modes
  std::size_t rounds = 0;          ///< of dividing contested leaves
  std::size_t divided_leaves = 0;  ///< in all of these
};

/// Messages for people while shards are computed, such as that a file is of no use.
using ShardNotes = std::function<void(const std::string&)>;

/// Computes the shards that `folder` does not hold and puts all together, then divides leaves where
/// components could be connected, round by round. Every process of the crew calls this with the same
/// arguments; the result is that of the first. Nothing where cancelled. Throws `InvalidDescription`.
std::optional<ShardedMap> compute_sharded_map(const ShardPlan& plan, const std::string& folder,
                                              ShardCrew& crew, const MapControl& control,
                                              const ShardNotes& notes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARDED_MAP_H
