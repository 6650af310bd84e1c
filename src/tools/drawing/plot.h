// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H

#include "draw/page/page_elements.h"
#include "draw/scene/map_scene.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <functional>
#include <memory>

namespace parallel_aspects::tools {

using PlotOptions = SceneOptions;
using PlotSection = PoseSection;

/// The figures of the paper: the workspace and, where it is a plane, the joint space of each working mode, or
/// of each aspect. Maps with three coordinates without a section are seen as bodies. `checkpoint` is called
/// now and then; it may throw.
PagePicture draw_plot(
    const std::shared_ptr<const AspectMap>& map, const PlotOptions& options,
    const std::function<void()>& checkpoint = [] {});

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_PLOT_H
