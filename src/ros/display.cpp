// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ros/display.h"

namespace parallel_aspects {
namespace {

std::optional<DrawnConfiguration> drawn(const CurrentConfiguration& current) {
  if (current.status.code != Status::OK) return std::nullopt;
  return DrawnConfiguration{current.tracked.mode, current.tracked.aspect, current.solved};
}

}  // namespace

Display::Display(const NodeSetup& setup, ros::NodeHandle private_nh)
    : frames_{setup.mechanism->manipulator()->base_frame(), setup.options.frame_prefix + "/aspects",
              setup.options.frame_prefix + "/joint_space"},
      options_(setup.options.display),
      markers_(private_nh.advertise<visualization_msgs::MarkerArray>("markers", 1, true)),
      position_markers_(private_nh.advertise<visualization_msgs::MarkerArray>("position_markers", 1, true)) {}

void Display::set_map(const std::shared_ptr<const AspectMap>& map) {
  if (!MapPicture::can_draw(*map)) return;
  const auto picture = std::make_shared<const MapPicture>(map, frames_, options_);
  static_tf_.sendTransform(picture->frames());
  const std::lock_guard<std::mutex> lock(mutex_);
  picture_ = picture;
  fresh_ = true;
}

void Display::show(const CurrentConfiguration& current) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!picture_) return;
  const auto now = drawn(current);
  const Highlight highlight = now ? Highlight({now->mode, now->aspect}) : std::nullopt;
  if (fresh_ || highlight != highlight_) markers_.publish(picture_->aspects(now));
  if (now || dot_ || fresh_) position_markers_.publish(picture_->position(now));
  fresh_ = false;
  highlight_ = highlight;
  dot_ = now.has_value();
}

}  // namespace parallel_aspects
