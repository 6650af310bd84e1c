// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/graph/joined_sets.h"

#include "aspects/components/disjoint_sets.h"

#include <cstdint>
#include <map>
#include <utility>

namespace parallel_aspects {

std::vector<AspectSet> joined_sets(const std::vector<int>& signs, const std::vector<Neighbours>& gates) {
  DisjointSets joined(signs.size());
  for (const Neighbours& gate : gates)
    if (gate.proved && gate.crossing == Crossing::serial)
      joined.unite(static_cast<std::uint32_t>(gate.first - 1), static_cast<std::uint32_t>(gate.second - 1));
  std::map<std::uint32_t, AspectSet> sets;
  for (std::uint32_t i = 0; i < signs.size(); ++i) {
    AspectSet& set = sets[joined.find(i)];
    set.aspects.push_back(static_cast<int>(i) + 1);
    set.determinant_sign = signs[i];
  }
  std::vector<AspectSet> result;
  for (auto& item : sets) result.push_back(std::move(item.second));
  return result;
}

void group_sets(const std::function<bool(int, int)>& may_join, AspectGraph& graph) {
  const std::vector<AspectSet>& sets = graph.sets;
  graph.set_group.assign(sets.size(), 0);
  graph.proved_set_count = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::size_t& group = graph.set_group[i] = i;
    for (std::size_t k = 0; k < i && group == i; ++k)
      if (sets[k].determinant_sign == sets[i].determinant_sign &&
          may_join(sets[k].aspects.front(), sets[i].aspects.front()))
        group = graph.set_group[k];
    graph.proved_set_count += group == i ? 1 : 0;
  }
}

}  // namespace parallel_aspects
