// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_ASPECT_ROWS_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_ASPECT_ROWS_H

#include "draw/plane/palette.h"
#include "rviz/panel/panel_model.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// One aspect in the table; with six degrees of freedom, one component of the roadmap.
struct AspectRow {
  std::uint32_t id = 0;  ///< of the aspect; 0 for a component of the roadmap
  std::string name;      ///< "3", or "component 2"
  std::string sign;      ///< of det A, "> 0" or "< 0"
  std::string
      size;  ///< measure in the unit of `unit_of`, as `aspects map` prints it; or the number of samples
  std::string clearance;  ///< radius of the largest ball in it [m or rad]
  std::string index;      ///< inverse condition number at the middle of that ball; empty while not known
  std::string tip;
  Rgb color = 0;  ///< as the display draws it
  bool present = false;
};

/// The aspects of one working mode.
struct ModeRows {
  std::string mode;  ///< "(+,-)"
  bool present = false;
  std::vector<AspectRow> aspects;
};

/// Modes in the order of their first aspect; empty while no map is known.
std::vector<ModeRows> rows_of(const NodeView& view);

/// Of the sizes, such as "m²"; empty while no map is known.
std::string unit_of(const NodeView& view);

/// The text below the table, such as how many aspects are proved; why it is empty, where it is.
std::string count_text(const NodeView& view);

/// Ids of all aspects of the map.
std::set<std::uint32_t> ids_of(const NodeView& view);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_ASPECT_ROWS_H
