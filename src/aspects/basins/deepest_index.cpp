// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/basins/deepest_index.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/tree/face_traversal.h"
#include "aspects/tree/neighbour_leaves.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double finest = 0.01;         // gap of the bounds within an aspect, as a share of the upper one
constexpr double fine_enough = 0.05;    // likewise where undecided cells count
constexpr double least_gap = 0.001;     // or this, of the normalised index
constexpr std::size_t halvings = 3000;  // for each aspect
constexpr std::size_t boxes_of_group = 20000;  // that are halved into, for each group and round
constexpr int max_rounds = 3;                  // since groups fall apart when they are halved
// With three coordinates undecided cells lie along surfaces: far more boxes than these would be needed to
// bound the index there, so they are taken as they are.
constexpr std::size_t largest_dimension_of_groups = 2;

}  // namespace

DeepestIndex::DeepestIndex(IndexCells& cells, ParallelIndex index, const MapControl& control)
    : cells_(cells), absolute_(index == ParallelIndex::normalised ? least_gap : 0.0), control_(control) {
  for (const NodeIndex cell : cells_.all())
    if (cells_.aspect(cell) != 0) put(cell);
}

void DeepestIndex::search() {
  halve_aspects();
  const int rounds = cells_.tree().dimension() <= largest_dimension_of_groups ? max_rounds : 0;
  if (rounds == 0) find_groups();
  for (int round = 0; round < rounds && !is_cancelled(control_); ++round) {
    find_groups();
    const bool any = halve_groups();
    halve_aspects();
    if (!any) break;
  }
}

std::map<int, IndexRange> DeepestIndex::ranges() const {
  std::map<int, IndexRange> ranges;
  for (const auto& [id, aspect] : aspects_) ranges[id] = {aspect.lower, upper(aspect.cells)};
  for (const Group& group : groups_)
    for (const int id : group.aspects) ranges[id].upper = std::max(ranges[id].upper, upper(group.cells));
  return ranges;
}

void DeepestIndex::put(NodeIndex cell) {
  InAspect& aspect =
      aspects_.try_emplace(cells_.aspect(cell), InAspect{Queue(ByUpper{&cells_}), 0.0}).first->second;
  aspect.cells.push(cell);
  aspect.lower = std::max(aspect.lower, cells_.lower(cell));
}

void DeepestIndex::halve_aspects() {
  for (auto& [id, aspect] : aspects_)
    for (std::size_t i = 0; i < halvings && !aspect.cells.empty() && !is_cancelled(control_); ++i) {
      const NodeIndex top = aspect.cells.top();
      if (cells_.upper(top) - aspect.lower <= finest * cells_.upper(top) || !cells_.can_be_halved(top)) break;
      aspect.cells.pop();
      for (const NodeIndex child : cells_.divide({top})) put(child);
    }
}

/// Cells of no known aspect that are connected through others such.
void DeepestIndex::find_groups() {
  groups_.clear();
  DisjointSets sets(cells_.tree().node_count());
  std::vector<std::pair<NodeIndex, int>> touching;  // a cell of no known aspect, and an aspect
  visit_faces(cells_.tree(), 0, [&](NodeIndex a, NodeIndex b) {
    if (cells_.aspect(a) == 0 && cells_.aspect(b) == 0) return sets.unite(a, b);
    if (cells_.aspect(a) == 0) touching.emplace_back(a, cells_.aspect(b));
    if (cells_.aspect(b) == 0) touching.emplace_back(b, cells_.aspect(a));
  });
  std::unordered_map<NodeIndex, std::size_t> place;  // of a group, by the cell that stands for it
  for (const auto& [cell, aspect] : touching) {
    const auto [known, is_new] = place.try_emplace(sets.find(cell), groups_.size());
    if (is_new) groups_.push_back({Queue(ByUpper{&cells_}), {}});
    groups_[known->second].aspects.insert(aspect);
  }
  for (const NodeIndex cell : cells_.all()) {
    if (cells_.aspect(cell) != 0) continue;
    const auto known = place.find(sets.find(cell));
    if (known != place.end()) groups_[known->second].cells.push(cell);
  }
}

/// Whether there was something to halve.
bool DeepestIndex::halve_groups() {
  bool any = false;
  for (Group& group : groups_) {
    any = any || upper(group.cells) > enough(group);
    halve(group);
  }
  return any;
}

void DeepestIndex::halve(Group& group) {
  const std::size_t most = boxes_of_group / cells_.tree().children_per_node();
  for (std::size_t i = 0; i < most && !is_cancelled(control_); ++i) {
    while (!group.cells.empty() && cells_.aspect(group.cells.top()) != 0) group.cells.pop();
    if (upper(group.cells) <= enough(group)) return;
    const NodeIndex top = group.cells.top();
    if (!cells_.can_be_halved(top)) return;
    group.cells.pop();
    for (const NodeIndex child : cells_.divide({top})) put(child, group);
  }
}

/// Up to where no upper bound of the group makes that of one of its aspects loose.
double DeepestIndex::enough(const Group& group) const {
  double least = std::numeric_limits<double>::infinity();
  for (const int id : group.aspects) {
    const double lower = aspects_.at(id).lower;
    least = std::min(least, std::max(lower / (1.0 - fine_enough), lower + absolute_));
  }
  return least;
}

void DeepestIndex::put(NodeIndex child, Group& group) {
  if (cells_.is_inside(child)) spread_aspect(child);
  if (cells_.aspect(child) == 0) group.cells.push(child);
}

/// A cell that is inside belongs to the aspect of every cell that it shares part of a face with.
void DeepestIndex::spread_aspect(NodeIndex inside) {
  std::vector<NodeIndex> open{inside};
  while (!open.empty()) {
    const NodeIndex cell = open.back();
    open.pop_back();
    const std::vector<NodeIndex> near = neighbour_leaves(cells_.tree(), 0, cell);
    const auto known =
        std::find_if(near.begin(), near.end(), [this](NodeIndex each) { return cells_.aspect(each) != 0; });
    if (cells_.aspect(cell) != 0 || known == near.end()) continue;
    cells_.set_aspect(cell, cells_.aspect(*known));
    put(cell);
    for (const NodeIndex next : near)
      if (cells_.is_inside(next) && cells_.aspect(next) == 0) open.push_back(next);
  }
}

}  // namespace parallel_aspects
