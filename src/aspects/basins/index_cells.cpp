// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/basins/index_cells.h"

#include "interval/interval.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace parallel_aspects {
namespace {

constexpr double close_enough = 0.02;   // bounds of the index in a cell, as a share of the upper one
constexpr double close_at_pose = 1e-9;  // likewise, at one pose
constexpr double any_gap = 1.0;         // likewise
constexpr std::size_t grain = 64;       // cells that are not worth another thread

}  // namespace

IndexCells::IndexCells(const AspectMap::Contents& map, std::size_t mode, int sign, ParallelIndex index)
    : map_(map), mode_(mode), sign_(sign), index_(index), tree_(map.tree.shared_space(), 1) {
  aspects_.assign(tree_.node_count(), 0);
  for (RootIndex root = 0; root < tree_.root_count(); ++root) copy(root, root);
  bounds_.resize(tree_.node_count());
}

/// The other sign is left out.
void IndexCells::copy(NodeIndex from, NodeIndex to) {
  const LeafState state = map_.tree.state(from, mode_);
  if (!state.is_divided()) {
    tree_.state(to, 0) = state.may_be(sign_) ? state : LeafState::outside();
    aspects_[to] = map_.leaf_aspect(from, mode_);
    return;
  }
  tree_.state(to, 0) = LeafState::undecided(true, true);
  const NodeIndex first = tree_.divide(to, [](std::size_t) { return true; });
  aspects_.resize(tree_.node_count(), 0);
  for (NodeIndex rank = 0; rank < tree_.children_per_node(); ++rank)
    copy(map_.tree.first_child(from) + rank, first + rank);
}

std::vector<NodeIndex> IndexCells::all() const {
  std::vector<NodeIndex> cells;
  for (NodeIndex node = 0; node < tree_.node_count(); ++node)
    if (is_cell(node)) cells.push_back(node);
  return cells;
}

IndexRange IndexCells::at(const MapPosition& position) const {
  const RoundingUpward rounding;
  const Box box{tree_.dimension(), position.point, position.point};
  const Interval range =
      map_.classifier->enclose_index(position.root, box, mode_, sign_, index_, close_at_pose);
  return {range.lower(), range.upper()};
}

const IndexCells::Bounds& IndexCells::bounds(NodeIndex node, Effort effort) const {
  Bounds& known = bounds_[node];
  if (known.effort >= effort) return known;
  const RoundingUpward rounding;
  const Interval range =
      map_.classifier->enclose_index(tree_.place(node).root, tree_.box(node), mode_, sign_, index_,
                                     effort == Effort::more ? close_enough : any_gap);
  known = {is_inside(node) ? range.lower() : 0.0, range.upper(), effort};
  return known;
}

void IndexCells::bound_all() const {
  const std::vector<NodeIndex> cells = all();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), grain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) bounds(cells[i], usual_effort(cells[i]));
  });
}

std::vector<NodeIndex> IndexCells::divide(const std::vector<NodeIndex>& cells) {
  std::vector<NodeIndex> children;
  for (const NodeIndex cell : cells) {
    if (!can_be_halved(cell)) continue;
    const NodeIndex first = add_children(cell);
    for (NodeIndex rank = 0; rank < tree_.children_per_node(); ++rank) children.push_back(first + rank);
  }
  bounds_.resize(tree_.node_count());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, children.size(), grain), [&](const auto& range) {
    const RoundingUpward rounding;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      if (tree_.state(children[i], 0).is_pending()) classify(children[i]);
      if (is_cell(children[i])) bounds(children[i], usual_effort(children[i]));
    }
  });
  const auto is_none = [this](NodeIndex child) { return !is_cell(child); };
  children.erase(std::remove_if(children.begin(), children.end(), is_none), children.end());
  return children;
}

/// Pending ones, unless the cell is inside: then they are, too.
NodeIndex IndexCells::add_children(NodeIndex cell) {
  const bool inside = is_inside(cell);
  tree_.state(cell, 0) = LeafState::undecided(true, true);
  const NodeIndex first = tree_.divide(cell, [](std::size_t) { return true; });
  aspects_.resize(tree_.node_count(), aspects_[cell]);
  for (NodeIndex rank = 0; inside && rank < tree_.children_per_node(); ++rank)
    tree_.state(first + rank, 0) = LeafState::inside(sign_);
  return first;
}

void IndexCells::classify(NodeIndex node) {
  const LeafState found = map_.classifier->state(tree_.place(node).root, tree_.box(node), mode_);
  tree_.state(node, 0) = found.may_be(sign_) ? found : LeafState::outside();
}

}  // namespace parallel_aspects
