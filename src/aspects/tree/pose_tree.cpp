// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/pose_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double least_units_across = 4096.0;

}  // namespace

std::optional<Box> exact_region(const Box& box) noexcept {
  Box exact = box;
  for (std::size_t i = 0; i < box.dimension; ++i) {
    const double farthest = std::max(std::abs(box.lower[i]), std::abs(box.upper[i]));
    if (!std::isfinite(farthest) || !(box.lower[i] < box.upper[i])) return std::nullopt;
    const double unit = unit_of_corners(farthest);
    if (!std::isnormal(unit) || !(box.width(i) >= least_units_across * unit)) return std::nullopt;
    if (has_exact_corners(box.lower[i], box.upper[i])) continue;
    exact.lower[i] = std::floor(box.lower[i] / unit) * unit;
    exact.upper[i] = std::ceil(box.upper[i] / unit) * unit;
  }
  return exact;
}

PoseTree::PoseTree(std::shared_ptr<const PoseSpace> space, std::size_t modes)
    : space_(std::move(space)),
      root_count_(space_->root_count()),
      region_(space_->region()),
      modes_(modes),
      first_child_(space_->root_count(), no_node),
      states_(space_->root_count() * modes, LeafState::pending()) {
  for (std::uint32_t level = 0; level <= deepest_level; ++level)
    for (std::size_t i = 0; i < dimension(); ++i)
      edges_[level][i] = std::ldexp(region_.width(i), -static_cast<int>(level));
}

void PoseTree::reserve_families(std::size_t count) {
  const std::size_t nodes = node_count() + count * children_per_node();
  parents_.reserve(parents_.size() + count);
  first_child_.reserve(nodes);
  states_.reserve(nodes * modes_);
}

NodeIndex PoseTree::append_children(NodeIndex node) {
  const auto first = static_cast<NodeIndex>(node_count());
  parents_.push_back(place(node));
  first_child_.resize(node_count() + children_per_node(), no_node);
  states_.resize(node_count() * modes_, LeafState::inherited());
  first_child_[node] = first;
  return first;
}

std::optional<NodeIndex> PoseTree::leaf_at(const MapPosition& position, std::size_t mode) const noexcept {
  if (!region_.contains(position.point)) return std::nullopt;
  NodeIndex node = position.root;
  MapPoint lower = region_.lower;
  // Corners are exact, in whatever order they are added up.
  for (std::size_t level = 1; state(node, mode).is_divided(); ++level) {
    NodeIndex rank = 0;
    for (std::size_t i = 0; i < dimension(); ++i) {
      const double center = lower[i] + edges_[level][i];
      if (!(position.point[i] >= center)) continue;
      rank |= NodeIndex{1} << i;
      lower[i] = center;
    }
    node = first_child_[node] + rank;
  }
  return node;
}

}  // namespace parallel_aspects
