// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MAP_PICTURE_H
#define PARALLEL_ASPECTS_ROS_MAP_PICTURE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/boundary_curves.h"
#include "parallel_aspects/aspects/joint_projection.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/ros/conversions.h"
#include "parallel_aspects/ros/gallery_layout.h"
#include "parallel_aspects/ros/marker_batch.h"
#include "parallel_aspects/ros/node_options.h"

#include <geometry_msgs/TransformStamped.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {

/// Frames that markers are drawn in.
struct MarkerFrames {
  std::string base;
  std::string aspects;      ///< of the upper row of the gallery
  std::string joint_space;  ///< of the lower row
};

/// What the picture follows; empty while the robot is not tracked.
struct DrawnConfiguration {
  WorkingMode mode;
  int aspect = 0;  ///< id, or 0
  SolvedPose solved;
};

/// The picture of one two-dimensional map. Its geometry is worked out once; what moves is cheap. Stamps are
/// zero and ids stable, and every array begins by deleting what the last one drew. Immutable.
class MapPicture {
 public:
  MapPicture(std::shared_ptr<const AspectMap> map, MarkerFrames frames, const DisplayOptions& options);

  /// Whether there is anything to draw: the map has two dimensions and at least one aspect.
  static bool can_draw(const AspectMap& map);

  /// The gallery, and at the robot the aspects of its working mode with the present one highlighted.
  visualization_msgs::MarkerArray aspects(const std::optional<DrawnConfiguration>& now) const;

  /// Dots at the present pose and drive values.
  visualization_msgs::MarkerArray position(const std::optional<DrawnConfiguration>& now) const;

  /// Where the frames of the gallery stand, in the base frame; stamps are zero.
  std::vector<geometry_msgs::TransformStamped> frames() const;

 private:
  struct ModePicture {
    WorkingMode mode;
    std::vector<BoundarySegment> boundary, joint_boundary;  // in the workspace and in joint space
  };

  std::optional<std::size_t> column_of(const WorkingMode& mode) const;
  void add_mode(const WorkingMode& mode);
  void draw_at_robot(const DrawnConfiguration& now, MarkerBatch& batch) const;
  void draw_workspace_tile(std::size_t column, int highlighted, MarkerBatch& batch) const;
  void draw_joint_tile(std::size_t column, int highlighted, MarkerBatch& batch) const;
  void draw_titles(std::size_t column, MarkerBatch& batch) const;
  void draw_legend(MarkerBatch& batch) const;

  std::shared_ptr<const AspectMap> map_;
  MarkerFrames frames_;
  DisplayOptions options_;
  JointProjection projection_;
  GalleryLayout layout_;
  MarkerBatch::Plane at_robot_, workspaces_, joint_spaces_;
  std::vector<ModePicture> modes_;                                      // a column each
  std::vector<TriangleCorners> workspace_triangles_, joint_triangles_;  // by aspect id - 1
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MAP_PICTURE_H
