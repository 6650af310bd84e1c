// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/map_scene.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_missing = 12;

std::vector<Eigen::Vector2d> corners_of(const Box& box) {
  return {{box.lower[0], box.lower[1]},
          {box.upper[0], box.lower[1]},
          {box.upper[0], box.upper[1]},
          {box.lower[0], box.upper[1]}};
}

class SceneMaker {
 public:
  SceneMaker(const std::shared_ptr<const AspectMap>& map, const SceneOptions& options)
      : map_(map), options_(options), plane_(plane_of(*map, options.section)) {
    if (!options.section && JointProjection::is_possible(*map)) projection_.emplace(map);
  }

  void add_mode(const WorkingMode& mode) {
    traced_ =
        trace_slice(*map_, mode, plane_.slice, plane_.bounds, options_.cells, Cells::single, options_.levels);
    for (const BoundaryKind kind : kinds_of(traced_.segments)) kinds_.insert(kind);
    undecided_.clear();
    if (options_.leaves) take_leaves(mode);
    const std::set<int> ids = aspects_in(traced_);
    for (const Aspect& each : map_->aspects())
      if (each.mode == mode && ids.count(each.id) == 0) missing_.push_back(each.id);
    if (!options_.each_aspect) return add_figure("working mode " + to_string(mode), mode, ids);
    for (const int id : ids)
      add_figure("aspect " + std::to_string(id) + ", working mode " + to_string(mode), mode, {id});
  }

  MapScene take() {
    scene_.notes = {where(), what_is_proved()};
    if (!missing_.empty()) scene_.notes.push_back(missing_aspects(missing_, why_missing()));
    scene_.legend = sign_legend();
    if (options_.leaves) scene_.legend.push_back({undecided_color, false, "undecided"});
    for (LegendEntry& entry : boundary_legend(kinds_)) scene_.legend.push_back(std::move(entry));
    if (!options_.levels.levels.empty())
      scene_.legend.push_back({ink_color, true,
                               options_.levels.index == DrawnIndex::parallel
                                   ? "lines of equal parallel index"
                                   : "isoconditioning lines: equal inverse condition number"});
    return std::move(scene_);
  }

 private:
  // The boxes of the map in place of the pieces that were traced.
  void take_leaves(const WorkingMode& mode) {
    traced_.slivers.clear();
    for (const Aspect& each : map_->aspects())
      if (each.mode == mode)
        map_->visit_inside_leaves(each.id, [&](const Box& box) {
          traced_.slivers.push_back({each.id, corners_of(box)});
        });
    map_->visit_undecided_leaves(mode, [this](const Box& box) { undecided_.push_back(corners_of(box)); });
  }

  void add_figure(const std::string& title, const WorkingMode& mode, const std::set<int>& ids) {
    MapFigure figure{title, ids, aspect_legend(*map_, ids), {workspace(ids)}};
    for (const int sign : {1, -1}) {
      std::set<int> of_sign;
      for (const int id : ids)
        if (map_->aspects()[static_cast<std::size_t>(id - 1)].determinant_sign == sign) of_sign.insert(id);
      if (!projection_ || of_sign.empty()) continue;
      figure.planes.push_back(joint_scene(*map_, *projection_, traced_, of_sign, mode));
      figure.planes.back().caption = std::string("joint space, det A ") + (sign > 0 ? "> 0" : "< 0");
    }
    scene_.figures.push_back(std::move(figure));
  }

  PlaneScene workspace(const std::set<int>& ids) const {
    PlaneScene scene = pose_scene(*map_, plane_, traced_, ids);
    scene.caption = "workspace";
    if (options_.each_aspect)
      scene.boundaries = boundaries_of(scene.boundaries, ids);
    else if (!undecided_.empty())
      scene.areas.insert(scene.areas.begin(), {undecided_, undecided_color, "", "undecided"});
    for (const AspectOutline& outline : options_.outlines)
      if (ids.count(outline.aspect) > 0) scene.lines.push_back({outline.line, ink_color, "largest shape"});
    return scene;
  }

  std::string where() const {
    std::string text =
        map_->slice() ? "Map of the slice " + to_string(*map_->slice()) + "." : "Map of all poses.";
    if (options_.section) text += " Section " + plane_.slice.text() + "; measures are of the whole aspects.";
    return text;
  }

  std::string what_is_proved() const {
    const std::string cells = std::to_string(options_.cells);
    std::string text =
        options_.leaves
            ? "Coloured boxes are proved to lie in their aspects, grey ones are undecided."
            : "Each piece of an area holds a pose that is proved to lie in that aspect; edges are "
              "drawn for the eye, on a grid of " +
                  cells + " x " + cells + ".";
    text += " Curves are drawn for the eye.";
    if (projection_)
      text +=
          " The joint space shows the same pieces, carried there by the inverse kinematics of the working "
          "mode.";
    return text;
  }

  std::string why_missing() const {
    if (options_.leaves) return "Without a box that is proved to lie in them, and not drawn";
    return options_.section ? "Not met by the section, or in less than a cell of that grid, and not drawn"
                            : "Smaller than a cell of that grid, and not drawn";
  }

  std::shared_ptr<const AspectMap> map_;
  const SceneOptions& options_;
  PosePlane plane_;
  std::optional<JointProjection> projection_;
  BoundaryPicture traced_;
  std::vector<std::vector<Eigen::Vector2d>> undecided_;
  std::set<BoundaryKind> kinds_;
  std::vector<int> missing_;  // aspects of these modes without a piece
  MapScene scene_;
};

}  // namespace

MapScene map_scene(const std::shared_ptr<const AspectMap>& map, const SceneOptions& options,
                   const std::function<void()>& checkpoint) {
  SceneMaker maker(map, options);
  for (const WorkingMode& mode : options.modes.empty() ? map->working_modes() : options.modes) {
    checkpoint();
    maker.add_mode(mode);
  }
  return maker.take();
}

std::size_t dimension_of(const AspectMap& map) {
  return map.slice() ? map.slice()->dimension() : degrees_of_freedom(map.manipulator()->task_space());
}

std::string missing_aspects(const std::vector<int>& ids, const std::string& why) {
  std::string text = why + (ids.size() == 1 ? ": aspect " : ": aspects ");
  for (std::size_t i = 0; i < std::min(ids.size(), most_missing); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(ids[i]);
  if (ids.size() > most_missing) text += " and " + std::to_string(ids.size() - most_missing) + " more";
  return text + ".";
}

std::vector<LegendEntry> aspect_legend(const AspectMap& map, const std::set<int>& ids) {
  const std::vector<Rgb> colors = aspect_colors(map.aspects());
  std::vector<LegendEntry> entries;
  for (const int id : ids) {
    const auto index = static_cast<std::size_t>(id - 1);
    entries.push_back({colors[index], false, aspect_words(map, map.aspects()[index])});
  }
  return entries;
}

}  // namespace parallel_aspects
