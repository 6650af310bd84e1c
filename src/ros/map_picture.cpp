// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ros/map_picture.h"

#include "parallel_aspects/ros/palette.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;
using Place = std::function<Vector2d(const Vector2d&)>;
using Points = MarkerBatch::Points;

// Heights above the plane of a drawing, in text heights, so that one thing hides another in this order.
enum Layer { fill_layer, frame_layer, outline_layer, boundary_layer, dot_layer, dot_core_layer, text_layer };
double height_of(Layer layer, double text_height) { return 0.02 * text_height * static_cast<double>(layer); }

std_msgs::ColorRGBA ink() { return color(0x202020); }
std_msgs::ColorRGBA color_of(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::parallel:
      return color(0xB00020);
    case BoundaryKind::serial:
      return color(0x00305A);
    case BoundaryKind::limit:
      break;
  }
  return color(0x707070);
}

Points placed(const Points& points, const Place& place) {
  Points result;
  result.reserve(points.size());
  for (const Vector2d& point : points) result.push_back(place(point));
  return result;
}

Points ends_of(const std::vector<BoundarySegment>& segments, const Place& place,
               const std::function<bool(const BoundarySegment&)>& wanted) {
  Points ends;
  for (const BoundarySegment& segment : segments)
    if (wanted(segment)) ends.insert(ends.end(), {place(segment.from), place(segment.to)});
  return ends;
}

Points workspace_triangles(const AspectMap& map, int aspect, const std::vector<BoundarySliver>& slivers) {
  Points corners;
  map.visit_inside_leaves(aspect, [&](const Box& box) {
    const Vector2d a(box.lower[0], box.lower[1]), b(box.upper[0], box.lower[1]);
    const Vector2d c(box.upper[0], box.upper[1]), d(box.lower[0], box.upper[1]);
    corners.insert(corners.end(), {a, b, c, a, c, d});
  });
  for (const BoundarySliver& sliver : slivers)
    for (std::size_t i = 2; sliver.aspect == aspect && i < sliver.corners.size(); ++i)
      corners.insert(corners.end(), {sliver.corners[0], sliver.corners[i - 1], sliver.corners[i]});
  return corners;
}

Points rectangle(const Vector2d& center, const Vector2d& size) {
  const Vector2d half = 0.5 * size, across(half.x(), -half.y());
  const Vector2d a = center - half, b = center + across, c = center + half, d = center - across;
  return {a, b, b, c, c, d, d, a};
}

// Where a label of an aspect has most room.
Vector2d label_point(const Aspect& aspect) { return aspect.deepest.position.head<2>(); }

std::string legend_text(const Aspect& aspect, TaskSpace space) {
  char text[64];
  std::snprintf(text, sizeof text, "%d:  det A %s 0,  %.4g %s", aspect.id,
                aspect.determinant_sign > 0 ? ">" : "<", aspect.measure,
                std::string(measure_unit(space)).c_str());
  return text;
}

std::string range_text(const JointWindow& window, const Manipulator& manipulator, std::size_t leg) {
  const auto axis = static_cast<Eigen::Index>(leg);
  const std::string joint = (leg == 0 ? "across " : "up ") + manipulator.leg(leg).driven_joint;
  if (window.turns[leg]) return joint + ": -pi to pi";
  char range[48];
  std::snprintf(range, sizeof range, ": %.3g to %.3g", window.lower[axis], window.upper[axis]);
  return joint + range;
}

// One drawing of boundary curves: where, how wide, and which aspect is outlined.
struct CurveStyle {
  double text_height, width;
  int outlined;
};

void draw_curves(const std::vector<BoundarySegment>& segments, const Place& place, const CurveStyle& style,
                 const MarkerBatch::Plane& plane, const std::string& group, MarkerBatch& batch) {
  const auto borders_outlined = [&](const BoundarySegment& segment) {
    return style.outlined != 0 &&
           std::count(segment.aspects.begin(), segment.aspects.end(), style.outlined) > 0;
  };
  batch.lines(plane, group + "/outline", ends_of(segments, place, borders_outlined),
              height_of(outline_layer, style.text_height), 2.2 * style.width, ink());
  for (const BoundaryKind kind : {BoundaryKind::limit, BoundaryKind::serial, BoundaryKind::parallel})
    batch.lines(plane, group + "/boundary",
                ends_of(segments, place, [&](const auto& s) { return s.kind == kind; }),
                height_of(boundary_layer, style.text_height), style.width, color_of(kind));
}

void draw_dot(const MarkerBatch::Plane& plane, const std::string& group, const Vector2d& at,
              double text_height, MarkerBatch& batch) {
  batch.dots(plane, group, {at}, height_of(dot_layer, text_height), 0.55 * text_height, color(0x000000));
  batch.dots(plane, group, {at}, 0.3 * text_height, 0.35 * text_height, color(0xFFFFFF));
}

}  // namespace

