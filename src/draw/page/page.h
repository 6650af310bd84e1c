// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PAGE_PAGE_H
#define PARALLEL_ASPECTS_DRAW_PAGE_PAGE_H

#include "draw/page/page_elements.h"
#include "draw/page/panel.h"
#include "draw/scene/map_scene.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// Panels that belong together, in a row.
struct PageFigure {
  std::string title;
  std::vector<LegendEntry> entries;  ///< of which the first are written
  std::vector<PagePanel> panels;
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

/// Planes of a map, under this title.
Page page_of(const MapScene& scene, const std::string& title);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PAGE_PAGE_H
