// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TRACE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TRACE_H

#include "aspects/cusps/cusp_family.h"
#include "aspects/cusps/cusp_tube.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_control.h"

#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Where the trace of a curve ended.
enum class TraceEnd {
  left,    ///< at the end of another trace, or the last tube is outside of the range of held values, or of
           ///< limits
  failed,  ///< where no further tube was proved
};

/// A connected piece of a curve of cusps, or all of a closed one.
///
/// Tube i has the curve from point i to point i + 1: boxes that hold one cusp each, and lie in the tube. Of a
/// closed curve the first point ends the last tube. A tube does not meet the point before its first, so that
/// the curve goes on and never back.
struct CuspTrace {
  std::vector<Box> points;
  std::vector<CuspTube> tubes;
  bool closed = false;
  std::array<TraceEnd, 2> ends{TraceEnd::left, TraceEnd::left};  ///< at the first and at the last point
};

/// What bounds traces, and how coordinates compare.
struct TraceBounds {
  double lower = 0.0, upper = 0.0;  ///< of the held coordinate of `CuspFamily`
  MapPoint weights{1.0, 1.0, 1.0};  ///< times these, coordinates are of one size
};

/// Tube i with what lies beyond its points cut off: all of its arc belongs to the trace.
CuspTube core_of(const CuspTrace& trace, std::size_t i) noexcept;

/// Follows the curve through a point, which a box of `cusp_near` holds, both ways; up to ends of other traces
/// that it comes to.
CuspTrace trace_cusps(CuspFamily& family, const Box& start, const TraceBounds& bounds,
                      const std::vector<Box>& ends, const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TRACE_H
