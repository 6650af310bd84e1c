// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARDED_MAP_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARDED_MAP_H

#include "aspects/file/bytes.h"
#include "aspects/shards/shard.h"
#include "aspects/shards/shard_record.h"
#include "aspects/shards/shard_rounds.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

using ShardFunction = std::function<std::vector<Bytes>(std::size_t task)>;
using PartFunction = std::function<Bytes(std::size_t part)>;

/// Those who compute together: this process alone, or several that each run the same code.
class ShardCrew {
 public:
  virtual ~ShardCrew() = default;

  /// Whether the result is that of this process.
  virtual bool is_first() const = 0;

  /// Calls `work` for each of 0, 1, ..., count - 1 in one process, whichever is free, and hands what it
  /// returned, bytes by part, to the processes that keep the parts. Nothing, in all of them, where one was
  /// cancelled.
  virtual std::optional<PartResults> perform(std::size_t count, std::size_t parts, const ShardFunction& work,
                                             const MapControl& control) = 0;

  /// Calls `work` for each part in the process that keeps it. In the first process what it returned, by part;
  /// empty in the others.
  virtual std::vector<Bytes> gather(std::size_t parts, const PartFunction& work) = 0;

  /// The bytes of the first process, in all of them.
  virtual Bytes tell_all(Bytes bytes) = 0;
};

/// This process alone.
class LoneCrew final : public ShardCrew {
 public:
  bool is_first() const override { return true; }
  std::optional<PartResults> perform(std::size_t count, std::size_t parts, const ShardFunction& work,
                                     const MapControl& control) override;
  std::vector<Bytes> gather(std::size_t parts, const PartFunction& work) override;
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
