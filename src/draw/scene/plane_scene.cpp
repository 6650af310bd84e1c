// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/plane_scene.h"

#include "model/angles.h"
#include "model/message_text.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

std::array<PlaneAxis, 2> axes_of(const MapSlice& slice, const Eigen::AlignedBox2d& bounds) {
  const std::vector<std::string> names = coordinate_names(slice);
  std::array<PlaneAxis, 2> axes;
  for (std::size_t i = 0; i < 2; ++i) {
    const bool turns = slice.joint.has_value() || i >= slice.free_positions();
    const auto k = static_cast<Eigen::Index>(i);
    axes[i] = {names[i] + (turns ? " [rad]" : " [m]"), bounds.min()[k], bounds.max()[k], turns};
  }
  return axes;
}

PosePlane plane_of_slice(const AspectMap& map, const MapSlice& slice) {
  const Eigen::AlignedBox2d bounds = slice_bounds(map, slice);
  return {PoseSlice(*map.manipulator(), slice), bounds, axes_of(slice, bounds), slice.free_positions() == 2};
}

bool bounds_any(const BoundarySegment& segment, const std::set<int>& ids) {
  return std::any_of(segment.aspects.begin(), segment.aspects.end(),
                     [&ids](int id) { return ids.count(id) > 0; });
}

PlaneArea area_of(const AspectMap& map, int id, Rgb color, const std::vector<BoundarySliver>& slivers) {
  const Aspect& aspect = map.aspects()[static_cast<std::size_t>(id - 1)];
  PlaneArea area{{}, color, std::to_string(id), aspect_words(map, aspect), id};
  for (const BoundarySliver& sliver : slivers)
    if (sliver.aspect == id) area.polygons.push_back(sliver.corners);
  return area;
}

std::vector<LevelSegment> levels_in(const std::vector<LevelSegment>& levels, const std::set<int>& ids) {
  std::vector<LevelSegment> kept;
  for (const LevelSegment& level : levels)
    if (ids.count(level.aspect) > 0) kept.push_back(level);
  return kept;
}

}  // namespace

std::vector<BoundarySegment> boundaries_of(const std::vector<BoundarySegment>& boundaries,
                                           const std::set<int>& ids) {
  std::vector<BoundarySegment> kept;
  for (const BoundarySegment& segment : boundaries)
    if (bounds_any(segment, ids)) kept.push_back(segment);
  return kept;
}

std::vector<BoundaryCurves> curves_of(const std::vector<BoundarySegment>& boundaries) {
  std::vector<BoundaryCurves> curves;
  for (const BoundaryStyle& style : boundary_styles()) {
    BoundaryCurves found{&style, {}};
    for (const BoundarySegment& segment : boundaries)
      if (segment.kind == style.kind) found.ends.insert(found.ends.end(), {segment.from, segment.to});
    if (!found.ends.empty()) curves.push_back(std::move(found));
  }
  return curves;
}

std::vector<Eigen::Vector2d> outline_of(const std::vector<BoundarySegment>& boundaries, int aspect) {
  std::vector<Eigen::Vector2d> ends;
  if (aspect == 0) return ends;
  for (const BoundarySegment& segment : boundaries_of(boundaries, {aspect}))
    ends.insert(ends.end(), {segment.from, segment.to});
  return ends;
}

std::vector<LegendEntry> sign_legend() {
  return {{aspect_color(1, 0), false, "light: det A > 0"}, {aspect_color(-1, 0), false, "dark: det A < 0"}};
}

std::vector<LegendEntry> boundary_legend(const std::set<BoundaryKind>& kinds) {
  std::vector<LegendEntry> entries;
  for (const BoundaryStyle& style : boundary_styles())
    if (kinds.count(style.kind) > 0) entries.push_back({style.color, true, style.words});
  return entries;
}

std::set<BoundaryKind> kinds_of(const std::vector<BoundarySegment>& boundaries) {
  std::set<BoundaryKind> kinds;
  for (const BoundarySegment& segment : boundaries) kinds.insert(segment.kind);
  return kinds;
}

std::string aspect_words(const AspectMap& map, const Aspect& aspect) {
  return "aspect " + std::to_string(aspect.id) + ": det A " + (aspect.determinant_sign > 0 ? "> 0" : "< 0") +
         ", " + number_text(aspect.measure, 4) + " " + map.unit();
}

