// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/marker_batch.h"

#include "ros/messages/conversions.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

using visualization_msgs::Marker;

geometry_msgs::Point point(const Eigen::Vector2d& at, double height) {
  geometry_msgs::Point message;
  message.x = at.x();
  message.y = at.y();
  message.z = height;
  return message;
}

void set_points(Marker& marker, const MarkerBatch::Points& points, double height) {
  marker.points.reserve(points.size());
  for (const Eigen::Vector2d& at : points) marker.points.push_back(point(at, height));
}

void set_points(Marker& marker, const std::vector<Eigen::Vector3d>& points) {
  marker.points.reserve(points.size());
  for (const Eigen::Vector3d& at : points) marker.points.push_back(point(at.head<2>(), at.z()));
}

}  // namespace

std_msgs::ColorRGBA color(Rgb rgb, float opacity) {
  std_msgs::ColorRGBA result;
  result.r = static_cast<float>(rgb >> 16U & 0xFFU) / 255.0F;
  result.g = static_cast<float>(rgb >> 8U & 0xFFU) / 255.0F;
  result.b = static_cast<float>(rgb & 0xFFU) / 255.0F;
  result.a = opacity;
  return result;
}

MarkerBatch::MarkerBatch() {
  array_.markers.resize(1);
  array_.markers.front().action = Marker::DELETEALL;
}

Marker& MarkerBatch::add(const Plane& plane, const std::string& group, int type,
                         const std_msgs::ColorRGBA& color) {
  Marker marker;
  marker.header.frame_id = plane.frame;
  marker.ns = group;
  marker.id = static_cast<int>(std::count_if(array_.markers.begin(), array_.markers.end(),
                                             [&](const Marker& other) { return other.ns == group; }));
  marker.type = type;
  marker.pose = pose_message(plane.pose);
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color = color;
  array_.markers.push_back(std::move(marker));
  return array_.markers.back();
}

void MarkerBatch::triangles(const Plane& plane, const std::string& group, const Points& corners,
                            double height, const std_msgs::ColorRGBA& color) {
  if (corners.empty()) return;
  Marker& marker = add(plane, group, Marker::TRIANGLE_LIST, color);
  set_points(marker, corners, height);
  if (!plane.lit)
    marker.colors.assign(marker.points.size(), color);  // rviz lights only markers of one colour
}

void MarkerBatch::cubes(const Plane& plane, const std::string& group,
                        const std::vector<Eigen::Vector3d>& centers, const Eigen::Vector3d& edges,
                        const std_msgs::ColorRGBA& color) {
  if (centers.empty()) return;
  Marker& marker = add(plane, group, Marker::CUBE_LIST, color);
  marker.scale.x = edges.x();
  marker.scale.y = edges.y();
  marker.scale.z = edges.z();
  set_points(marker, centers);
}

void MarkerBatch::segments(const Plane& plane, const std::string& group,
                           const std::vector<Eigen::Vector3d>& ends, double width,
                           const std_msgs::ColorRGBA& color) {
  if (ends.empty()) return;
  Marker& marker = add(plane, group, Marker::LINE_LIST, color);
  marker.scale.x = width;
  set_points(marker, ends);
}

void MarkerBatch::strip(const Plane& plane, const std::string& group,
                        const std::vector<Eigen::Vector3d>& points,
                        const std::vector<std_msgs::ColorRGBA>& colors, double width) {
  if (points.empty()) return;
  Marker& marker = add(plane, group, Marker::LINE_STRIP, colors.front());
  marker.scale.x = width;
  marker.colors = colors;
  set_points(marker, points);
}

void MarkerBatch::balls(const Plane& plane, const std::string& group,
                        const std::vector<Eigen::Vector3d>& centers, double diameter,
                        const std_msgs::ColorRGBA& color) {
  if (centers.empty()) return;
  Marker& marker = add(plane, group, Marker::SPHERE_LIST, color);
  marker.scale.x = marker.scale.y = marker.scale.z = diameter;
  set_points(marker, centers);
}

void MarkerBatch::lines(const Plane& plane, const std::string& group, const Points& ends, double height,
                        double width, const std_msgs::ColorRGBA& color) {
  if (ends.empty()) return;
  Marker& marker = add(plane, group, Marker::LINE_LIST, color);
  marker.scale.x = width;
  set_points(marker, ends, height);
}

void MarkerBatch::dots(const Plane& plane, const std::string& group, const Points& centers, double height,
                       double diameter, const std_msgs::ColorRGBA& color) {
  if (centers.empty()) return;
  Marker& marker = add(plane, group, Marker::SPHERE_LIST, color);
  marker.scale.x = marker.scale.y = marker.scale.z = diameter;
  set_points(marker, centers, height);
}

void MarkerBatch::text(const Plane& plane, const std::string& group, const Eigen::Vector2d& center,
                       double height, double size, const std::string& words,
                       const std_msgs::ColorRGBA& color) {
  Marker& marker = add(plane, group, Marker::TEXT_VIEW_FACING, color);
  marker.scale.z = size;
  marker.text = words;
  marker.pose = pose_message(plane.pose * Eigen::Translation3d(center.x(), center.y(), height));
}

std::vector<Marker> added_by(visualization_msgs::MarkerArray batch) {
  batch.markers.erase(batch.markers.begin());
  return std::move(batch.markers);
}

geometry_msgs::TransformStamped still_frame(const std::string& base, const std::string& name,
                                            const Eigen::Isometry3d& pose) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = base;
  message.child_frame_id = name;
  message.transform = transform_message(pose);
  return message;
}

}  // namespace parallel_aspects
