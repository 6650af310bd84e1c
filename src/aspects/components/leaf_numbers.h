// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_NUMBERS_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_NUMBERS_H

#include "aspects/tree/pose_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// A number for each of some nodes of a tree, and `none` for the others. Nodes that have one lie together:
/// blocks of nodes in which none has a number take no memory but an index.
class NodeNumbers {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  std::uint32_t operator[](NodeIndex node) const noexcept {
    const std::uint32_t block = node / block_size < blocks_.size() ? blocks_[node / block_size] : none;
    return block == none ? none : numbers_[block + node % block_size];
  }

  void set(NodeIndex node, std::uint32_t number) {
    if (node / block_size >= blocks_.size()) blocks_.resize(node / block_size + 1, none);
    std::uint32_t& block = blocks_[node / block_size];
    if (block == none) {
      if (number == none) return;
      block = static_cast<std::uint32_t>(numbers_.size());
      numbers_.resize(numbers_.size() + block_size, none);
    }
    numbers_[block + node % block_size] = number;
  }

  /// For nodes below `node_count`, of which those that get a number are in so many blocks.
  void reserve(std::size_t node_count, std::size_t blocks) {
    blocks_.resize((node_count + block_size - 1) / block_size, none);
    numbers_.reserve(block_size * blocks);
  }

  /// Takes the numbers of all nodes, which are these, and keeps the memory.
  void clear(const std::vector<NodeIndex>& nodes) noexcept {
    for (const NodeIndex node : nodes) blocks_[node / block_size] = none;
    numbers_.clear();
  }

  /// Nodes of one block have the same.
  static NodeIndex block_of(NodeIndex node) noexcept { return node / block_size; }

 private:
  static constexpr NodeIndex block_size = 8;

  std::vector<std::uint32_t> blocks_, numbers_;
};

/// Where the graph of a set keeps a leaf: among the indeterminate leaves, among the members of components, or
/// nowhere, as it holds nothing of the set.
class LeafSlot {
 public:
  static constexpr LeafSlot nowhere() noexcept { return LeafSlot(NodeNumbers::none); }
  static constexpr LeafSlot indeterminate(std::uint32_t item) noexcept { return LeafSlot(item | flag); }
  static constexpr LeafSlot member(std::uint32_t place) noexcept { return LeafSlot(place); }

  explicit constexpr LeafSlot(std::uint32_t number) noexcept : number_(number) {}

  constexpr std::uint32_t number() const noexcept { return number_; }
  constexpr bool is_nowhere() const noexcept { return number_ == NodeNumbers::none; }
  constexpr bool is_member() const noexcept { return (number_ & flag) == 0; }
  constexpr bool is_indeterminate() const noexcept { return !is_member() && !is_nowhere(); }

  /// Among the members, where it is one.
  constexpr std::uint32_t place() const noexcept { return number_; }
  /// Among the indeterminate leaves, where it is one.
  constexpr std::uint32_t item() const noexcept { return number_ & ~flag; }

  friend constexpr bool operator==(LeafSlot a, LeafSlot b) noexcept { return a.number_ == b.number_; }

 private:
  static constexpr std::uint32_t flag = 0x80000000U;

  std::uint32_t number_;
};

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

  /// Whether it was examined again.
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

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_NUMBERS_H
