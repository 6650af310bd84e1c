// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_RECORD_H
#define PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_RECORD_H

#include "aspects/file/bytes.h"
#include "aspects/shards/shard.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Some leaves of a map: how many of each level, and their measure in all.
struct LeafTotal {
  std::array<std::uint64_t, PoseTree::deepest_level + 1> of_level{};
  double measure = 0.0;

  void add(std::uint32_t level, double measure_of_leaf) noexcept {
    ++of_level[level];
    measure += measure_of_leaf;
  }
  void add(const LeafTotal& other) noexcept {
    for (std::size_t i = 0; i < of_level.size(); ++i) of_level[i] += other.of_level[i];
    measure += other.measure;
  }
};

/// What a shard records of one computed mode and one sign of det A. Its leaves that may hold poses of that
/// set carry labels: inside leaves that of their component in the shard, undecided ones that of the component
/// nearest to them. Groups of undecided leaves that touch no component of the shard have labels of their own,
/// behind those of the components: they are *loose*.
struct SignRecord {
  /// Two leaves that share a part of a face, with different labels: through them two components could be
  /// connected.
  struct Contact {
    NodeIndex leaf = 0, other_leaf = 0;
    std::uint32_t label = 0, other_label = 0;
  };

  /// A leaf that lies on the border of the shard.
  struct BorderLeaf {
    NodePlace place;
    NodeIndex leaf = 0;
    std::uint32_t label = 0;
    bool is_inside = false;
  };

  LeafTotal undecided;                ///< leaves of the mode, whatever signs they may hold
  std::vector<LeafTotal> components;  ///< inside leaves, by label
  std::uint32_t loose_count = 0;
  std::vector<Contact> contacts;
  std::vector<BorderLeaf> border;

  std::uint32_t label_count() const noexcept {
    return static_cast<std::uint32_t>(components.size()) + loose_count;
  }
};

/// A computed mode with one sign of det A is a *part* of a map. Nothing links two of them, so that each is
/// put together alone.
constexpr std::size_t part_of(std::size_t mode, int sign) noexcept { return 2 * mode + (sign > 0 ? 0 : 1); }

/// All that others need to know of a shard: the records of these modes, one flag for each, as bytes by part;
/// empty where not asked for. Nothing where cancelled.
std::optional<std::vector<Bytes>> records_of(const PoseTree& tree, const NodePlace& shard,
                                             const std::vector<bool>& modes, const MapControl& control);

/// The record that was turned to bytes. Throws `InvalidDescription` where they are none.
SignRecord sign_record(const Bytes& bytes);

void write(const LeafTotal& total, ByteWriter& writer);
LeafTotal read_total(ByteReader& reader);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SHARDS_SHARD_RECORD_H
