// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_MARKED_LOCATION_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_MARKED_LOCATION_H

#include "aspects/map/map_contents.h"
#include "aspects/tree/inside_marks.h"

#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// A map of which many positions are to be located.
struct MarkedMap {
  const AspectMap::Contents& map;
  InsideMarks marks;

  explicit MarkedMap(const AspectMap::Contents& of) : map(of), marks(of.tree) {}
};

/// As `locate` of the map, sooner; nothing where the sign of det A at the position is not known yet.
Location locate(const MarkedMap& map, std::size_t mode, const MapPosition& position,
                std::optional<int> proved_sign = std::nullopt) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_MARKED_LOCATION_H
