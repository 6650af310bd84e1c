// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_SLICE_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_SLICE_PICTURE_H

#include "ros/parameters/node_options.h"
#include "ros/pictures/picture.h"
#include "ros/pictures/plane_markers.h"
#include "ros/pictures/scene.h"

#include "draw/plane/map_pictures.h"
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The picture of a three-dimensional map: slices at the present phi, z or torsion (see `PoseSlice`), one of
/// every working mode in the gallery, and that of the present mode at the robot where poses are positions.
class SlicePicture : public Picture {
 public:
  SlicePicture(std::shared_ptr<const AspectMap> map, MarkerFrames frames, const Scene& scene,
               const DisplayOptions& options);

  visualization_msgs::MarkerArray gallery(const Drawn& now) const override;
  visualization_msgs::MarkerArray present(const Drawn& now) const override;
  visualization_msgs::MarkerArray position(const Drawn& now) const override;
  bool gallery_differs(const Drawn& before, const Drawn& now) const override;
  bool present_differs(const Drawn& before, const Drawn& now) const override;
  std::optional<PoseSlice> section(const Drawn& now) const override { return slice(now); }
  std::vector<geometry_msgs::TransformStamped> frames() const override;

 private:
  PoseSlice slice(const Drawn& now) const;
  double level_change(const Drawn& before, const Drawn& now) const;
  std::optional<std::size_t> tile_of(const WorkingMode& mode) const;
  PlanePainter painter(std::size_t tile, const std::string& group, double text, MarkerBatch& batch) const;
  void draw_tile(std::size_t tile, const PlaneScene& scene, MarkerBatch& batch) const;
  std::vector<int> legend(const PlaneScene& scene, const WorkingMode& mode, const Drawn& now) const;
  void draw_titles(std::size_t tile, const PlaneScene& scene, const Drawn& now, MarkerBatch& batch) const;
  void draw_at_robot(const DrawnConfiguration& now, MarkerBatch& batch) const;

  std::shared_ptr<const AspectMap> map_;
  std::vector<Rgb> colors_;  // by id - 1
  TaskSpace space_;
  MarkerFrames frames_;
  Scene scene_;
  DisplayOptions options_;
  Eigen::AlignedBox2d bounds_;
  double level_range_;  // that the map takes
  double first_level_;  // drawn while the robot is not tracked
  MarkerBatch::Plane gallery_plane_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_SLICE_PICTURE_H
