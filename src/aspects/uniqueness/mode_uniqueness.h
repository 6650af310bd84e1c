// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_MODE_UNIQUENESS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_MODE_UNIQUENESS_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"

#include <cstddef>

namespace parallel_aspects {

/// Of three legs of any kind but actuated elbows, over all poses within limits: fills numbers of solutions,
/// basic regions and uniqueness domains, by working mode. Each of these has a division of its own of the
/// actuated values, into so many cells at most.
void find_regions_of_modes(std::size_t most_cells, const MapControl& control, Uniqueness& result);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_MODE_UNIQUENESS_H
