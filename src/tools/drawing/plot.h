// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/boundary_curves.h"
#include "tools/drawing/page_elements.h"
#include "tools/drawing/plot_plane.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects::tools {

/// A line in the workspace of one aspect, as the outline of a shape.
struct PlotOutline {
  int aspect = 0;                     ///< id
  std::vector<Eigen::Vector2d> line;  ///< in the plane that is drawn [m or rad]
};

/// What is drawn of a map.
struct PlotOptions {
  std::vector<WorkingMode> modes;  ///< empty for all
  std::optional<PlotSection> section;
  IndexLevels levels;
  bool each_aspect = false;  ///< a figure for each aspect, not for each working mode
  std::vector<PlotOutline> outlines;
  bool leaves = false;  ///< the boxes of the map, with those that are undecided, in place of areas
};

/// The figures of the paper: the workspace and, where it is a plane, the joint space of each working mode, or
/// of each aspect. Maps with three coordinates without a section are seen as bodies. `checkpoint` is called
/// now and then; it may throw.
Picture draw_plot(
    const std::shared_ptr<const AspectMap>& map, const PlotOptions& options,
    const std::function<void()>& checkpoint = [] {});

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H
