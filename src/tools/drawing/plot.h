// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <Eigen/Core>

#include "draw/page/page_elements.h"
#include "draw/page/panel.h"
#include "draw/plane/map_pictures.h"
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects::tools {

/// A section through a map: what is held, or in SO3 the torsion [rad].
struct PlotSection {
  std::optional<MapSlice> slice;
  double torsion = 0.0;
};

/// The plane of poses that is drawn.
struct PlotPlane {
  PoseSlice slice;
  Eigen::AlignedBox2d bounds;
  std::array<PanelAxis, 2> axes;
  bool keeps_proportion = false;
};

/// That of a map of two coordinates, or of a section through one of three.
PlotPlane plane_of(const AspectMap& map, const std::optional<PlotSection>& section);

/// How many coordinates the boxes of a map have, or its orientations.
std::size_t dimension_of(const AspectMap& map);

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
PagePicture draw_plot(
    const std::shared_ptr<const AspectMap>& map, const PlotOptions& options,
    const std::function<void()>& checkpoint = [] {});

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H
