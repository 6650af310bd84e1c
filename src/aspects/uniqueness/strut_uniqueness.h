// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_STRUT_UNIQUENESS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_STRUT_UNIQUENESS_H

#include "aspects/cusps/cusp_search.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"

#include <vector>

namespace parallel_aspects {

/// Of three struts, in the slice of the map: fills nodes. `cusps` are all that the slice has, whatever the
/// limits.
void find_nodes(const std::vector<CuspBox>& cusps, const MapControl& control, Uniqueness& result);

/// Of three struts, in the slice of the map, which holds one of them, or over all poses within limits: fills
/// numbers of solutions, basic regions and uniqueness domains.
void find_regions_of_struts(std::size_t most_cells, const MapControl& control, Uniqueness& result);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_STRUT_UNIQUENESS_H
