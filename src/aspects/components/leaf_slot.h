// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_SLOT_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_SLOT_H

#include "aspects/components/node_numbers.h"

#include <cstdint>

namespace parallel_aspects {

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_LEAF_SLOT_H
