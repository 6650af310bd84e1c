// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_REGIONS_FOUND_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_REGIONS_FOUND_REGIONS_H

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The poses that one solution of a set of actuated values moves through as these move all over the set.
struct FoundRegion {
  std::size_t set = 0;       ///< index of the set
  std::size_t solution = 0;  ///< index of the solution, in the set
  int aspect = 0;            ///< id
  /// Proved: no two of its poses over what was followed have the same actuated values; or over any piece of
  /// the set, where the aspect has one solution there.
  bool is_unique = false;
  double measure = 0.0;  ///< of the actuated values of these, a lower bound [m^2 or m^3]
};

/// The basic regions of all aspects, and which of them are neighbours: a path of regular poses, which is
/// proved, leads from one to the other.
struct FoundRegions {
  std::vector<FoundRegion> regions;
  std::vector<std::pair<std::size_t, std::size_t>>
      neighbours;  ///< indices, the smaller first; each pair once
};

/// Indices of two regions, the smaller first.
using RegionPair = std::pair<std::size_t, std::size_t>;

/// Whether some of these regions, over one set, share their aspect with some of others, over another, and are
/// not among the neighbours that are known.
bool may_have_new_neighbours(const std::vector<FoundRegion>& regions, const std::set<RegionPair>& known,
                             const std::vector<std::size_t>& over_one,
                             const std::vector<std::size_t>& over_other);

/// Whether each of these solutions is in an aspect of its own, so that closed paths lead it to nothing but
/// itself.
bool have_own_aspects(const std::vector<int>& aspects);

/// What is known of the solutions of a set.
struct RegionsOfSet {
  std::size_t set = 0;                ///< index of the set
  std::vector<int> aspects;           ///< by solution; 0 where it is not known
  std::vector<std::size_t> labels{};  ///< the least solution that closed paths lead each to; empty: itself
  bool is_consistent = true;          ///< whether it is known of all closed paths where they lead
  double measure = 0.0;               ///< of the actuated values that this is known of, a lower bound
};

/// Adds them; the region of each solution.
std::vector<std::size_t> add_regions(const RegionsOfSet& of, FoundRegions& result);

/// Adds those over other sets, `first_set` and so on.
void append(const FoundRegions& more, std::size_t first_set, FoundRegions& result);

/// Largest connected sets of basic regions of one aspect with no two over the same set of actuated values.
struct FoundDomains {
  std::vector<std::vector<std::size_t>> domains;  ///< indices of regions, rising
  bool complete = true;                           ///< whether these are all; else there were too many to list
};

/// Of the regions that are proved to be unique. Such a set with the paths between its regions is a uniqueness
/// domain: regions over different sets have no actuated values in common.
FoundDomains find_uniqueness_domains(const FoundRegions& found);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_REGIONS_FOUND_REGIONS_H
