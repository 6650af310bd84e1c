// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/persistence/cell_owners.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/tree/neighbour_leaves.h"

#include <algorithm>
#include <unordered_map>

namespace parallel_aspects {

void CellOwners::find() {
  owners_.clear();
  owner_of_.assign(cells_.tree().node_count(), none);
  const Faces faces = spread_to_whole_parts();
  add_aspects();
  find_groups(faces);
  sum_up();
}

std::uint32_t CellOwners::add(const CellOwner& owner) {
  owners_.push_back(owner);
  return static_cast<std::uint32_t>(owners_.size() - 1);
}

/// All of a common face is in S(mode, sign) where one of the two cells is inside, so what is whole in the
/// other meets it. Returns the faces of undecided cells.
CellOwners::Faces CellOwners::spread_to_whole_parts() {
  Faces faces;
  const auto spread = [this](NodeIndex from, NodeIndex to) {
    if (cells_.is_inside(from) && cells_.is_whole(to) && cells_.aspect(to) == 0)
      cells_.set_aspect(to, cells_.aspect(from));
  };
  visit_faces(cells_.tree(), 0, [&](NodeIndex a, NodeIndex b) {
    if (!cells_.is_inside(a) || !cells_.is_inside(b)) faces.emplace_back(a, b);
    spread(a, b);
    spread(b, a);
  });
  return faces;
}

void CellOwners::add_aspects() {
  inside_of_.clear();
  for (const NodeIndex cell : cells_.all()) {
    const int id = cells_.aspect(cell);
    if (id == 0) continue;
    const auto place = static_cast<std::size_t>(id);
    for (auto* owners : {&inside_of_, &rim_of_})
      if (owners->size() <= place) owners->resize(place + 1, none);
    if (inside_of_[place] == none) {
      inside_of_[place] = add({{id}, true});
      rim_of_[place] = add({{id}, false});
    }
    owner_of_[cell] = cells_.is_inside(cell) ? inside_of_[place] : rim_of_[place];
  }
}

void CellOwners::find_groups(const Faces& faces) {
  DisjointSets sets(cells_.tree().node_count());
  for (const auto& [a, b] : faces)
    if (cells_.aspect(a) == 0 && cells_.aspect(b) == 0) sets.unite(a, b);
  std::unordered_map<NodeIndex, std::uint32_t> group;  // by the cell that stands for it
  const auto touch = [&](NodeIndex cell, NodeIndex known) {
    if (cells_.aspect(cell) != 0 || cells_.aspect(known) == 0) return;
    const auto [found, is_new] = group.try_emplace(sets.find(cell), none);
    if (is_new) found->second = add({});
    owners_[found->second].aspects.insert(cells_.aspect(known));
  };
  for (const auto& [a, b] : faces) {
    touch(a, b);
    touch(b, a);
  }
  for (const NodeIndex cell : cells_.all()) {
    if (cells_.aspect(cell) != 0) continue;
    const auto found = group.find(sets.find(cell));
    if (found != group.end()) owner_of_[cell] = found->second;
  }
}

/// Children come behind their parents.
void CellOwners::sum_up() {
  const PoseTree& tree = cells_.tree();
  within_.assign(tree.node_count(), 0);
  for (auto node = static_cast<NodeIndex>(tree.node_count()); node-- > 0;) {
    if (owner_of_[node] != none) within_[node] = bit(owner_of_[node]);
    if (!tree.state(node, 0).is_divided()) continue;
    for (NodeIndex rank = 0; rank < tree.children_per_node(); ++rank)
      within_[node] |= within_[tree.first_child(node) + rank];
  }
}

std::vector<NodeIndex> CellOwners::take_in(NodeIndex cell, const std::vector<NodeIndex>& children) {
  owner_of_.resize(cells_.tree().node_count(), none);
  within_.resize(owner_of_.size(), 0);
  std::vector<NodeIndex> found;
  for (const NodeIndex child : children) {
    const auto id = static_cast<std::size_t>(cells_.aspect(child));
    owner_of_[child] = id != 0 && cells_.is_inside(child) ? inside_of_[id] : owner_of_[cell];
    within_[child] = bit(owner_of_[child]);
  }
  for (const NodeIndex child : children)
    if (cells_.is_inside(child) && cells_.aspect(child) == 0) spread_aspect(child, found);
  return found;
}

/// A cell that is inside belongs to the aspect of every cell that it shares part of a face with.
void CellOwners::spread_aspect(NodeIndex inside, std::vector<NodeIndex>& found) {
  std::vector<NodeIndex> open{inside};
  while (!open.empty()) {
    const NodeIndex cell = open.back();
    open.pop_back();
    const std::vector<NodeIndex> near = neighbour_leaves(cells_.tree(), 0, cell);
    const auto known =
        std::find_if(near.begin(), near.end(), [this](NodeIndex each) { return cells_.aspect(each) != 0; });
    if (cells_.aspect(cell) != 0 || known == near.end()) continue;
    const int id = cells_.aspect(*known);
    cells_.set_aspect(cell, id);
    owner_of_[cell] = inside_of_[static_cast<std::size_t>(id)];
    within_[cell] = bit(owner_of_[cell]);
    found.push_back(cell);
    for (const NodeIndex next : near)
      if (cells_.is_inside(next) && cells_.aspect(next) == 0) open.push_back(next);
  }
}

}  // namespace parallel_aspects
