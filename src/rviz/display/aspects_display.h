// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_ASPECTS_DISPLAY_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_ASPECTS_DISPLAY_H

#include "rviz/display/drawn_picture.h"
#include "rviz/display/picture_thread.h"
#include "rviz/display/present_points.h"
#include "rviz/display/singularity_mark.h"

#include "rviz/link/node_link.h"
#include <memory>
#include <rviz/display.h>
#include <string>
#include <utility>
#include <vector>

namespace rviz {
class BoolProperty;
class EnumProperty;
class FloatProperty;
class StringProperty;
}  // namespace rviz

namespace parallel_aspects {

/// The map of one aspect_node, drawn as surfaces that follow the robot. Asks for the map once, and again when
/// another one is complete; what it waits for is in its status.
class AspectsDisplay : public rviz::Display {
  Q_OBJECT

 public:
  AspectsDisplay();
  ~AspectsDisplay() override;

  void update(float wall_dt, float ros_dt) override;
  void reset() override;

 protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;

 private Q_SLOTS:
  void follow_node();
  void change_look();

 private:
  void stop();
  void forget_picture();
  void place();
  void place_robot();
  void take_news();
  void take_state();
  void tell(const PictureThread::Result& result);
  void tell_robot();
  void ask_for_volume(const PictureThread::Result& result);
  SurfaceMouse section_mouse();
  void select(int aspect);
  void ask_for_picture();
  void take_picture(const PictureThread::Result& result);
  PictureChoice choice() const;
  Look look() const;
  bool differs(const PictureChoice& choice) const;

  rviz::StringProperty *node_, *chosen_;
  rviz::EnumProperty *shown_, *section_, *axis_;
  rviz::FloatProperty *offset_, *opacity_, *present_opacity_, *radian_;
  rviz::BoolProperty *upper_, *boundaries_, *ids_, *legend_, *nearest_, *joint_space_, *gallery_, *reload_;

  std::unique_ptr<NodeLink> link_;
  std::unique_ptr<PictureThread> thread_;
  std::unique_ptr<DrawnPicture> drawn_;
  PresentPoints points_;
  SingularityMark mark_;
  std::string where_;  // the robot is, in words
  NodeLink::News news_;
  std::shared_ptr<const ReceivedRobot> robot_;  // that is drawn
  std::shared_ptr<const ReceivedMap> map_;      // of it
  std::shared_ptr<const SurfacePicture> picture_;
  std::optional<Pose> present_;               // while it is known
  std::optional<WorkingMode> mode_;           // the last that was known
  PresentPoints::Configurations candidates_;  // while it is not
  std::set<int> candidate_ids_;
  Eigen::Vector3d placement_ = Eigen::Vector3d::Zero();
  SurfaceListeners listeners_;
  int selected_ = 0;                        // id of the aspect that was clicked
  double taken_offset_ = 0.0;               // of the section when it was taken
  std::optional<Pose> volume_at_;           // that the last volume was asked for
  std::optional<WorkingMode> volume_mode_;  // likewise
  std::optional<PictureChoice> asked_;
  std::optional<Pose> asked_at_;
  std::uint64_t maps_ = 0, starts_ = 0;  // of complete maps and of nodes, that were followed
  std::uint64_t robots_ = 0;             // that were received
  float since_look_ = 0.0F, since_picture_ = 0.0F;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_ASPECTS_DISPLAY_H
