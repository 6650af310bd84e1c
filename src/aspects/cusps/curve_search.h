// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_CURVE_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_CURVE_SEARCH_H

#include "aspects/cusps/cusp_family.h"
#include "aspects/cusps/cusp_trace.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_control.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// All curves of cusps of a family.
struct CuspTraces {
  std::vector<CuspTrace> traces;  ///< no two the same
  std::vector<Box> undecided;     ///< whatever else there is within limits, is in these
};

/// Boxes of the family are excluded by bounds, as those of a slice are by `find_cusp_boxes`, or hold one arc
/// of a curve by `test_tube`. That is followed both ways, unless a tube of a curve that is known holds a
/// point of it. So closed curves are found like any others. After `most_evaluations` those that are left are
/// undecided.
///
/// Needs a live `RoundingUpward`.
CuspTraces find_cusp_traces(CuspFamily& family, const TraceBounds& bounds, std::size_t most_evaluations,
                            const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_CURVE_SEARCH_H
