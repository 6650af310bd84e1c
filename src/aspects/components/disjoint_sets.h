// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_DISJOINT_SETS_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_DISJOINT_SETS_H

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Union-find over 0, 1, 2, ...; the smallest member stands for its set, so results do not depend on the
/// order of unions.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  void reserve(std::size_t count) { parent_.reserve(count); }

  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }

  std::uint32_t find(std::uint32_t item) noexcept {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  void unite(std::uint32_t a, std::uint32_t b) noexcept {
    a = find(a);
    b = find(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

  std::size_t size() const noexcept { return parent_.size(); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_DISJOINT_SETS_H
