// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SCENE_MAP_SCENE_H
#define PARALLEL_ASPECTS_DRAW_SCENE_MAP_SCENE_H

#include "draw/scene/plane_scene.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A line in the workspace of one aspect, as the outline of a shape.
struct AspectOutline {
  int aspect = 0;                     ///< id
  std::vector<Eigen::Vector2d> line;  ///< in the plane that is drawn [m or rad]
};

/// What is drawn of a map.
struct SceneOptions {
  std::vector<WorkingMode> modes;  ///< empty for all
  std::optional<PoseSection> section;
  IndexLevels levels;
  bool each_aspect = false;  ///< a figure for each aspect, not for each working mode
  std::vector<AspectOutline> outlines;
  bool leaves = false;  ///< the boxes of the map, with those that are undecided, in place of areas
  int cells = 180;      ///< of the grid that areas are traced on, along an edge
};

/// One working mode, or one aspect.
struct MapFigure {
  std::string title;
  std::set<int> aspects;            ///< ids of those that are drawn
  std::vector<LegendEntry> legend;  ///< of these
  std::vector<PlaneScene>
      planes;  ///< of poses, then of joint space for each sign of det A, where it is a plane
};

/// A map as it is drawn in planes.
struct MapScene {
  std::vector<std::string> notes;  ///< where it is cut, and what is proved in it
  std::vector<MapFigure> figures;
  std::vector<LegendEntry> legend;
};

/// The workspace and, where it is a plane, the joint space of each working mode, or of each aspect. The map
/// has two coordinates, or a section leaves two of three. `checkpoint` is called now and then; it may throw.
MapScene map_scene(
    const std::shared_ptr<const AspectMap>& map, const SceneOptions& options,
    const std::function<void()>& checkpoint = [] {});

/// How many coordinates the boxes of a map have, or its orientations.
std::size_t dimension_of(const AspectMap& map);

/// Why aspects are not drawn, and which: the first of them, and how many more there are.
std::string missing_aspects(const std::vector<int>& ids, const std::string& why);

/// What the colours of these aspects mean.
std::vector<LegendEntry> aspect_legend(const AspectMap& map, const std::set<int>& ids);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SCENE_MAP_SCENE_H
