// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PAGE_PAGE_H
#define PARALLEL_ASPECTS_DRAW_PAGE_PAGE_H

#include "parallel_aspects/aspects/aspect_map.h"

#include "draw/page/page_elements.h"
#include "draw/page/panel.h"
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What a colour means: of an area, or of a line.
struct LegendEntry {
  Rgb color = 0;
  bool is_line = false;
  std::string text;
  bool is_framed = false;  ///< an area that is not seen on the page without a frame
};

/// "aspect 3: det A > 0, 193.6 m^2"
std::string aspect_words(const AspectMap& map, const Aspect& aspect);

/// The first of these aspects, and how many more there are.
std::vector<LegendEntry> aspect_entries(const AspectMap& map, const std::vector<Rgb>& colors,
                                        const std::set<int>& ids);

/// Why aspects are not drawn, and which: the first of them, and how many more there are.
std::string missing_aspects(const std::vector<int>& ids, const std::string& why);

/// Panels that belong together, in a row.
struct PageFigure {
  std::string title;
  std::vector<LegendEntry> entries;
  std::vector<PanelContents> panels;
};

/// Figures under a title, as many beside each other as fit.
struct Page {
  std::string title;
  std::vector<std::string> notes;
  std::vector<PageFigure> figures;
  std::vector<LegendEntry> legend;
  double side = 260.0;  ///< of the panels [px]
};

PagePicture draw_page(const Page& page);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PAGE_PAGE_H
