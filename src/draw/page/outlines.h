// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PAGE_OUTLINES_H
#define PARALLEL_ASPECTS_DRAW_PAGE_OUTLINES_H

#include "draw/page/page_elements.h"

#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// What bounds the union of polygons that share whole sides, each turned the same way: the sides that two of
/// them share are left out. Points are rounded to 0.01 px; those on straight lines are left out, and loops
/// too small to see.
std::vector<PageLine> outlines_of(const std::vector<PageLine>& polygons);

/// Pieces with common ends put together to lines, likewise rounded and straightened.
std::vector<PageLine> joined_lines(const std::vector<std::pair<PagePoint, PagePoint>>& pieces);

/// Signed area that closed lines bound, positive where they turn as x turns to y [px^2].
double area_of(const std::vector<PageLine>& loops);

/// A point, and how far it is from the outline [px].
struct LabelPoint {
  PagePoint at;
  double clearance = 0.0;
};

/// Where in a union of polygons a label has most room; nothing where there are none.
std::optional<LabelPoint> label_point(const std::vector<PageLine>& polygons,
                                      const std::vector<PageLine>& outlines);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PAGE_OUTLINES_H
