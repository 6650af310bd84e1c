// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/pose_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

// Corners are multiples of one grid unit, at most 2^23 of them. Divided 2^28 times a corner then needs
// 23 + 28 = 51 bits of the 53 that a double has, and a center one more.
constexpr int bits_of_corners = 23;
constexpr double least_units_across = 4096.0;

}  // namespace

// The unit is as fine as it can be: the box is then cut alike in every unit of length.
std::optional<Box> exact_region(const Box& box) noexcept {
  Box exact = box;
  for (std::size_t i = 0; i < box.dimension; ++i) {
    const double farthest = std::max(std::abs(box.lower[i]), std::abs(box.upper[i]));
    if (!std::isfinite(farthest) || !(box.lower[i] < box.upper[i])) return std::nullopt;
    const double unit = std::ldexp(1.0, std::ilogb(farthest) + 1 - bits_of_corners);
    if (!std::isnormal(unit) || !(box.width(i) >= least_units_across * unit)) return std::nullopt;
    exact.lower[i] = std::floor(box.lower[i] / unit) * unit;
    exact.upper[i] = std::ceil(box.upper[i] / unit) * unit;
  }
  return exact;
}

PoseTree::PoseTree(std::shared_ptr<const PoseSpace> space, std::size_t modes)
    : space_(std::move(space)),
      region_(space_->region()),
      modes_(modes),
      first_child_(space_->root_count(), no_node),
      states_(space_->root_count() * modes, LeafState::pending()) {
  for (std::uint32_t level = 0; level <= deepest_level; ++level)
    for (std::size_t i = 0; i < dimension(); ++i)
      edges_[level][i] = std::ldexp(region_.width(i), -static_cast<int>(level));
}

NodePlace PoseTree::place(NodeIndex node) const noexcept {
  if (node < root_count()) return {{}, 0, node};
  NodePlace place = parents_[family(node)];
  const NodeIndex rank = (node - static_cast<NodeIndex>(root_count())) & (children_per_node() - 1);
  for (std::size_t i = 0; i < dimension(); ++i) place.cell[i] = 2 * place.cell[i] + (rank >> i & 1U);
  ++place.level;
  return place;
}

Box PoseTree::box(NodeIndex node) const noexcept {
  const NodePlace at = place(node);
  Box box{dimension(), {}, {}};
  for (std::size_t i = 0; i < dimension(); ++i) {
    const double edge = edges_[at.level][i];
    box.lower[i] = region_.lower[i] + edge * at.cell[i];
    box.upper[i] = region_.lower[i] + edge * (at.cell[i] + 1.0);
  }
  return box;
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
  while (state(node, mode).is_divided()) node = first_child_[node] + box(node).rank_of(position.point);
  return node;
}

}  // namespace parallel_aspects
