// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_REGIONS_UNIQUENESS_DOMAINS_H
#define PARALLEL_ASPECTS_ASPECTS_REGIONS_UNIQUENESS_DOMAINS_H

#include "aspects/regions/found_regions.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Largest connected sets of basic regions of one aspect with no two over the same set of actuated values.
struct FoundDomains {
  std::vector<std::vector<std::size_t>> domains;  ///< indices of regions, rising
  bool complete = true;                           ///< whether these are all; else there were too many to list
};

/// Of the regions that are proved to be unique. Such a set with the paths between its regions is a uniqueness
/// domain: regions over different sets have no actuated values in common.
FoundDomains find_uniqueness_domains(const FoundRegions& found);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_REGIONS_UNIQUENESS_DOMAINS_H
