// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_PLANE_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_PLANE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_slice.h"
#include "tools/drawing/panel.h"

#include <array>
#include <optional>

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

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_PLANE_H
