// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_EMPTY_MAP_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_EMPTY_MAP_H

#include "parallel_aspects/aspects/aspect_map.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Why a map holds no aspect, with what to change, in a sentence; empty where it holds one, or where it is
/// cancelled. It tries what single constraints leave out in coarse maps of the same region, which may take
/// some seconds.
std::string why_empty(const AspectMap& map, const MapControl& control = {});

/// That positions with these names lie outside of those that the legs reach; empty where they do not.
std::string why_out_of_reach(const Box& region, const std::optional<Box>& reach,
                             const std::vector<std::string>& names);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_EMPTY_MAP_H
