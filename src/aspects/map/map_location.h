// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_MAP_LOCATION_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_MAP_LOCATION_H

#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_space.h"

#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Where a working mode stands in the map; nothing where it is not mapped.
std::optional<std::size_t> mode_index(const AspectMap::Contents& map, const WorkingMode& mode) noexcept;

/// See AspectMap::locate. Neither allocates nor throws.
Location locate(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position) noexcept;

/// The same where `proved_sign` is known already of the position.
Location locate(const AspectMap::Contents& map, std::size_t mode, const MapPosition& position,
                int proved_sign) noexcept;

/// Whether two aspects, by their ids, are one or not yet proved to be two.
bool may_be_one(const AspectMap& map, int first, int second);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_MAP_LOCATION_H
