// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/leaf_numbers.h"

#include <algorithm>

namespace parallel_aspects {

void IndeterminateLeaves::add_neighbour(std::size_t item, LeafSlot neighbour) {
  Record* record = &leaves_[item];
  while (!record->neighbours.back().is_nowhere() && record->next != none) record = &more_[record->next];
  if (record->neighbours.back().is_nowhere()) {
    *std::find(record->neighbours.begin(), record->neighbours.end(), LeafSlot::nowhere()) = neighbour;
    return;
  }
  record->next = static_cast<std::uint32_t>(more_.size());
  more_.emplace_back(no_node);
  more_.back().neighbours.front() = neighbour;
}

void IndeterminateLeaves::remove_neighbour(std::size_t item, LeafSlot neighbour) {
  std::vector<LeafSlot> kept = neighbours(item);
  kept.erase(std::remove(kept.begin(), kept.end(), neighbour), kept.end());
  auto next = kept.begin();
  for (Record* record = &leaves_[item];; record = &more_[record->next]) {
    for (LeafSlot& place : record->neighbours) place = next == kept.end() ? LeafSlot::nowhere() : *next++;
    if (record->next == none) return;
  }
}

std::vector<LeafSlot> IndeterminateLeaves::neighbours(std::size_t item) const {
  std::vector<LeafSlot> result;
  result.reserve(2 * leaves_[item].neighbours.size());
  visit_neighbours(item, [&result](LeafSlot neighbour) { result.push_back(neighbour); });
  return result;
}

}  // namespace parallel_aspects
