// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/regions/found_regions.h"

#include <algorithm>
#include <set>

namespace parallel_aspects {

bool may_have_new_neighbours(const std::vector<FoundRegion>& regions, const std::set<RegionPair>& known,
                             const std::vector<std::size_t>& over_one,
                             const std::vector<std::size_t>& over_other) {
  for (const std::size_t region : over_one)
    for (const std::size_t other : over_other)
      if (regions[region].aspect != 0 && regions[region].aspect == regions[other].aspect &&
          known.count(std::minmax(region, other)) == 0)
        return true;
  return false;
}

bool have_own_aspects(const std::vector<int>& aspects) {
  const std::set<int> different(aspects.begin(), aspects.end());
  return different.size() == aspects.size() && different.count(0) == 0;
}

std::vector<std::size_t> add_regions(const RegionsOfSet& of, FoundRegions& result) {
  const auto label = [&](std::size_t k) { return of.labels.empty() ? k : of.labels[k]; };
  std::vector<std::size_t> sizes(of.aspects.size(), 0), regions(of.aspects.size());
  for (std::size_t k = 0; k < sizes.size(); ++k) ++sizes[label(k)];
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (label(k) != k) {
      regions[k] = regions[label(k)];
      continue;
    }
    regions[k] = result.regions.size();
    const bool is_unique = of.aspects[k] != 0 && sizes[k] == 1 && of.is_consistent;
    result.regions.push_back({of.set, k, of.aspects[k], is_unique, of.measure});
  }
  return regions;
}

void append(const FoundRegions& more, std::size_t first_set, FoundRegions& result) {
  const std::size_t first = result.regions.size();
  for (FoundRegion region : more.regions) {
    region.set += first_set;
    result.regions.push_back(region);
  }
  for (const auto& [a, b] : more.neighbours) result.neighbours.emplace_back(first + a, first + b);
}

}  // namespace parallel_aspects
