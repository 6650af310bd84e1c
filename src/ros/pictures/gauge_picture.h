// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_GAUGE_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_GAUGE_PICTURE_H

#include "parallel_aspects/model/manipulator.h"
#include "ros/parameters/node_options.h"
#include "ros/pictures/marker_batch.h"
#include "ros/pictures/picture.h"
#include "ros/pictures/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The picture while there is no map, and of robots that have none: a gauge for each index that vanishes at a
/// singularity, at the present configuration.
class GaugePicture : public Picture {
 public:
  GaugePicture(std::shared_ptr<const Manipulator> manipulator, MarkerFrames frames, const Scene& scene);

  visualization_msgs::MarkerArray gallery(const Drawn& now) const override;
  visualization_msgs::MarkerArray present(const Drawn& now) const override;
  visualization_msgs::MarkerArray position(const Drawn& now) const override;
  bool gallery_differs(const Drawn& before, const Drawn& now) const override;
  bool present_differs(const Drawn& before, const Drawn& now) const override;
  std::vector<geometry_msgs::TransformStamped> frames() const override;

 private:
  struct Gauge {
    std::string label;
    double share = 0.0;  // of its largest value, 0 to 1; 0 is singular
    bool parallel = false;
  };

  std::vector<Gauge> gauges(const DrawnConfiguration& now) const;
  void draw(const Gauge& gauge, std::size_t row, MarkerBatch& batch) const;
  double row_height() const noexcept;

  std::shared_ptr<const Manipulator> manipulator_;
  MarkerFrames frames_;
  Scene scene_;
  MarkerBatch::Plane plane_;
  double top_ = 0.0;  // of the title, so that the gauges stand in the middle [m]
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_GAUGE_PICTURE_H
