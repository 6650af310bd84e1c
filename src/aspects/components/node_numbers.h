// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_NODE_NUMBERS_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_NODE_NUMBERS_H

#include "aspects/tree/pose_tree.h"

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_NODE_NUMBERS_H
