// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/robot_visuals.h"

#include "draw/scene/robot_lines.h"
#include "ros/messages/conversions.h"
#include "ros/pictures/marker_batch.h"
#include "urdf/reading/tree_reader.h"

#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using visualization_msgs::Marker;

Eigen::Isometry3d isometry(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) *
         Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}

Marker scaled(int type, double x, double y, double z) {
  Marker shape;
  shape.type = type;
  shape.scale.x = x;
  shape.scale.y = y;
  shape.scale.z = z;
  return shape;
}

std::optional<Marker> shape_of(const urdf::Geometry& geometry) {
  if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry))
    return scaled(Marker::CUBE, box->dim.x, box->dim.y, box->dim.z);
  if (const auto* ball = dynamic_cast<const urdf::Sphere*>(&geometry))
    return scaled(Marker::SPHERE, 2.0 * ball->radius, 2.0 * ball->radius, 2.0 * ball->radius);
  if (const auto* tube = dynamic_cast<const urdf::Cylinder*>(&geometry))
    return scaled(Marker::CYLINDER, 2.0 * tube->radius, 2.0 * tube->radius, tube->length);
  const auto* mesh = dynamic_cast<const urdf::Mesh*>(&geometry);
  if (mesh == nullptr) return std::nullopt;
  Marker shape = scaled(Marker::MESH_RESOURCE, mesh->scale.x, mesh->scale.y, mesh->scale.z);
  shape.mesh_resource = mesh->filename;
  return shape;
}

// In tf the frame may have a prefix.
bool names(const std::string& frame, const std::string& link) {
  return frame == link || (frame.size() > link.size() && frame[frame.size() - link.size() - 1] == '/' &&
                           frame.compare(frame.size() - link.size(), link.size(), link) == 0);
}

}  // namespace

RobotVisuals::RobotVisuals(std::shared_ptr<const Mechanism> mechanism, const std::string& urdf, double radius)
    : mechanism_(std::move(mechanism)),
      radius_(radius),
      base_frame_(mechanism_->manipulator()->base_frame()) {
  Problems problems;
  Notes notes;  // said by the loader
  auto tree = read_tree(urdf, "robot_description", problems, notes);
  if (!tree) return;
  tree_ = std::move(*tree);
  const auto& joints = mechanism_->joint_names();
  for (const std::size_t movable : tree_.movable) {
    const auto found = std::find(joints.begin(), joints.end(), tree_.joints[movable].name);
    if (found == joints.end()) return;
    sources_.push_back(static_cast<std::size_t>(found - joints.begin()));
  }
  const auto base = std::find_if(tree_.links.begin(), tree_.links.end(),
                                 [&](const std::string& link) { return names(base_frame_, link); });
  if (base == tree_.links.end()) return;
  base_ = static_cast<std::size_t>(base - tree_.links.begin());
  read_visuals(urdf);
}

void RobotVisuals::read_visuals(const std::string& urdf) {
  const auto model = urdf::parseURDF(urdf);
  if (!model) return;
  for (std::size_t link = 0; link < tree_.links.size(); ++link) {
    const auto found = model->getLink(tree_.links[link]);
    for (std::size_t i = 0; found && i < found->visual_array.size(); ++i) {
      const auto& visual = found->visual_array[i];
      if (!visual || !visual->geometry) continue;
      auto shape = shape_of(*visual->geometry);
      if (!shape) continue;
      if (moves(link))
        visuals_.push_back({link, isometry(visual->origin), std::move(*shape)});
      else
        add_still(link, isometry(visual->origin), *shape);
    }
  }
}

// Of a mesh the size is not known here.
void RobotVisuals::add_still(std::size_t link, const Eigen::Isometry3d& origin, const Marker& shape) {
  if (shape.type == Marker::MESH_RESOURCE) return;
  const Poses frames = link_poses(tree_, base_, Eigen::VectorXd::Zero(tree_.variables()));
  const Eigen::Isometry3d place = drawing_frame(*mechanism_->manipulator()).inverse() * frames[link] * origin;
  const Eigen::Vector3d half = 0.5 * Eigen::Vector3d(shape.scale.x, shape.scale.y, shape.scale.z);
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-half), half);
  for (int i = 0; i < 8; ++i)
    still_.extend(place * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
}

// Whether a joint above it does.
bool RobotVisuals::moves(std::size_t link) const {
  for (auto joint = tree_.joint_above[link]; joint; joint = tree_.joint_above[tree_.joints[*joint].parent])
    if (tree_.joints[*joint].variable) return true;
  return false;
}

std::vector<Marker> RobotVisuals::at(const Pose& pose, const JointVector& q, const std::string& group,
                                     const std_msgs::ColorRGBA& color) const {
  if (visuals_.empty()) return skeleton_at(pose, q, group, color);
  std::vector<Marker> markers;
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism_->joint_names().size()));
  if (!mechanism_->complete(pose, q, positions)) return markers;
  Eigen::VectorXd values(tree_.variables());
  for (std::size_t i = 0; i < sources_.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = positions[static_cast<Eigen::Index>(sources_[i])];
  const Poses frames = link_poses(tree_, base_, values);
  for (const Visual& visual : visuals_) {
    Marker marker = visual.shape;
    marker.header.frame_id = base_frame_;
    marker.ns = group;
    marker.id = static_cast<int>(markers.size());
    marker.pose = pose_message(frames[visual.link] * visual.origin);
    marker.color = color;
    markers.push_back(std::move(marker));
  }
  return markers;
}

std::vector<Marker> RobotVisuals::skeleton_at(const Pose& pose, const JointVector& q,
                                              const std::string& group,
                                              const std_msgs::ColorRGBA& color) const {
  const Manipulator& robot = *mechanism_->manipulator();
  MarkerBatch batch;
  batch.segments({base_frame_, drawing_frame(robot)}, group, skeleton_of(robot, pose, q, radius_),
                 skeleton_width * drawn_size(robot, radius_), color);
  return added_by(batch.take());
}

}  // namespace parallel_aspects
