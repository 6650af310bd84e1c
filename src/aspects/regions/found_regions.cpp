// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/regions/found_regions.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

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

namespace {

// Choices of one region of every set that are examined for one aspect.
constexpr std::size_t most_choices = 20000;

using Regions = std::vector<std::size_t>;

/// The regions of one aspect by the set that they lie over.
std::vector<Regions> alternatives(const FoundRegions& found, int aspect) {
  std::map<std::size_t, Regions> by_set;
  for (std::size_t i = 0; i < found.regions.size(); ++i)
    if (found.regions[i].aspect == aspect && found.regions[i].is_unique)
      by_set[found.regions[i].set].push_back(i);
  std::vector<Regions> result;
  for (auto& [set, regions] : by_set) result.push_back(std::move(regions));
  return result;
}

class DomainSearch {
 public:
  explicit DomainSearch(const FoundRegions& found) : beside_(found.regions.size()) {
    for (const auto& [a, b] : found.neighbours) {
      beside_[a].push_back(b);
      beside_[b].push_back(a);
    }
  }

  /// Whether all choices were examined. Every largest set is connected within some choice of one region of
  /// every set: its own, and any of the other sets.
  bool look_at(const std::vector<Regions>& alternatives) {
    Regions choice(alternatives.size(), 0);
    for (std::size_t count = 0; count < most_choices; ++count) {
      std::set<std::size_t> chosen;
      for (std::size_t s = 0; s < choice.size(); ++s) chosen.insert(alternatives[s][choice[s]]);
      take_components(chosen);
      std::size_t s = 0;
      while (s < choice.size() && ++choice[s] == alternatives[s].size()) choice[s++] = 0;
      if (s == choice.size()) return true;
    }
    return false;
  }

  /// Those that are part of no other.
  std::vector<Regions> largest() const {
    std::vector<Regions> result;
    for (const Regions& each : found_)
      if (std::none_of(found_.begin(), found_.end(), [&](const Regions& other) {
            return other.size() > each.size() &&
                   std::includes(other.begin(), other.end(), each.begin(), each.end());
          }))
        result.push_back(each);
    return result;
  }

 private:
  void take_components(std::set<std::size_t> chosen) {
    while (!chosen.empty()) {
      Regions component{*chosen.begin()};
      chosen.erase(chosen.begin());
      for (std::size_t i = 0; i < component.size(); ++i)
        for (const std::size_t next : beside_[component[i]])
          if (chosen.erase(next) > 0) component.push_back(next);
      std::sort(component.begin(), component.end());
      found_.insert(std::move(component));
    }
  }

  std::vector<Regions> beside_;
  std::set<Regions> found_;
};

}  // namespace

FoundDomains find_uniqueness_domains(const FoundRegions& found) {
  std::set<int> aspects;
  for (const FoundRegion& region : found.regions)
    if (region.aspect != 0) aspects.insert(region.aspect);
  FoundDomains result;
  for (const int aspect : aspects) {
    DomainSearch search(found);
    const std::vector<Regions> choices = alternatives(found, aspect);
    if (choices.empty()) continue;
    if (!search.look_at(choices)) result.complete = false;
    for (Regions& each : search.largest()) result.domains.push_back(std::move(each));
  }
  return result;
}

}  // namespace parallel_aspects
