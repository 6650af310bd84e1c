// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/map_picture.h"

#include "ros/pictures/marker_colors.h"
#include "ros/pictures/picture_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

AlignedBox2d workspace_of(const AspectMap& map) {
  AlignedBox2d workspace;
  for (const Aspect& aspect : map.aspects()) {
    workspace.extend(Vector2d(aspect.bounds.lower[0], aspect.bounds.lower[1]));
    workspace.extend(Vector2d(aspect.bounds.upper[0], aspect.bounds.upper[1]));
  }
  if (workspace.isEmpty()) workspace.extend(Vector2d::Zero());
  return workspace;
}

// What the robot itself needs: its aspects, its base points and the circles of its cranks.
AlignedBox2d robot_extent(const AspectMap& map, AlignedBox2d extent) {
  for (const Leg& leg : map.manipulator()->legs()) {
    const double crank = leg.kind().has_crank ? (leg.proximal_point(0.0) - leg.base_point()).norm() : 0.0;
    const Vector2d reach = Vector2d::Constant(crank);
    extent.extend(leg.base_point().head<2>() + reach);
    extent.extend(leg.base_point().head<2>() - reach);
  }
  return extent;
}

}  // namespace

GalleryLayout::GalleryLayout(const AspectMap& map, const JointWindow& window, double scale)
    : scale_(scale), workspace_(workspace_of(map)), window_center_(0.5 * (window.lower + window.upper)) {
  workspace_tile_size_ = scale * workspace_.sizes();
  const double side = workspace_tile_size_.minCoeff();
  joint_tile_size_ = Vector2d(side, side);
  joint_scale_ = joint_tile_size_.cwiseQuotient((window.upper - window.lower).cwiseMax(1e-9));
  text_height_ = 0.1 * side;
  pitch_ = workspace_tile_size_.x() + 3.0 * text_height_;

  const AlignedBox2d robot = robot_extent(map, workspace_);
  const double between_rows = 4.0 * text_height_;
  const double height = workspace_tile_size_.y() + between_rows + joint_tile_size_.y();
  const double top = robot.center().y() + 0.5 * height;
  const double left = robot.max().x() + 4.0 * text_height_ + 0.5 * workspace_tile_size_.x();
  aspects_origin_ = Vector2d(left, top - 0.5 * workspace_tile_size_.y());
  joint_space_origin_ = Vector2d(left, top - height + 0.5 * joint_tile_size_.y());
}

Vector2d GalleryLayout::in_workspace_tile(const Vector2d& point, std::size_t column) const {
  return workspace_tile_center(column) + scale_ * (point - workspace_.center());
}

Vector2d GalleryLayout::in_joint_tile(const Vector2d& q, std::size_t column) const {
  return joint_tile_center(column) + joint_scale_.cwiseProduct(q - window_center_);
}

namespace {

using Eigen::Vector2d;
using Points = MarkerBatch::Points;

// Cells across the workspace, of the pictures at the robot, in a tile, and in joint space.
constexpr int robot_cells = 160, tile_cells = 72, joint_cells = 40;

// Where a label of an aspect has most room.
Vector2d label_point(const Aspect& aspect) { return aspect.deepest.position.head<2>(); }

// Heights of the fills of a tile, one over the other, as a share of that of texts: below its frame.
constexpr double stack_height = 0.01;

// Points across the window of joint values at which projections are compared, and how many they share at
// their borders at most.
constexpr int compared_points = 64, shared_at_borders = 16;

/// Whether each point of a lattice of the window is in one of the triangles.
std::vector<bool> covered(const Points& triangles, const JointWindow& window) {
  std::vector<bool> inside(compared_points * compared_points, false);
  const Vector2d step = (window.upper - window.lower) / compared_points;
  const auto cross = [](const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  const auto index = [](double at) {
    return std::clamp(static_cast<int>(std::ceil(at - 0.5)), 0, compared_points);
  };
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Vector2d &a = triangles[i], &b = triangles[i + 1], &c = triangles[i + 2];
    const Vector2d first = (a.cwiseMin(b).cwiseMin(c) - window.lower).cwiseQuotient(step),
                   last = (a.cwiseMax(b).cwiseMax(c) - window.lower).cwiseQuotient(step);
    for (int row = index(first.y()); row < index(last.y()); ++row)
      for (int column = index(first.x()); column < index(last.x()); ++column) {
        const Vector2d at = window.lower + step.cwiseProduct(Vector2d(column + 0.5, row + 0.5));
        if (cross(b - a, at - a) >= 0.0 && cross(c - b, at - b) >= 0.0 && cross(a - c, at - c) >= 0.0)
          inside[static_cast<std::size_t>(row * compared_points + column)] = true;
      }
  }
  return inside;
}

bool overlap(const std::vector<const Points*>& images, const JointWindow& window) {
  std::vector<int> counts(compared_points * compared_points, 0);
  for (const Points* image : images) {
    const std::vector<bool> inside = covered(*image, window);
    for (std::size_t i = 0; i < inside.size(); ++i) counts[i] += inside[i] ? 1 : 0;
  }
  return std::count_if(counts.begin(), counts.end(), [](int count) { return count > 1; }) > shared_at_borders;
}

std::string range_text(const JointWindow& window, const Manipulator& manipulator, std::size_t leg) {
  const auto axis = static_cast<Eigen::Index>(leg);
  const std::string joint = (leg == 0 ? "across " : "up ") + manipulator.leg(leg).actuated_joint;
  if (window.turns[leg]) return joint + ": -pi to pi";
  char range[48];
  std::snprintf(range, sizeof range, ": %.3g to %.3g", window.lower[axis], window.upper[axis]);
  return joint + range;
}

}  // namespace

