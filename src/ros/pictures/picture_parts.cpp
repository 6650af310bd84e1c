// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/picture_parts.h"

#include "ros/messages/conversions.h"
#include "ros/pictures/marker_colors.h"

#include <algorithm>
#include <cstdio>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;
using Points = MarkerBatch::Points;

Points ends_of(const std::vector<BoundarySegment>& segments, const Placing& place,
               const std::function<bool(const BoundarySegment&)>& wanted) {
  Points ends;
  for (const BoundarySegment& segment : segments)
    if (wanted(segment)) ends.insert(ends.end(), {place(segment.from), place(segment.to)});
  return ends;
}

}  // namespace

double height_of(Layer layer, double text_height) { return 0.02 * text_height * static_cast<double>(layer); }

std_msgs::ColorRGBA ink() { return color(ink_color); }

Points placed(const Points& points, const Placing& place) {
  Points result;
  result.reserve(points.size());
  for (const Vector2d& point : points) result.push_back(place(point));
  return result;
}

Points sliver_triangles(const std::vector<BoundarySliver>& slivers, int aspect) {
  Points corners;
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

std::string legend_text(const Aspect& aspect, TaskSpace space) {
  char text[64];
  std::snprintf(text, sizeof text, "%d:  det A %s 0,  %.4g %s", aspect.id,
                aspect.determinant_sign > 0 ? ">" : "<", aspect.measure,
                std::string(measure_unit(space)).c_str());
  return text;
}

void draw_curves(const std::vector<BoundarySegment>& segments, const Placing& place, const CurveStyle& style,
                 const MarkerBatch::Plane& plane, const std::string& group, MarkerBatch& batch) {
  for (const auto& [each, words] : boundary_words()) {
    const BoundaryKind kind = each;
    batch.lines(plane, group + "/boundary",
                ends_of(segments, place, [&](const auto& s) { return s.kind == kind; }),
                height_of(Layer::boundary, style.text_height), style.width, color(boundary_color(kind)));
  }
}

void draw_outline(const std::vector<BoundarySegment>& segments, int aspect, const Placing& place,
                  const CurveStyle& style, const MarkerBatch::Plane& plane, const std::string& group,
                  MarkerBatch& batch) {
  const auto borders = [&](const BoundarySegment& segment) {
    return std::count(segment.aspects.begin(), segment.aspects.end(), aspect) > 0;
  };
  if (aspect != 0)
    batch.lines(plane, group + "/outline", ends_of(segments, place, borders),
                height_of(Layer::outline, style.text_height), 2.2 * style.width, ink());
}

std::vector<std::pair<BoundaryKind, const char*>> boundary_legend(
    const std::vector<BoundarySegment>& segments) {
  std::vector<std::pair<BoundaryKind, const char*>> entries = boundary_words();
  const auto is_absent = [&](const auto& entry) {
    return std::none_of(segments.begin(), segments.end(),
                        [&](const BoundarySegment& segment) { return segment.kind == entry.first; });
  };
  entries.erase(std::remove_if(entries.begin(), entries.end(), is_absent), entries.end());
  return entries;
}

void draw_dot(const MarkerBatch::Plane& plane, const std::string& group, const Vector2d& at,
              double text_height, MarkerBatch& batch) {
  batch.dots(plane, group, {at}, height_of(Layer::dot, text_height), 0.55 * text_height, color(0x000000));
  batch.dots(plane, group, {at}, 0.3 * text_height, 0.35 * text_height, color(0xFFFFFF));
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
