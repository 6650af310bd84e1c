// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_INDETERMINATE_LEAVES_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_INDETERMINATE_LEAVES_H

#include "aspects/components/leaf_slot.h"
#include "aspects/tree/pose_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// Undecided leaves of which it is not known what they hold, each with its neighbours in the order in which
/// they came. A map has millions of them with some six neighbours each, so these lie beside the leaf, and
/// only what is more in further records.
class IndeterminateLeaves {
 public:
  /// How many were added; some may have been forgotten since.
  std::size_t size() const noexcept { return leaves_.size(); }

  void reserve(std::size_t count) {
    leaves_.reserve(count);
    is_examined_.reserve(count);
    was_divided_.reserve(count);
  }

  std::uint32_t add(NodeIndex node) {
    leaves_.push_back(Record(node));
    is_examined_.push_back(false);
    was_divided_.push_back(false);
    return static_cast<std::uint32_t>(leaves_.size() - 1);
  }

  /// `no_node` once it was forgotten.
  NodeIndex node(std::size_t item) const noexcept { return leaves_[item].node; }

  /// So many leaves before it is asked for, a search has a leaf come from memory: it may lie anywhere.
  static constexpr std::size_t fetched_ahead = 8;
  void fetch(std::size_t item) const noexcept { __builtin_prefetch(&leaves_[item]); }

  /// Whether it was looked into again.
  bool is_examined(std::size_t item) const noexcept { return is_examined_[item]; }
  void set_examined(std::size_t item) noexcept { is_examined_[item] = true; }

  /// The leaf is none any more, and has no neighbours.
  void forget(std::size_t item) noexcept { leaves_[item] = Record(no_node); }

  /// Of a leaf that was forgotten: whether it was divided, so that its children may be indeterminate.
  bool was_divided(std::size_t item) const noexcept { return was_divided_[item]; }
  void set_divided(std::size_t item) noexcept { was_divided_[item] = true; }

  void add_neighbour(std::size_t item, LeafSlot neighbour);
  void remove_neighbour(std::size_t item, LeafSlot neighbour);
  std::vector<LeafSlot> neighbours(std::size_t item) const;

  template <class Visitor>
  void visit_neighbours(std::size_t item, const Visitor& visit) const {
    for (const Record* record = &leaves_[item];; record = &more_[record->next]) {
      for (const LeafSlot neighbour : record->neighbours) {
        if (neighbour.is_nowhere()) return;
        visit(neighbour);
      }
      if (record->next == none) return;
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  struct Record {
    explicit Record(NodeIndex of) noexcept : node(of) {}

    NodeIndex node;
    std::array<LeafSlot, 6> neighbours{LeafSlot::nowhere(), LeafSlot::nowhere(), LeafSlot::nowhere(),
                                       LeafSlot::nowhere(), LeafSlot::nowhere(), LeafSlot::nowhere()};
    std::uint32_t next = none;  // the record of `more_` with further neighbours
  };

  std::vector<Record> leaves_, more_;
  std::vector<bool> is_examined_, was_divided_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_INDETERMINATE_LEAVES_H