PosePlane plane_of(const AspectMap& map, const std::optional<PoseSection>& section) {
  if (section && section->slice) return plane_of_slice(map, *section->slice);
  if (map.slice() && !section) return plane_of_slice(map, *map.slice());
  return plane_of(map, PoseSlice(map.manipulator()->motions(), section ? section->torsion : 0.0));
}

PosePlane plane_of(const AspectMap& map, const PoseSlice& slice) {
  if (map.slice()) return plane_of_slice(map, *map.slice());
  const Eigen::AlignedBox2d bounds = slice_bounds(map);
  if (map.manipulator()->task_space() == TaskSpace::SO3)
    return {slice,
            bounds,
            {PlaneAxis{"tilt cos(azimuth) [rad]", -pi, pi, true},
             PlaneAxis{"tilt sin(azimuth) [rad]", -pi, pi, true}},
            true};
  if (map.manipulator()->task_space() == TaskSpace::R2)
    return {slice,
            bounds,
            {PlaneAxis{"theta1 [rad]", bounds.min().x(), bounds.max().x(), true},
             PlaneAxis{"theta2 [rad]", bounds.min().y(), bounds.max().y(), true}},
            true};
  return {slice,
          bounds,
          {PlaneAxis{"x [m]", bounds.min().x(), bounds.max().x(), false},
           PlaneAxis{"y [m]", bounds.min().y(), bounds.max().y(), false}},
          true};
}

std::array<PlaneAxis, 2> joint_axes(const Manipulator& robot, const JointProjection& projection, double rim) {
  const JointWindow& window = projection.window();
  std::array<PlaneAxis, 2> axes;
  for (std::size_t i = 0; i < 2; ++i) {
    const Leg& leg = robot.leg(projection.legs()[i]);
    const auto k = static_cast<Eigen::Index>(i);
    const double more = window.turns[i] ? 0.0 : rim * (window.upper[k] - window.lower[k]);
    axes[i] = {leg.actuated_joint + (leg.actuated_by_angle() ? " [rad]" : " [m]"), window.lower[k] - more,
               window.upper[k] + more, window.turns[i]};
  }
  return axes;
}

std::set<int> aspects_in(const BoundaryPicture& traced) {
  std::set<int> ids;
  for (const BoundarySliver& sliver : traced.slivers) ids.insert(sliver.aspect);
  return ids;
}

PlaneScene pose_scene(const AspectMap& map, const PosePlane& plane, const BoundaryPicture& traced,
                      const std::set<int>& ids) {
  PlaneScene scene;
  scene.axes = plane.axes;
  scene.keeps_proportion = plane.keeps_proportion;
  const std::vector<Rgb> colors = aspect_colors(map.aspects());
  for (const int id : ids)
    scene.areas.push_back(area_of(map, id, colors[static_cast<std::size_t>(id - 1)], traced.slivers));
  scene.levels = levels_in(traced.levels, ids);
  scene.boundaries = traced.segments;
  return scene;
}

PlaneScene pose_scene(const AspectMap& map, const PosePlane& plane, const WorkingMode& mode, int cells) {
  const BoundaryPicture traced = trace_slice(map, mode, plane.slice, plane.bounds, cells);
  return pose_scene(map, plane, traced, aspects_in(traced));
}

PlaneScene joint_scene(const AspectMap& map, const JointProjection& projection, const BoundaryPicture& traced,
                       const std::set<int>& ids, const WorkingMode& mode, Pieces pieces) {
  constexpr double rim = 0.04;
  PlaneScene scene;
  scene.axes = joint_axes(*map.manipulator(), projection, rim);
  const std::vector<Rgb> colors = aspect_colors(map.aspects());
  for (const int id : ids) {
    const bool is_exact = pieces == Pieces::exact;
    scene.areas.push_back(
        area_of(map, id, colors[static_cast<std::size_t>(id - 1)],
                is_exact ? projection.images(id, traced.slivers) : std::vector<BoundarySliver>()));
    if (is_exact) continue;
    const TriangleCorners corners = projection.triangles(id, traced.slivers);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      scene.areas.back().polygons.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  scene.levels = projection.images(levels_in(traced.levels, ids), mode);
  scene.boundaries = projection.images(boundaries_of(traced.segments, ids), mode);
  return scene;
}

std::vector<Eigen::Vector2d> triangles_of(const PlaneArea& area) {
  std::vector<Eigen::Vector2d> corners;
  for (const auto& polygon : area.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      corners.insert(corners.end(), {polygon[0], polygon[i - 1], polygon[i]});
  return corners;
}

}  // namespace parallel_aspects