MapPicture::MapPicture(std::shared_ptr<const AspectMap> map, MarkerFrames frames,
                       const DisplayOptions& options)
    : map_(std::move(map)),
      colors_(*map_),
      frames_(std::move(frames)),
      options_(options),
      projection_(map_),
      layout_(*map_, projection_.window(), options.gallery_scale) {
  // A little behind the robot, so that the picture never hides it.
  const Eigen::Translation3d behind(0.0, 0.0, -0.05 * map_->manipulator()->size());
  at_robot_ = {frames_.base, map_->manipulator()->task_frame() * behind};
  workspaces_ = {frames_.aspects, Eigen::Isometry3d::Identity()};
  joint_spaces_ = {frames_.joint_space, Eigen::Isometry3d::Identity()};
  joint_triangles_.resize(map_->aspects().size());
  for (const WorkingMode& mode : map_->working_modes()) add_mode(mode);
}

void MapPicture::add_mode(const WorkingMode& mode) {
  const PoseSlice all(TaskSpace::T2, 0.0);
  const Eigen::AlignedBox2d bounds = slice_bounds(*map_);
  const BoundaryPicture pieces = trace_slice(*map_, mode, all, bounds, joint_cells, Cells::single);
  BoundaryPicture tile = trace_slice(*map_, mode, all, bounds, tile_cells);
  auto joint_boundary = projection_.images(tile.segments, mode);
  std::vector<const Points*> images;
  for (const int id : aspects_of(mode)) {
    Points& image = joint_triangles_[static_cast<std::size_t>(id - 1)];
    image = projection_.triangles(id, pieces.slivers);
    images.push_back(&image);
  }
  modes_.push_back({mode, trace_slice(*map_, mode, all, bounds, robot_cells), std::move(tile),
                    std::move(joint_boundary), overlap(images, projection_.window())});
}

std::vector<int> MapPicture::aspects_of(const WorkingMode& mode) const {
  std::vector<int> ids;
  for (const Aspect& aspect : map_->aspects())
    if (aspect.mode == mode) ids.push_back(aspect.id);
  return ids;
}

visualization_msgs::MarkerArray MapPicture::gallery(const Drawn&) const {
  MarkerBatch batch;
  if (!options_.gallery) return batch.take();
  for (std::size_t column = 0; column < modes_.size(); ++column) {
    draw_workspace_tile(column, batch);
    draw_joint_tile(column, batch);
    draw_titles(column, batch);
  }
  draw_legend(batch);
  return batch.take();
}

visualization_msgs::MarkerArray MapPicture::present(const Drawn& now) const {
  MarkerBatch batch;
  const auto column = now ? column_of(now->mode) : std::nullopt;
  if (!column) return batch.take();
  draw_at_robot(*now, *column, batch);
  if (options_.gallery) outline_in_gallery(*column, now->aspect, batch);
  return batch.take();
}

bool MapPicture::gallery_differs(const Drawn&, const Drawn&) const { return false; }

bool MapPicture::present_differs(const Drawn& before, const Drawn& now) const {
  if (!before || !now) return before.has_value() != now.has_value();
  return before->mode != now->mode || before->aspect != now->aspect;
}

