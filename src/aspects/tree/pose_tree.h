// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_POSE_TREE_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_POSE_TREE_H

#include "aspects/tree/leaf_state.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// The half, quarter or eighth of this rank (see `Box::rank_of`). Parts of one box share their corners bit
/// for bit, however the middle is rounded.
inline Box part_of(const Box& box, std::uint32_t rank) noexcept {
  Box part = box;
  for (std::size_t i = 0; i < box.dimension; ++i)
    ((rank >> i & 1U) != 0 ? part.lower : part.upper)[i] = box.center(i);
  return part;
}

/// Index of a node in a `PoseTree`; the roots come first.
using NodeIndex = std::uint32_t;
inline constexpr NodeIndex no_node = 0xffffffffU;

/// Where a node lies: in which root box, with edges 2^-level of it, lower corner at `cell` times these edges.
struct NodePlace {
  std::array<std::uint32_t, max_map_dimension> cell{};
  std::uint32_t level = 0;
  RootIndex root = 0;
};

/// What a `PoseTree` holds beside its space, without what follows from the rest.
struct TreeRecord {
  std::vector<NodeIndex> parents;    ///< nodes with children, in the order in which they got them
  std::vector<std::uint8_t> states;  ///< codes by node and mode, except of those that are inherited
};

/// A 2^d-tree of pose boxes, or as many of them as the space has roots. Each node has one `LeafState` for
/// each of its working modes; a mode's leaves are the nodes where it is decided or undecided, and modes may
/// end at different depths of the one tree.
class PoseTree {
 public:
  /// Deepest level that boxes stay exact at.
  static constexpr std::uint32_t deepest_level = 28;

  /// The tree of pending roots. The region of `space` must be its own `exact_region`.
  PoseTree(std::shared_ptr<const PoseSpace> space, std::size_t modes);

  const PoseSpace& space() const noexcept { return *space_; }
  const std::shared_ptr<const PoseSpace>& shared_space() const noexcept { return space_; }
  const Box& region() const noexcept { return region_; }
  std::size_t dimension() const noexcept { return region_.dimension; }
  std::size_t root_count() const noexcept { return root_count_; }
  std::size_t mode_count() const noexcept { return modes_; }
  std::size_t node_count() const noexcept { return first_child_.size(); }
  NodeIndex children_per_node() const noexcept { return NodeIndex{1} << dimension(); }

  LeafState state(NodeIndex node, std::size_t mode) const noexcept { return states_[node * modes_ + mode]; }
  LeafState& state(NodeIndex node, std::size_t mode) noexcept { return states_[node * modes_ + mode]; }
  LeafState* states(NodeIndex node) noexcept { return states_.data() + node * modes_; }

  NodePlace place(NodeIndex node) const noexcept {
    if (node < root_count_) return {{}, 0, node};
    NodePlace place = parents_[family(node)];
    const NodeIndex rank = (node - static_cast<NodeIndex>(root_count_)) & (children_per_node() - 1);
    for (std::size_t i = 0; i < dimension(); ++i) place.cell[i] = 2 * place.cell[i] + (rank >> i & 1U);
    ++place.level;
    return place;
  }

  /// Box of a node [m or rad]. All corners are exact, so neighbours share them bit for bit.
  Box box(NodeIndex node) const noexcept {
    const NodePlace at = place(node);
    Box box{dimension(), {}, {}};
    for (std::size_t i = 0; i < dimension(); ++i) {
      const double edge = edges_[at.level][i];
      box.lower[i] = region_.lower[i] + edge * at.cell[i];
      box.upper[i] = region_.lower[i] + edge * (at.cell[i] + 1.0);
    }
    return box;
  }

  /// First of the `children_per_node()` children, which are contiguous; `no_node` for none. Bit i of a
  /// child's rank says which half it takes along coordinate i.
  NodeIndex first_child(NodeIndex node) const noexcept { return first_child_[node]; }

