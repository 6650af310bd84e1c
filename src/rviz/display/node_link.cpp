// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/node_link.h"

#include <boost/function.hpp>

namespace parallel_aspects {

NodeLink::NodeLink(ros::NodeHandle nh, const std::string& node)
    : nh_(std::move(nh)), name_(nh_.resolveName(node)) {
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  const boost::function<void(const AspectStateConstPtr&)> on_state =
      [this](const AspectStateConstPtr& state) {
        const std::lock_guard<std::mutex> lock(mutex_);
        news_.state = *state;
      };
  const boost::function<void(const MapProgressConstPtr&)> on_progress =
      [this](const MapProgressConstPtr& progress) {
        const std::lock_guard<std::mutex> lock(mutex_);
        news_.progress = *progress;
        if (progress->state == MapProgress::COMPLETE) ++news_.maps;
      };
  const boost::function<void(const std_msgs::UInt32MultiArrayConstPtr&)> on_shown =
      [this](const std_msgs::UInt32MultiArrayConstPtr& shown) {
        const std::lock_guard<std::mutex> lock(mutex_);
        news_.shown.emplace(shown->data.begin(), shown->data.end());
      };
  state_ = nh_.subscribe<AspectState>(name_ + "/state", 1, on_state, ros::VoidConstPtr(), hints);
  progress_ = nh_.subscribe<MapProgress>(name_ + "/map_progress", 10, on_progress);
  shown_ = nh_.subscribe<std_msgs::UInt32MultiArray>(name_ + "/shown_aspects", 1, on_shown);
}

NodeLink::~NodeLink() {
  state_.shutdown();
  progress_.shutdown();
  shown_.shutdown();
}

NodeLink::News NodeLink::news() {
  const bool is_there = state_.getNumPublishers() > 0;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_there != news_.is_there) {
    news_.is_there = is_there;
    if (!is_there) {  // what a node said before it went is not the present
      news_.state.reset();
      news_.progress.reset();
    }
  }
  return news_;
}

}  // namespace parallel_aspects
