// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/indeterminate_leaves.h"

#include <algorithm>

namespace parallel_aspects {

void IndeterminateLeaves::add_neighbour(std::size_t item, NodeIndex neighbour) {
  Record* record = &leaves_[item];
  while (record->neighbours.back() != no_node && record->next != none) record = &more_[record->next];
  if (record->neighbours.back() == no_node) {
    *std::find(record->neighbours.begin(), record->neighbours.end(), no_node) = neighbour;
    return;
  }
  record->next = static_cast<std::uint32_t>(more_.size());
  more_.emplace_back(no_node);
  more_.back().neighbours.front() = neighbour;
}

void IndeterminateLeaves::remove_neighbour(std::size_t item, NodeIndex neighbour) {
  std::vector<NodeIndex> kept = neighbours(item);
  kept.erase(std::remove(kept.begin(), kept.end(), neighbour), kept.end());
  auto next = kept.begin();
  for (Record* record = &leaves_[item];; record = &more_[record->next]) {
    for (NodeIndex& place : record->neighbours) place = next == kept.end() ? no_node : *next++;
    if (record->next == none) return;
  }
}

std::vector<NodeIndex> IndeterminateLeaves::neighbours(std::size_t item) const {
  std::vector<NodeIndex> result;
  visit_neighbours(item, [&result](NodeIndex neighbour) { result.push_back(neighbour); });
  return result;
}

}  // namespace parallel_aspects
