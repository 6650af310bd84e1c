// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SLICE_UNIQUENESS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SLICE_UNIQUENESS_H

#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/uniqueness.h"

namespace parallel_aspects {

/// Numbers of solutions, basic regions and uniqueness domains of a slice of legs of any kind, but elbows,
/// with one joint held, whose map is there.
void find_regions_of_slice(const MapControl& control, Uniqueness& result);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SLICE_UNIQUENESS_H
