// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/plot_plane.h"

#include "model/angles.h"

#include <string>

namespace parallel_aspects::tools {
namespace {

std::array<PanelAxis, 2> axes_of(const MapSlice& slice, const Eigen::AlignedBox2d& bounds) {
  const std::vector<std::string> names = coordinate_names(slice);
  std::array<PanelAxis, 2> axes;
  for (std::size_t i = 0; i < 2; ++i) {
    const bool turns = slice.joint.has_value() || i >= slice.free_positions();
    const auto k = static_cast<Eigen::Index>(i);
    axes[i] = {names[i] + (turns ? " [rad]" : " [m]"), bounds.min()[k], bounds.max()[k], turns};
  }
  return axes;
}

PlotPlane plane_of(const AspectMap& map, const MapSlice& slice) {
  const Eigen::AlignedBox2d bounds = slice_bounds(map, slice);
  return {PoseSlice(*map.manipulator(), slice), bounds, axes_of(slice, bounds), slice.free_positions() == 2};
}

}  // namespace

PlotPlane plane_of(const AspectMap& map, const std::optional<PlotSection>& section) {
  if (section && section->slice) return plane_of(map, *section->slice);
  if (map.slice() && !section) return plane_of(map, *map.slice());
  const TaskSpace space = map.manipulator()->task_space();
  const Eigen::AlignedBox2d bounds = slice_bounds(map);
  if (section)
    return {PoseSlice(space, section->torsion),
            bounds,
            {PanelAxis{"tilt cos(azimuth) [rad]", -pi, pi, true},
             PanelAxis{"tilt sin(azimuth) [rad]", -pi, pi, true}},
            true};
  return {PoseSlice(space, 0.0),
          bounds,
          {PanelAxis{"x [m]", bounds.min().x(), bounds.max().x(), false},
           PanelAxis{"y [m]", bounds.min().y(), bounds.max().y(), false}},
          true};
}

std::size_t dimension_of(const AspectMap& map) {
  return map.slice() ? map.slice()->dimension() : degrees_of_freedom(map.manipulator()->task_space());
}

}  // namespace parallel_aspects::tools
