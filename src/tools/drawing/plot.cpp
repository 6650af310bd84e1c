// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/plot.h"

#include "model/angles.h"
#include "tools/report/reports.h"

#include "draw/page/page.h"
#include "draw/page/solid_view.h"
#include "draw/plane/map_pictures.h"
#include <algorithm>
#include <set>
#include <string>
#include <utility>

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

namespace {

constexpr int grid_cells = 180;

std::vector<Eigen::Vector2d> corners_of(const Box& box) {
  return {{box.lower[0], box.lower[1]},
          {box.upper[0], box.lower[1]},
          {box.upper[0], box.upper[1]},
          {box.lower[0], box.upper[1]}};
}

bool bounds_aspect(const BoundarySegment& segment, const std::set<int>& ids) {
  return std::any_of(segment.aspects.begin(), segment.aspects.end(),
                     [&ids](int id) { return ids.count(id) > 0; });
}

class PlanePlot {
 public:
  PlanePlot(const std::shared_ptr<const AspectMap>& map, const PlotOptions& options, Page& page)
      : map_(map),
        options_(options),
        plane_(plane_of(*map, options.section)),
        page_(page),
        colors_(aspect_colors(map->aspects())) {
    if (!options.section && JointProjection::is_possible(*map)) projection_.emplace(map);
    page_.side = options.each_aspect && projection_ ? 205.0 : 260.0;
  }

  void add_mode(const WorkingMode& mode) {
    traced_ =
        trace_slice(*map_, mode, plane_.slice, plane_.bounds, grid_cells, Cells::single, options_.levels);
    for (const BoundarySegment& segment : traced_.segments) kinds_.insert(segment.kind);
    undecided_.clear();
    if (options_.leaves) take_leaves(mode);
    std::set<int> ids;
    for (const BoundarySliver& sliver : traced_.slivers) ids.insert(sliver.aspect);
    for (const Aspect& each : map_->aspects())
      if (each.mode == mode && ids.count(each.id) == 0) missing_.push_back(each.id);
    if (options_.each_aspect)
      for (const int id : ids)
        add_figure("aspect " + std::to_string(id) + ", working mode " + to_string(mode), mode, {id});
    else
      add_figure("working mode " + to_string(mode), mode, ids);
  }

  const std::set<BoundaryKind>& kinds() const { return kinds_; }
  const std::vector<int>& missing() const { return missing_; }
  bool has_joint_space() const { return projection_.has_value(); }

 private:
  const Aspect& aspect(int id) const { return map_->aspects()[static_cast<std::size_t>(id - 1)]; }

  // The boxes of the map in place of the pieces that were traced.
  void take_leaves(const WorkingMode& mode) {
    std::vector<BoundarySliver> leaves;
    for (const Aspect& each : map_->aspects())
      if (each.mode == mode)
        map_->visit_inside_leaves(each.id, [&](const Box& box) {
          leaves.push_back({each.id, corners_of(box)});
        });
    traced_.slivers = std::move(leaves);
    map_->visit_undecided_leaves(mode, [this](const Box& box) { undecided_.push_back(corners_of(box)); });
  }

  void add_figure(const std::string& title, const WorkingMode& mode, const std::set<int>& ids) {
    PageFigure figure{title, aspect_entries(*map_, colors_, ids), {workspace(ids)}};
    if (projection_)
      for (const int sign : {1, -1}) {
        std::set<int> of_sign;
        for (const int id : ids)
          if (aspect(id).determinant_sign == sign) of_sign.insert(id);
        if (!of_sign.empty()) figure.panels.push_back(joint_space(mode, sign, of_sign));
      }
    page_.figures.push_back(std::move(figure));
  }

  Rgb color(int id) const { return colors_[static_cast<std::size_t>(id - 1)]; }

  PanelContents workspace(const std::set<int>& ids) const {
    PanelContents contents{"workspace", plane_.axes, plane_.keeps_proportion, {}, {}, {}, {}, {}, {}};
    if (!undecided_.empty() && !options_.each_aspect)
      contents.shapes.push_back({undecided_, undecided_color, "", "undecided"});
    for (const int id : ids) contents.shapes.push_back(shape(id, traced_.slivers));
    for (const BoundarySegment& segment : traced_.segments)
      if (!options_.each_aspect || bounds_aspect(segment, ids)) contents.segments.push_back(segment);
    for (const LevelSegment& level : traced_.levels)
      if (ids.count(level.aspect) > 0) contents.levels.push_back(level);
    for (const PlotOutline& outline : options_.outlines)
      if (ids.count(outline.aspect) > 0) contents.outlines.push_back(outline.line);
    return contents;
  }

  PanelShape shape(int id, const std::vector<BoundarySliver>& slivers) const {
    PanelShape result{{}, color(id), std::to_string(id), aspect_words(*map_, aspect(id))};
    for (const BoundarySliver& sliver : slivers)
      if (sliver.aspect == id) result.polygons.push_back(sliver.corners);
    return result;
  }

