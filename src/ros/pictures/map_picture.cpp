// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/map_picture.h"

#include "ros/pictures/plane_markers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
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

bool overlap(const PlaneScene& scene, const JointWindow& window) {
  std::vector<int> counts(compared_points * compared_points, 0);
  for (const PlaneArea& area : scene.areas) {
    const std::vector<bool> inside = covered(triangles_of(area), window);
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

/// The whole workspace and joint space of every working mode. Its geometry is worked out once; what moves is
/// cheap.
class MapPicture : public Picture {
 public:
  MapPicture(std::shared_ptr<const AspectMap> map, MarkerFrames frames, const DisplayOptions& options)
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
    for (const WorkingMode& mode : map_->working_modes()) modes_.push_back(picture_of(mode));
  }

  visualization_msgs::MarkerArray gallery(const Drawn&) const override {
    MarkerBatch batch;
    if (!options_.gallery) return batch.take();
    for (std::size_t column = 0; column < modes_.size(); ++column) {
      draw_workspace_tile(column, batch);
      draw_joint_tile(column, batch);
    }
    draw_legend(batch);
    return batch.take();
  }

  visualization_msgs::MarkerArray present(const Drawn& now) const override {
    MarkerBatch batch;
    const auto column = now ? column_of(now->mode) : std::nullopt;
    if (!column) return batch.take();
    const ModePicture& picture = modes_[*column];
    const double text = layout_.text_height();
    const PlanePainter robot(batch, at_robot_, "robot", text, 0.1 * text);
    for (const PlaneArea& area : picture.at_robot.areas) {
      robot.area(area, now->aspect);
      robot.label(area, label_point(area), text, now->aspect);
    }
    robot.outline(picture.at_robot, now->aspect);
    robot.boundaries(picture.at_robot);
    if (!options_.gallery) return batch.take();
    workspace(*column, batch).outline(picture.tile, now->aspect);
    joint_space(*column, batch).outline(picture.joints, now->aspect);
    for (const PlaneArea& area : picture.joints.areas)  // the present aspect over the others
      if (picture.overlaps && area.aspect == now->aspect)
        joint_space(*column, batch).area(area, {}, 1.0F, 1.5 * stack_height * text, "/present");
    return batch.take();
  }

  bool present_differs(const Drawn& before, const Drawn& now) const override {
    if (!before || !now) return before.has_value() != now.has_value();
    return before->mode != now->mode || before->aspect != now->aspect;
  }

  visualization_msgs::MarkerArray position(const Drawn& now) const override {
    MarkerBatch batch;
    const auto column = now ? column_of(now->mode) : std::nullopt;
    if (!column || !options_.gallery) return batch.take();
    const Vector2d pose = now->solved.pose.position.head<2>();
    const Vector2d q = projection_.window().wrapped(now->solved.q.head<2>());
    const double text = layout_.text_height();
    PlanePainter(batch, workspaces_, "position/workspace", text, 0.0)
        .dot(layout_.in_workspace_tile(pose, *column));
    PlanePainter(batch, joint_spaces_, "position/joint_space", text, 0.0)
        .dot(layout_.in_joint_tile(q, *column));
    return batch.take();
  }

  std::vector<geometry_msgs::TransformStamped> frames() const override {
    const auto frame = [this](const std::string& name, const Vector2d& origin) {
      return still_frame(frames_.base, name,
                         at_robot_.pose * Eigen::Translation3d(origin.x(), origin.y(), 0.0));
    };
    return {frame(frames_.aspects, layout_.aspects_origin()),
            frame(frames_.joint_space, layout_.joint_space_origin())};
  }

 private:
  struct ModePicture {
    WorkingMode mode;
    PlaneScene at_robot, tile;  // in the workspace, finely and less so
    PlaneScene joints;          // in joint space
    bool overlaps = false;      // whether several aspects lie over the same joint values
  };

  // Those that are too small for the grid have an area without pieces, so that they are in the legend.
  ModePicture picture_of(const WorkingMode& mode) const {
    std::set<int> ids;
    for (const Aspect& aspect : map_->aspects())
      if (aspect.mode == mode) ids.insert(aspect.id);
    const PosePlane plane = plane_of(*map_);
    const auto traced = [&](int cells, Cells merging) {
      return trace_slice(*map_, mode, plane.slice, plane.bounds, cells, merging);
    };
    const BoundaryPicture tile = traced(tile_cells, Cells::merged);
    ModePicture picture{
        mode, pose_scene(*map_, plane, traced(robot_cells, Cells::merged), ids),
        pose_scene(*map_, plane, tile, ids),
        joint_scene(*map_, projection_, traced(joint_cells, Cells::single), ids, mode, Pieces::enlarged)};
    picture.joints.boundaries = projection_.images(tile.segments, mode);
    picture.overlaps = overlap(picture.joints, projection_.window());
    return picture;
  }

  PlanePainter workspace(std::size_t column, MarkerBatch& batch) const {
    const double text = layout_.text_height();
    return {batch,
            workspaces_,
            "workspace",
            text,
            0.06 * text,
            [this, column](const Vector2d& point) { return layout_.in_workspace_tile(point, column); }};
  }

  PlanePainter joint_space(std::size_t column, MarkerBatch& batch) const {
    const double text = layout_.text_height();
    return {batch,         joint_spaces_,
            "joint_space", text,
            0.06 * text,   [this, column](const Vector2d& q) { return layout_.in_joint_tile(q, column); }};
  }

  // Where a label of an aspect has most room.
  Vector2d label_point(const PlaneArea& area) const {
    return map_->aspects()[static_cast<std::size_t>(area.aspect - 1)].deepest.position.head<2>();
  }

  std::optional<std::size_t> column_of(const WorkingMode& mode) const {
    const auto found = std::find_if(modes_.begin(), modes_.end(),
                                    [&](const ModePicture& picture) { return picture.mode == mode; });
    if (found == modes_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - modes_.begin());
  }

  void draw_workspace_tile(std::size_t column, MarkerBatch& batch) const {
    const double text = layout_.text_height();
    const PlaneScene& tile = modes_[column].tile;
    const PlanePainter painter = workspace(column, batch);
    const Vector2d middle = layout_.workspace_tile_center(column),
                   half_up(0.0, 0.5 * layout_.workspace_tile_size().y());
    Vector2d line = middle - half_up - Vector2d(0.0, 0.9 * text);
    for (const PlaneArea& area : tile.areas) {
      painter.area(area);
      painter.label(area, label_point(area), 0.8 * text);
      painter.words("/sizes", line, 0.8 * text, area.title);
      line.y() -= 0.95 * text;
    }
    painter.boundaries(tile);
    painter.words("/titles", middle + half_up + Vector2d(0.0, text), text,
                  "working mode " + to_string(modes_[column].mode));
  }

  // Projections overlap where there are several assembly modes.
  void draw_joint_tile(std::size_t column, MarkerBatch& batch) const {
    const double text = layout_.text_height();
    const ModePicture& picture = modes_[column];
    const PlanePainter painter = joint_space(column, batch);
    double height = 0.0;
    for (const PlaneArea& area : picture.joints.areas) {
      painter.area(area, {}, 1.0F, height);
      height += stack_height * text / static_cast<double>(picture.joints.areas.size());
    }
    painter.boundaries(picture.joints);
    const Vector2d middle = layout_.joint_tile_center(column);
    painter.frame("/window", middle, layout_.joint_tile_size(), 0x808080, 0.04 * text);
    Vector2d below = middle - Vector2d(0.0, 0.5 * layout_.joint_tile_size().y() + 0.7 * text);
    for (std::size_t leg = 0; leg < 2; ++leg) {
      painter.words("/axes", below, 0.75 * text, range_text(projection_.window(), *map_->manipulator(), leg));
      below.y() -= 0.95 * text;
    }
    if (picture.overlaps) painter.words("/several", below, 0.6 * text, "several aspects, one over another");
  }

  void draw_legend(MarkerBatch& batch) const {
    const double text = layout_.text_height();
    const Vector2d step = layout_.joint_tile_center(1) - layout_.joint_tile_center(0);
    Vector2d at(0.0, -0.5 * layout_.joint_tile_size().y() - 4.0 * text);
    std::set<BoundaryKind> kinds;
    for (const ModePicture& mode : modes_) kinds.merge(kinds_of(mode.tile.boundaries));
    for (const LegendEntry& entry : boundary_legend(kinds)) {
      joint_space(0, batch).words("/legend", at, 0.8 * text, entry.text, entry.color);
      at += modes_.size() > 2 ? Vector2d(1.5 * step) : Vector2d(0.0, -1.1 * text);
    }
  }

  std::shared_ptr<const AspectMap> map_;
  MarkerFrames frames_;
  DisplayOptions options_;
  JointProjection projection_;
  GalleryLayout layout_;
  MarkerBatch::Plane at_robot_, workspaces_, joint_spaces_;
  std::vector<ModePicture> modes_;  // a column each
};

}  // namespace

std::shared_ptr<const Picture> make_map_picture(const std::shared_ptr<const AspectMap>& map,
                                                const MarkerFrames& frames, const DisplayOptions& options) {
  return std::make_shared<const MapPicture>(map, frames, options);
}

}  // namespace parallel_aspects
