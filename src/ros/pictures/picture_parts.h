// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_PICTURE_PARTS_H
#define PARALLEL_ASPECTS_ROS_PICTURES_PICTURE_PARTS_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "ros/pictures/marker_batch.h"

#include "draw/plane/map_pictures.h"
#include <functional>
#include <geometry_msgs/TransformStamped.h>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Where a point of a picture's own coordinates is drawn, in a plane [m].
using Placing = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// What lies above what.
enum class Layer { fill, frame, outline, boundary, dot, dot_core, text };

/// Height above the plane of a drawing [m].
double height_of(Layer layer, double text_height);

std_msgs::ColorRGBA ink();

MarkerBatch::Points placed(const MarkerBatch::Points& points, const Placing& place);

/// Triangles of the slivers of one aspect.
MarkerBatch::Points sliver_triangles(const std::vector<BoundarySliver>& slivers, int aspect);

/// The four sides.
MarkerBatch::Points rectangle(const Eigen::Vector2d& center, const Eigen::Vector2d& size);

/// "3:  det A > 0,  193.6 m^2"
std::string legend_text(const Aspect& aspect, TaskSpace space);

/// How curves are drawn: height of text, width of lines [m].
struct CurveStyle {
  double text_height, width;
};

/// Boundaries in the colours of their kinds.
void draw_curves(const std::vector<BoundarySegment>& segments, const Placing& place, const CurveStyle& style,
                 const MarkerBatch::Plane& plane, const std::string& group, MarkerBatch& batch);

/// A dark line around one aspect, wider than the boundaries.
void draw_outline(const std::vector<BoundarySegment>& segments, int aspect, const Placing& place,
                  const CurveStyle& style, const MarkerBatch::Plane& plane, const std::string& group,
                  MarkerBatch& batch);

/// Names of the kinds of boundaries that occur, in their colours.
std::vector<std::pair<BoundaryKind, const char*>> boundary_legend(
    const std::vector<BoundarySegment>& segments);

void draw_dot(const MarkerBatch::Plane& plane, const std::string& group, const Eigen::Vector2d& at,
              double text_height, MarkerBatch& batch);

/// A frame that stands still in the base frame; its stamp is zero.
geometry_msgs::TransformStamped still_frame(const std::string& base, const std::string& name,
                                            const Eigen::Isometry3d& pose);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_PICTURE_PARTS_H
