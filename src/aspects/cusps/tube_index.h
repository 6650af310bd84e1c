// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_TUBE_INDEX_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_TUBE_INDEX_H

#include "aspects/cusps/cusp_trace.h"
#include "aspects/cusps/cusp_tube.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_TUBE_INDEX_H
