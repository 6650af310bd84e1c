// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TRACE_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TRACE_H

#include "aspects/cusps/cusp_tube.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <map>
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
  double lower = 0.0, upper = 0.0;  ///< of the held coordinate of `SliceFamily`
  MapPoint weights{1.0, 1.0, 1.0};  ///< times these, coordinates are of one size
};

/// Tube i with what lies beyond its points cut off: all of its arc belongs to the trace.
CuspTube core_of(const CuspTrace& trace, std::size_t i) noexcept;

/// Follows the curve through a point, which a box of `cusp_near` holds, both ways; up to ends of other traces
/// that it comes to.
CuspTrace trace_cusps(SliceFamily& family, const Box& start, const TraceBounds& bounds,
                      const std::vector<Box>& ends, const MapControl& control);

/// Tubes by the cells of a grid that they reach into: curves may have 10^5 of them, and each box of a search
/// is compared with those beside it alone.
class TubeIndex {
 public:
  explicit TubeIndex(const TraceBounds& bounds);

  void add(const CuspTube& tube);

  /// Whether it is proved that the box, moved by whole turns of both angles, lies in one of the tubes. Only
  /// those are asked that reach into the cell of its middle.
  bool holds(const Box& box) const;

 private:
  using Cell = std::array<int, 3>;

  int cell_of(double value, std::size_t axis) const noexcept;

  double first_;                    ///< held coordinate where cells are counted from
  std::array<double, 3> per_unit_;  ///< cells in a unit of each coordinate
  std::vector<CuspTube> tubes_;
  std::map<Cell, std::vector<std::size_t>> by_cell_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_TRACE_H
