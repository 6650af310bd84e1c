// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_MARKER_BATCH_H
#define PARALLEL_ASPECTS_ROS_PICTURES_MARKER_BATCH_H

#include "draw/plane/palette.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <geometry_msgs/TransformStamped.h>
#include <std_msgs/ColorRGBA.h>
#include <string>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {

std_msgs::ColorRGBA color(Rgb rgb, float opacity = 1.0F);

/// A list of planar drawings for rviz, with stamp zero and ids that count up within each namespace. It begins
/// by deleting whatever its topic drew before.
class MarkerBatch {
 public:
  MarkerBatch();

  /// A plane that points (x, y) and heights [m] are given in, seen from `frame`.
  struct Plane {
    std::string frame;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    bool lit = true;  ///< whether triangles are shaded by the light of the scene
  };

  using Points = std::vector<Eigen::Vector2d>;

  /// Triangles, three points each.
  void triangles(const Plane& plane, const std::string& group, const Points& corners, double height,
                 const std_msgs::ColorRGBA& color);

  /// Boxes with these edges [m] about points of the plane's frame.
  void cubes(const Plane& plane, const std::string& group, const std::vector<Eigen::Vector3d>& centers,
             const Eigen::Vector3d& edges, const std_msgs::ColorRGBA& color);

  /// Segments between points of the plane's frame, two points each. `width` [m].
  void segments(const Plane& plane, const std::string& group, const std::vector<Eigen::Vector3d>& ends,
                double width, const std_msgs::ColorRGBA& color);

  /// A line through points of the plane's frame, each with a colour. `width` [m].
  void strip(const Plane& plane, const std::string& group, const std::vector<Eigen::Vector3d>& points,
             const std::vector<std_msgs::ColorRGBA>& colors, double width);

  /// Balls about points of the plane's frame. `diameter` [m].
  void balls(const Plane& plane, const std::string& group, const std::vector<Eigen::Vector3d>& centers,
             double diameter, const std_msgs::ColorRGBA& color);

  /// Segments in the plane, two points each. `width` [m].
  void lines(const Plane& plane, const std::string& group, const Points& ends, double height, double width,
             const std_msgs::ColorRGBA& color);

  /// Discs that face the viewer from above. `diameter` [m].
  void dots(const Plane& plane, const std::string& group, const Points& centers, double height,
            double diameter, const std_msgs::ColorRGBA& color);

  /// One line of text, centered. `size`: height of a capital letter [m].
  void text(const Plane& plane, const std::string& group, const Eigen::Vector2d& center, double height,
            double size, const std::string& words, const std_msgs::ColorRGBA& color);

  visualization_msgs::MarkerArray take() { return std::move(array_); }

 private:
  visualization_msgs::Marker& add(const Plane& plane, const std::string& group, int type,
                                  const std_msgs::ColorRGBA& color);

  visualization_msgs::MarkerArray array_;
};

/// The markers of a batch without what deletes all others.
std::vector<visualization_msgs::Marker> added_by(visualization_msgs::MarkerArray batch);

/// A frame that stands still in the base frame; its stamp is zero.
geometry_msgs::TransformStamped still_frame(const std::string& base, const std::string& name,
                                            const Eigen::Isometry3d& pose);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_MARKER_BATCH_H