  PanelContents joint_space(const WorkingMode& mode, int sign, const std::set<int>& ids) const {
    const JointWindow& window = projection_->window();
    PanelContents contents{
        std::string("joint space, det A ") + (sign > 0 ? "> 0" : "< 0"), {}, false, {}, {}, {}, {}, {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
      const Leg& leg = map_->manipulator()->leg(projection_->legs()[i]);
      const auto k = static_cast<Eigen::Index>(i);
      const double rim = window.turns[i] ? 0.0 : 0.04 * (window.upper[k] - window.lower[k]);
      contents.axes[i] = {leg.actuated_joint + " [" + joint_unit(leg) + "]", window.lower[k] - rim,
                          window.upper[k] + rim, window.turns[i]};
    }
    for (const int id : ids) contents.shapes.push_back(shape(id, projection_->images(id, traced_.slivers)));
    std::vector<BoundarySegment> segments;
    for (const BoundarySegment& segment : traced_.segments)
      if (bounds_aspect(segment, ids)) segments.push_back(segment);
    contents.segments = projection_->images(segments, mode);
    std::vector<LevelSegment> levels;
    for (const LevelSegment& level : traced_.levels)
      if (ids.count(level.aspect) > 0) levels.push_back(level);
    contents.levels = projection_->images(levels, mode);
    return contents;
  }

  std::shared_ptr<const AspectMap> map_;
  const PlotOptions& options_;
  PlotPlane plane_;
  Page& page_;
  std::vector<Rgb> colors_;
  std::optional<JointProjection> projection_;
  BoundaryPicture traced_;
  std::vector<std::vector<Eigen::Vector2d>> undecided_;
  std::set<BoundaryKind> kinds_;
  std::vector<int> missing_;  // aspects of these modes without a piece
};

std::string where(const AspectMap& map, const PlotPlane& plane, const PlotOptions& options) {
  std::string text = map.slice() ? "Map of the slice " + to_string(*map.slice()) + "." : "Map of all poses.";
  if (options.section) text += " Section " + plane.slice.text() + "; measures are of the whole aspects.";
  return text;
}

std::string what_is_proved(const PlotOptions& options, bool has_joint_space) {
  std::string text = options.leaves
                         ? "Coloured boxes are proved to lie in their aspects, grey ones are undecided."
                         : "Each piece of an area holds a pose that is proved to lie in that aspect; edges "
                           "are drawn for the eye, on a "
                           "grid of " +
                               std::to_string(grid_cells) + " x " + std::to_string(grid_cells) + ".";
  text += " Curves are drawn for the eye.";
  if (has_joint_space)
    text +=
        " The joint space shows the same pieces, carried there by the inverse kinematics of the working "
        "mode.";
  return text;
}

std::string why_missing(const PlotOptions& options) {
  if (options.leaves) return "Without a box that is proved to lie in them, and not drawn";
  return options.section ? "Not met by the section, or in less than a cell of that grid, and not drawn"
                         : "Smaller than a cell of that grid, and not drawn";
}

std::vector<LegendEntry> legend(const std::set<BoundaryKind>& kinds, const PlotOptions& options) {
  std::vector<LegendEntry> entries{{aspect_color(1, 0), false, "light: det A > 0"},
                                   {aspect_color(-1, 0), false, "dark: det A < 0"}};
  if (options.leaves) entries.push_back({undecided_color, false, "undecided"});
  for (const auto& [kind, words] : boundary_words())
    if (kinds.count(kind) > 0) entries.push_back({boundary_color(kind), true, words});
  if (!options.levels.levels.empty())
    entries.push_back({ink_color, true,
                       options.levels.index == DrawnIndex::parallel
                           ? "lines of equal parallel index"
                           : "isoconditioning lines: equal inverse condition number"});
  return entries;
}

}  // namespace

PagePicture draw_plot(const std::shared_ptr<const AspectMap>& map, const PlotOptions& options,
                      const std::function<void()>& checkpoint) {
  Page page;
  page.title = map->manipulator()->name() + ": " + aspect_count(*map);
  const std::vector<WorkingMode>& modes = options.modes.empty() ? map->working_modes() : options.modes;
  if (dimension_of(*map) == 3 && !options.section) {
    add_solids(*map, modes, checkpoint, page);
    return draw_page(page);
  }
  PlanePlot plot(map, options, page);
  page.notes = {where(*map, plane_of(*map, options.section), options),
                what_is_proved(options, plot.has_joint_space())};
  for (const WorkingMode& mode : modes) {
    checkpoint();
    plot.add_mode(mode);
  }
  if (!plot.missing().empty()) page.notes.push_back(missing_aspects(plot.missing(), why_missing(options)));
  page.legend = legend(plot.kinds(), options);
  return draw_page(page);
}

}  // namespace parallel_aspects::tools
