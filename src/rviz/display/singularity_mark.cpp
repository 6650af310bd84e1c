// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/singularity_mark.h"

#include "draw/plane/palette.h"
#include "parallel_aspects/model/manipulator.h"

#include "rviz/shapes/ogre_shapes.h"
#include <OgreEntity.h>

namespace parallel_aspects {
namespace {

constexpr double way_width = 0.008, end_size = 0.03;  // of the picture's size
constexpr std::chrono::milliseconds between_measurements(100);
constexpr double step = 1e-3;  // of the robot's size, that it moves until it is examined anew

}  // namespace

void SingularityMark::show(const SurfacePicture& picture, const std::shared_ptr<const Manipulator>& robot,
                           const Eigen::Vector3d& placement, const std::pair<Pose, WorkingMode>& present,
                           const PresentPoints::Place& place) {
  if (robot_ != robot) {
    clear();
    robot_ = robot;
    meter_ = std::make_unique<BoundaryDistanceMeter>(robot);
  }
  if (is_due(present, picture.radian)) {
    measured_ = present;
    radian_ = picture.radian;
    at_ = Clock::now();
    nearest_ = nearest_singularity(*robot, present.first, meter_->measure(present.first, present.second),
                                   picture.radian);
    draw(picture.size, place);
  }
  if (!nearest_) return;
  line_->setPosition(ogre_vector(placement));
  for (std::size_t i = 0; i < dots_.size(); ++i)
    dots_[i]->setPosition(ogre_vector(Eigen::Vector3d(placement + nearest_->ends[i])));
}

bool SingularityMark::is_due(const std::pair<Pose, WorkingMode>& present, double radian) const {
  if (!measured_ || measured_->second != present.second || radian_ != radian) return true;
  return anchor_distance(*robot_, measured_->first, present.first) > step * robot_->size() &&
         Clock::now() - at_ >= between_measurements;
}

void SingularityMark::clear() {
  line_.reset();
  dots_.clear();
  nearest_.reset();
  measured_.reset();
}

void SingularityMark::draw(double size, const PresentPoints::Place& place) {
  line_.reset();
  dots_.clear();
  if (!nearest_) return;
  const Ogre::ColourValue color = ogre_color(boundary_color(nearest_->kind));
  line_ = std::make_unique<rviz::BillboardLine>(place.scene, place.node);
  line_->setColor(color.r, color.g, color.b, 1.0F);
  set_segments(nearest_->way, way_width * size, *line_);
  show_through(*line_);
  for (std::size_t i = 0; i < nearest_->ends.size(); ++i) add_dot(end_size * size, color, place);
}

void SingularityMark::add_dot(double width, const Ogre::ColourValue& color,
                              const PresentPoints::Place& place) {
  auto dot = std::make_unique<rviz::Shape>(rviz::Shape::Sphere, place.scene, place.node);
  dot->setScale(Ogre::Vector3(static_cast<float>(width)));
  dot->setColor(color.r, color.g, color.b, 1.0F);
  dot->getMaterial()->setDepthCheckEnabled(false);
  dot->getEntity()->setRenderQueueGroup(after_the_rest);
  dots_.push_back(std::move(dot));
}

}  // namespace parallel_aspects
