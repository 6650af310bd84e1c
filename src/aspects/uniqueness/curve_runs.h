// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CURVE_RUNS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CURVE_RUNS_H

#include "aspects/cusps/cusp_trace.h"
#include "aspects/cusps/cusp_tube.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"

#include <vector>

namespace parallel_aspects {

/// A point of a run.
struct CurvePoint {
  Box box;            ///< of the family: it holds a cusp of the curve
  int held_sign = 0;  ///< of B_jj of the leg whose joint is held
};

/// A longest piece of a curve within limits. Between two events in turn the held value rises or falls.
struct CurveRun {
  bool closed = false;
  std::vector<CurvePoint> points;
  std::vector<CuspEvent> events;  ///< ends among them; a closed curve with none of them has no end
};

/// What a curve has within limits.
struct CurveRuns {
  std::vector<CurveRun> runs;
  std::vector<CuspEvent> touches;  ///< where it may come within limits, or not
};

/// Of a trace, between these held coordinates and within limits of the joints that move. Nothing when
/// cancelled.
CurveRuns runs_of(SliceFamily& family, const CuspTrace& trace, const Interval& range,
                  const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CURVE_RUNS_H