  /// Gives `node` children, unless it has them: the modes that are undecided there become divided in it and
  /// pending in them where `divide` holds that mode; other modes are inherited.
  template <class Predicate>
  NodeIndex divide(NodeIndex node, const Predicate& divides_mode);

  /// Before so many nodes more are given children: takes no more memory than they need.
  void reserve_families(std::size_t count);

  /// Gives `node` children, unless it has them, in which every mode is inherited. Returns the first.
  NodeIndex add_children(NodeIndex node) {
    return first_child_[node] == no_node ? append_children(node) : first_child_[node];
  }

  TreeRecord record() const;

  /// The tree with that record, node by node the same; nothing where no tree without pending states has it.
  static std::optional<PoseTree> from_record(std::shared_ptr<const PoseSpace> space, std::size_t modes,
                                             const TreeRecord& record);

  /// The leaf of `mode` that contains a position; nothing where that is outside the region.
  std::optional<NodeIndex> leaf_at(const MapPosition& position, std::size_t mode) const noexcept;

 private:
  NodeIndex append_children(NodeIndex node);
  bool append_all_children(const std::vector<NodeIndex>& parents);
  bool set_states(const TreeRecord& record);

  /// Of a node that is no root: which of the families of children it is in.
  std::size_t family(NodeIndex node) const noexcept { return (node - root_count_) >> dimension(); }

  /// Whether the state is inherited, where that of the parent is known.
  bool inherits(const std::vector<NodeIndex>& parents, NodeIndex node, std::size_t mode) const noexcept {
    return node >= root_count() && !state(parents[family(node)], mode).is_divided();
  }

  std::shared_ptr<const PoseSpace> space_;
  std::size_t root_count_;  // of the space, beside the nodes
  Box region_;
  std::array<MapPoint, deepest_level + 1> edges_{};  // of a node, by level
  std::size_t modes_;
  std::vector<NodePlace> parents_;  // of the families, in their order: one place for all children of a node
  std::vector<NodeIndex> first_child_;
  std::vector<LeafState> states_;
};

/// `box` widened so that every corner of every node down to `PoseTree::deepest_level` is an exact double: its
/// corners become multiples of a power of two, some 2^-22 of the farthest of them. Nothing where it lies too
/// far from the origin for its width (more than some thousand widths), is empty or is not finite.
std::optional<Box> exact_region(const Box& box) noexcept;

template <class Predicate>
NodeIndex PoseTree::divide(NodeIndex node, const Predicate& divides_mode) {
  const NodeIndex first = add_children(node);
  for (std::size_t mode = 0; mode < modes_; ++mode) {
    if (!state(node, mode).is_undecided() || !divides_mode(mode)) continue;
    state(node, mode) = LeafState::divided();
    for (NodeIndex child = first; child < first + children_per_node(); ++child)
      state(child, mode) = LeafState::pending();
  }
  return first;
}

// Widths of regions are multiples of one unit, at most 2^23 of them. Divided 2^28 times a corner then needs
// 23 + 28 = 51 bits of the 53 that a double has, and a center one more.
inline constexpr int bits_of_corners = 23;

/// That unit, of an interval whose ends are this far from zero at the most. It is as fine as it can be: the
/// region is then cut alike in every unit of length.
inline double unit_of_corners(double farthest) noexcept {
  return std::ldexp(1.0, std::ilogb(farthest) + 1 - bits_of_corners);
}

/// Whether all corners of boxes are exact in an interval: its width is a multiple of the unit, and its ends
/// of the edges of the smallest boxes.
inline bool has_exact_corners(double lower, double upper) noexcept {
  const double unit = unit_of_corners(std::max(std::abs(lower), std::abs(upper)));
  const double edge = std::ldexp(unit, -static_cast<int>(PoseTree::deepest_level));
  return std::isnormal(edge) && std::remainder(lower, edge) == 0.0 && std::remainder(upper, edge) == 0.0 &&
         std::remainder(upper - lower, unit) == 0.0;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_POSE_TREE_H