MapPicture::MapPicture(std::shared_ptr<const AspectMap> map, MarkerFrames frames,
                       const DisplayOptions& options)
    : map_(std::move(map)),
      frames_(std::move(frames)),
      options_(options),
      projection_(map_),
      layout_(*map_, projection_.window(), options.gallery_scale) {
  // A little behind the robot, so that the picture never hides it.
  const Eigen::Translation3d behind(0.0, 0.0, -0.05 * map_->manipulator()->size());
  at_robot_ = {frames_.base, map_->manipulator()->task_frame() * behind};
  workspaces_ = {frames_.aspects, Eigen::Isometry3d::Identity()};
  joint_spaces_ = {frames_.joint_space, Eigen::Isometry3d::Identity()};
  workspace_triangles_.resize(map_->aspects().size());
  joint_triangles_.resize(map_->aspects().size());
  for (const WorkingMode& mode : map_->working_modes()) add_mode(mode);
}

void MapPicture::add_mode(const WorkingMode& mode) {
  const BoundaryPicture boundary = trace_boundary(*map_, mode);
  modes_.push_back({mode, boundary.segments, projection_.images(boundary.segments, mode)});
  for (const Aspect& aspect : map_->aspects()) {
    if (aspect.mode != mode) continue;
    const auto index = static_cast<std::size_t>(aspect.id - 1);
    workspace_triangles_[index] = workspace_triangles(*map_, aspect.id, boundary.slivers);
    joint_triangles_[index] = projection_.triangles(aspect.id, boundary.slivers);
  }
}

bool MapPicture::can_draw(const AspectMap& map) {
  return map.manipulator()->task_space() == TaskSpace::T2 && !map.aspects().empty();
}

visualization_msgs::MarkerArray MapPicture::aspects(const std::optional<DrawnConfiguration>& now) const {
  MarkerBatch batch;
  if (now) draw_at_robot(*now, batch);
  if (!options_.gallery) return batch.take();
  for (std::size_t column = 0; column < modes_.size(); ++column) {
    const int highlighted = now && now->mode == modes_[column].mode ? now->aspect : 0;
    draw_workspace_tile(column, highlighted, batch);
    draw_joint_tile(column, highlighted, batch);
    draw_titles(column, batch);
  }
  draw_legend(batch);
  return batch.take();
}

visualization_msgs::MarkerArray MapPicture::position(const std::optional<DrawnConfiguration>& now) const {
  MarkerBatch batch;
  const auto column = now ? column_of(now->mode) : std::nullopt;
  if (!column || !options_.gallery) return batch.take();
  const Vector2d pose = now->solved.pose.position.head<2>();
  const Vector2d q = projection_.window().wrapped(now->solved.q.head<2>());
  draw_dot(workspaces_, "position/workspace", layout_.in_workspace_tile(pose, *column), layout_.text_height(),
           batch);
  draw_dot(joint_spaces_, "position/joint_space", layout_.in_joint_tile(q, *column), layout_.text_height(),
           batch);
  return batch.take();
}

std::vector<geometry_msgs::TransformStamped> MapPicture::frames() const {
  const auto frame = [this](const std::string& name, const Vector2d& origin) {
    geometry_msgs::TransformStamped message;
    message.header.frame_id = frames_.base;
    message.child_frame_id = name;
    message.transform = transform_message(at_robot_.pose * Eigen::Translation3d(origin.x(), origin.y(), 0.0));
    return message;
  };
  return {frame(frames_.aspects, layout_.aspects_origin()),
          frame(frames_.joint_space, layout_.joint_space_origin())};
}

std::optional<std::size_t> MapPicture::column_of(const WorkingMode& mode) const {
  const auto found = std::find_if(modes_.begin(), modes_.end(),
                                  [&](const ModePicture& picture) { return picture.mode == mode; });
  if (found == modes_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - modes_.begin());
}

void MapPicture::draw_at_robot(const DrawnConfiguration& now, MarkerBatch& batch) const {
  const auto column = column_of(now.mode);
  if (!column) return;
  const Place place = [](const Vector2d& point) { return point; };
  const double text = layout_.text_height();
  for (const Aspect& aspect : map_->aspects()) {
    if (aspect.mode != now.mode) continue;
    const auto full = aspect_color(aspect.id);
    const auto shade = aspect.id == now.aspect ? full : lightened(full, 0.65);
    batch.triangles(at_robot_, "robot/aspects", workspace_triangles_[static_cast<std::size_t>(aspect.id - 1)],
                    height_of(fill_layer, text), shade);
    batch.text(at_robot_, "robot/labels", label_point(aspect), height_of(text_layer, text), text,
               std::to_string(aspect.id), readable_on(shade));
  }
  draw_curves(modes_[*column].boundary, place, {text, 0.1 * text, now.aspect}, at_robot_, "robot", batch);
}

