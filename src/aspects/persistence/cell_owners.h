// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_CELL_OWNERS_H
#define PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_CELL_OWNERS_H

#include "aspects/persistence/index_cells.h"
#include "aspects/tree/pose_tree.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Cells that are treated together, and the aspects to which their part of S(mode, sign) may belong.
struct CellOwner {
  std::set<int> aspects;   ///< ids
  bool is_inside = false;  ///< whether they are the inside cells of one aspect
};

/// Which cells may hold poses of which aspects.
///
/// An aspect lies in its inside cells, in whole parts of undecided cells beside these, and in *groups* of
/// other undecided cells that are connected with it through such cells. What is inside such a group and
/// shares a face with a cell of the aspect belongs to it.
class CellOwners {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// Finds them, and reports to `cells` to which aspect whole parts belong.
  explicit CellOwners(IndexCells& cells) : cells_(cells) { find(); }

  /// Finds them anew after cells were halved, since groups may fall apart.
  void find();

  const std::vector<CellOwner>& all() const noexcept { return owners_; }
  /// The owner of a cell; `none` where it is connected with no known aspect.
  std::uint32_t of(NodeIndex cell) const noexcept { return owner_of_[cell]; }

  /// The owners of the cells in a node: bit i for those whose number is i modulo 64.
  std::uint64_t within(NodeIndex node) const noexcept { return within_[node]; }
  static std::uint64_t bit(std::size_t owner) noexcept { return std::uint64_t{1} << (owner % 64); }

  /// Adds the children of a cell; returns the inside ones that were found to belong to an aspect, and
  /// inside cells that border on them and so belong to it, too.
  std::vector<NodeIndex> take_in(NodeIndex cell, const std::vector<NodeIndex>& children);

 private:
  using Faces = std::vector<std::pair<NodeIndex, NodeIndex>>;

  std::uint32_t add(const CellOwner& owner);
  void add_aspects();
  Faces spread_to_whole_parts();
  void find_groups(const Faces& faces);
  void sum_up();
  void spread_aspect(NodeIndex inside, std::vector<NodeIndex>& found);

  IndexCells& cells_;
  std::vector<CellOwner> owners_;
  std::vector<std::uint32_t> inside_of_, rim_of_;  // owners, by id
  std::vector<std::uint32_t> owner_of_;            // by node
  std::vector<std::uint64_t> within_;              // likewise
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_CELL_OWNERS_H
