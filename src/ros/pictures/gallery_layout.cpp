// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/gallery_layout.h"

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

}  // namespace parallel_aspects