visualization_msgs::MarkerArray MapPicture::position(const Drawn& now) const {
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
    return still_frame(frames_.base, name,
                       at_robot_.pose * Eigen::Translation3d(origin.x(), origin.y(), 0.0));
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

void MapPicture::draw_at_robot(const DrawnConfiguration& now, std::size_t column, MarkerBatch& batch) const {
  const Placing place = [](const Vector2d& point) { return point; };
  const double text = layout_.text_height();
  for (const Aspect& aspect : map_->aspects()) {
    if (aspect.mode != now.mode) continue;
    const auto full = colors_.of(aspect.id);
    const auto shade = aspect.id == now.aspect ? full : lightened(full, 0.65);
    batch.triangles(at_robot_, "robot/aspects", sliver_triangles(modes_[column].at_robot.slivers, aspect.id),
                    height_of(Layer::fill, text), shade);
    batch.text(at_robot_, "robot/labels", label_point(aspect), height_of(Layer::text, text), text,
               std::to_string(aspect.id), readable_on(shade));
  }
  const CurveStyle style{text, 0.1 * text};
  draw_outline(modes_[column].at_robot.segments, now.aspect, place, style, at_robot_, "robot", batch);
  draw_curves(modes_[column].at_robot.segments, place, style, at_robot_, "robot", batch);
}

void MapPicture::outline_in_gallery(std::size_t column, int aspect, MarkerBatch& batch) const {
  const CurveStyle style{layout_.text_height(), 0.06 * layout_.text_height()};
  draw_outline(
      modes_[column].tile.segments, aspect,
      [&](const Vector2d& x) { return layout_.in_workspace_tile(x, column); }, style, workspaces_,
      "workspace", batch);
  draw_outline(
      modes_[column].joint_boundary, aspect,
      [&](const Vector2d& q) { return layout_.in_joint_tile(q, column); }, style, joint_spaces_,
      "joint_space", batch);
  if (modes_[column].overlaps) draw_over_others(column, aspect, batch);
}

// The present aspect over the others.
void MapPicture::draw_over_others(std::size_t column, int aspect, MarkerBatch& batch) const {
  if (aspect == 0) return;
  const double text = layout_.text_height();
  batch.triangles(joint_spaces_, "joint_space/present",
                  placed(joint_triangles_[static_cast<std::size_t>(aspect - 1)],
                         [&](const Vector2d& q) { return layout_.in_joint_tile(q, column); }),
                  height_of(Layer::fill, text) + 1.5 * stack_height * text, colors_.of(aspect));
}

void MapPicture::draw_workspace_tile(std::size_t column, MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const Placing place = [&](const Vector2d& point) { return layout_.in_workspace_tile(point, column); };
  for (const Aspect& aspect : map_->aspects()) {
    if (aspect.mode != modes_[column].mode) continue;
    const auto fill = colors_.of(aspect.id);
    batch.triangles(workspaces_, "workspace/aspects",
                    placed(sliver_triangles(modes_[column].tile.slivers, aspect.id), place),
                    height_of(Layer::fill, text), fill);
    batch.text(workspaces_, "workspace/labels", place(label_point(aspect)), height_of(Layer::text, text),
               0.8 * text, std::to_string(aspect.id), readable_on(fill));
  }
  draw_curves(modes_[column].tile.segments, place, {text, 0.06 * text}, workspaces_, "workspace", batch);
}

void MapPicture::draw_joint_tile(std::size_t column, MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const Placing place = [&](const Vector2d& q) { return layout_.in_joint_tile(q, column); };
  const ModePicture& picture = modes_[column];
  const std::vector<int> ids = aspects_of(picture.mode);
  double height = height_of(Layer::fill, text);
  for (const int id : ids) {
    batch.triangles(joint_spaces_, "joint_space/aspects",
                    placed(joint_triangles_[static_cast<std::size_t>(id - 1)], place), height,
                    colors_.of(id));
    height += stack_height * text / static_cast<double>(ids.size());
  }
  if (picture.overlaps) draw_several(column, batch);
  draw_curves(modes_[column].joint_boundary, place, {text, 0.06 * text}, joint_spaces_, "joint_space", batch);
  batch.lines(joint_spaces_, "joint_space/window",
              rectangle(layout_.joint_tile_center(column), layout_.joint_tile_size()),
              height_of(Layer::frame, text), 0.04 * text, color(0x808080));
}

void MapPicture::draw_titles(std::size_t column, MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const double layer = height_of(Layer::text, text);
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

// Projections overlap where there are several assembly modes.
void MapPicture::draw_several(std::size_t column, MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const Vector2d below(0.0, 0.5 * layout_.joint_tile_size().y() + 2.6 * text);
  batch.text(joint_spaces_, "joint_space/several", layout_.joint_tile_center(column) - below,
             height_of(Layer::text, text), 0.6 * text, "several aspects, one over another", ink());
}

void MapPicture::draw_legend(MarkerBatch& batch) const {
  const double text = layout_.text_height();
  const Vector2d below(0.0, -0.5 * layout_.joint_tile_size().y() - 4.0 * text);
  const Vector2d step = layout_.joint_tile_center(1) - layout_.joint_tile_center(0);
  std::vector<BoundarySegment> all;
  for (const ModePicture& mode : modes_)
    all.insert(all.end(), mode.tile.segments.begin(), mode.tile.segments.end());
  Vector2d at = below;
  for (const auto& [kind, words] : boundary_legend(all)) {
    batch.text(joint_spaces_, "joint_space/legend", at, height_of(Layer::text, text), 0.8 * text, words,
               color(boundary_color(kind)));
    at += modes_.size() > 2 ? Vector2d(1.5 * step) : Vector2d(0.0, -1.1 * text);
  }
}

}  // namespace parallel_aspects
