// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/plot.h"

#include "draw/page/page.h"
#include "draw/page/solid_view.h"
#include "tools/report/reports.h"

namespace parallel_aspects::tools {

PagePicture draw_plot(const std::shared_ptr<const AspectMap>& map, const PlotOptions& options,
                      const std::function<void()>& checkpoint) {
  const std::string title = map->manipulator()->name() + ": " + aspect_count(*map);
  if (dimension_of(*map) == 3 && !options.section) {
    Page page;
    page.title = title;
    add_solids(map, options.modes.empty() ? map->working_modes() : options.modes, checkpoint, page);
    return draw_page(page);
  }
  constexpr double side = 260.0, side_of_aspects = 205.0;  // [px]
  Page page = page_of(map_scene(map, options, checkpoint), title);
  page.side = options.each_aspect && JointProjection::is_possible(*map) ? side_of_aspects : side;
  return draw_page(page);
}

}  // namespace parallel_aspects::tools
