// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/boundary_curves.h"
#include "parallel_aspects/aspects/joint_projection.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "ros/parameters/node_options.h"
#include "ros/pictures/gallery_layout.h"
#include "ros/pictures/marker_batch.h"
#include "ros/pictures/marker_colors.h"
#include "ros/pictures/picture.h"

#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// The picture of one two-dimensional map: the whole workspace and joint space of every working mode. Its
/// geometry is worked out once; what moves is cheap.
class MapPicture : public Picture {
 public:
  MapPicture(std::shared_ptr<const AspectMap> map, MarkerFrames frames, const DisplayOptions& options);

  visualization_msgs::MarkerArray gallery(const Drawn& now) const override;
  visualization_msgs::MarkerArray present(const Drawn& now) const override;
  visualization_msgs::MarkerArray position(const Drawn& now) const override;
  bool gallery_differs(const Drawn& before, const Drawn& now) const override;
  bool present_differs(const Drawn& before, const Drawn& now) const override;
  std::vector<geometry_msgs::TransformStamped> frames() const override;

 private:
  struct ModePicture {
    WorkingMode mode;
    BoundaryPicture at_robot, tile;               // in the workspace, finely and less so
    std::vector<BoundarySegment> joint_boundary;  // in joint space
    bool overlaps = false;                        // whether several aspects lie over the same joint values
  };

  std::optional<std::size_t> column_of(const WorkingMode& mode) const;
  void add_mode(const WorkingMode& mode);
  void draw_at_robot(const DrawnConfiguration& now, std::size_t column, MarkerBatch& batch) const;
  void outline_in_gallery(std::size_t column, int aspect, MarkerBatch& batch) const;
  void draw_over_others(std::size_t column, int aspect, MarkerBatch& batch) const;
  std::vector<int> aspects_of(const WorkingMode& mode) const;
  void draw_workspace_tile(std::size_t column, MarkerBatch& batch) const;
  void draw_joint_tile(std::size_t column, MarkerBatch& batch) const;
  void draw_several(std::size_t column, MarkerBatch& batch) const;
  void draw_titles(std::size_t column, MarkerBatch& batch) const;
  void draw_legend(MarkerBatch& batch) const;

  std::shared_ptr<const AspectMap> map_;
  AspectColors colors_;
  MarkerFrames frames_;
  DisplayOptions options_;
  JointProjection projection_;
  GalleryLayout layout_;
  MarkerBatch::Plane at_robot_, workspaces_, joint_spaces_;
  std::vector<ModePicture> modes_;                // a column each
  std::vector<TriangleCorners> joint_triangles_;  // by aspect id - 1
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H