void MapPicture::draw_workspace_tile(std::size_t column, int highlighted, MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const Place place = [&](const Vector2d& point) { return layout_.in_workspace_tile(point, column); };
  for (const Aspect& aspect : map_->aspects()) {
    if (aspect.mode != modes_[column].mode) continue;
    const auto fill = aspect_color(aspect.id);
    batch.triangles(workspaces_, "workspace/aspects",
                    placed(workspace_triangles_[static_cast<std::size_t>(aspect.id - 1)], place),
                    height_of(fill_layer, text), fill);
    batch.text(workspaces_, "workspace/labels", place(label_point(aspect)), height_of(text_layer, text),
               0.8 * text, std::to_string(aspect.id), readable_on(fill));
  }
  draw_curves(modes_[column].boundary, place, {text, 0.06 * text, highlighted}, workspaces_, "workspace",
              batch);
}

void MapPicture::draw_joint_tile(std::size_t column, int highlighted, MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const Place place = [&](const Vector2d& q) { return layout_.in_joint_tile(q, column); };
  double height = height_of(fill_layer, text);
  for (const Aspect& aspect : map_->aspects()) {
    if (aspect.mode != modes_[column].mode) continue;
    batch.triangles(joint_spaces_, "joint_space/aspects",
                    placed(joint_triangles_[static_cast<std::size_t>(aspect.id - 1)], place), height,
                    aspect_color(aspect.id));
    height += 0.001 * text;  // projections overlap where there are several assembly modes
  }
  draw_curves(modes_[column].joint_boundary, place, {text, 0.06 * text, highlighted}, joint_spaces_,
              "joint_space", batch);
  batch.lines(joint_spaces_, "joint_space/window",
              rectangle(layout_.joint_tile_center(column), layout_.joint_tile_size()),
              height_of(frame_layer, text), 0.04 * text, color(0x808080));
}

void MapPicture::draw_titles(std::size_t column, MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const double layer = height_of(text_layer, text);
  const Vector2d up = Vector2d::UnitY();
  const Vector2d top =
      layout_.workspace_tile_center(column) + (0.5 * layout_.workspace_tile_size().y() + text) * up;
  batch.text(workspaces_, "workspace/titles", top, layer, text,
             "working mode " + to_string(modes_[column].mode), ink());

  const TaskSpace space = map_->manipulator()->task_space();
  Vector2d line =
      layout_.workspace_tile_center(column) - (0.5 * layout_.workspace_tile_size().y() + 0.9 * text) * up;
  for (const Aspect& aspect : map_->aspects()) {
    if (aspect.mode != modes_[column].mode) continue;
    batch.text(workspaces_, "workspace/sizes", line, layer, 0.8 * text, legend_text(aspect, space), ink());
    line -= 0.95 * text * up;
  }
  Vector2d below =
      layout_.joint_tile_center(column) - (0.5 * layout_.joint_tile_size().y() + 0.7 * text) * up;
  for (std::size_t leg = 0; leg < 2; ++leg) {
    batch.text(joint_spaces_, "joint_space/axes", below, layer, 0.75 * text,
               range_text(projection_.window(), *map_->manipulator(), leg), ink());
    below -= 0.95 * text * up;
  }
}

void MapPicture::draw_legend(MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const Vector2d below(0.0, -0.5 * layout_.joint_tile_size().y() - 3.2 * text);
  const Vector2d step = layout_.joint_tile_center(1) - layout_.joint_tile_center(0);
  const std::pair<BoundaryKind, const char*> entries[] = {
      {BoundaryKind::serial, "serial singularity, Bjj = 0"},
      {BoundaryKind::parallel, "parallel singularity, det A = 0"},
      {BoundaryKind::limit, "joint limit"}};
  Vector2d at = below;
  for (const auto& [kind, words] : entries) {
    const auto has_kind = [kind = kind](const ModePicture& mode) {
      return std::any_of(mode.boundary.begin(), mode.boundary.end(),
                         [kind](const BoundarySegment& segment) { return segment.kind == kind; });
    };
    if (std::none_of(modes_.begin(), modes_.end(), has_kind)) continue;
    batch.text(joint_spaces_, "joint_space/legend", at, height_of(text_layer, text), 0.8 * text, words,
               color_of(kind));
    at += 1.5 * step;
  }
}

}  // namespace parallel_aspects
