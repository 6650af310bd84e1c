// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/link/node_link.h"

#include <boost/function.hpp>

#include <std_msgs/UInt32.h>

namespace parallel_aspects {

NodeLink::NodeLink(ros::NodeHandle nh, const std::string& node)
    : nh_(std::move(nh)), name_(nh_.resolveName(node)), ping_(name_) {
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  const boost::function<void(const AspectStateConstPtr&)> on_state =
      [this](const AspectStateConstPtr& state) {
        const std::lock_guard<std::mutex> lock(mutex_);
        news_.state = *state;
      };
  const boost::function<void(const ros::MessageEvent<MapProgress const>&)> on_progress =
      [this](const ros::MessageEvent<MapProgress const>& event) {
        const std::lock_guard<std::mutex> lock(mutex_);
        news_.progress = *event.getMessage();
        if (connection_ != event.getConnectionHeaderPtr().get()) ++news_.starts;
        connection_ = event.getConnectionHeaderPtr().get();
        if (news_.progress->state == MapProgress::COMPLETE) ++news_.maps;
      };
  const boost::function<void(const AssemblyCandidatesConstPtr&)> on_candidates =
      [this](const AssemblyCandidatesConstPtr& candidates) {
        const std::lock_guard<std::mutex> lock(mutex_);
        news_.candidates = *candidates;
      };
  const boost::function<void(const std_msgs::UInt32MultiArrayConstPtr&)> on_shown =
      [this](const std_msgs::UInt32MultiArrayConstPtr& shown) {
        const std::lock_guard<std::mutex> lock(mutex_);
        news_.shown.emplace(shown->data.begin(), shown->data.end());
      };
  state_ = nh_.subscribe<AspectState>(name_ + "/state", 1, on_state, ros::VoidConstPtr(), hints);
  selected_ = nh_.advertise<std_msgs::UInt32>(name_ + "/selected_aspect", 1, true);
  progress_ = nh_.subscribe<MapProgress, const ros::MessageEvent<MapProgress const>&>(name_ + "/map_progress",
                                                                                      10, on_progress);
  candidates_ = nh_.subscribe<AssemblyCandidates>(name_ + "/candidates", 1, on_candidates);
  shown_ = nh_.subscribe<std_msgs::UInt32MultiArray>(name_ + "/shown_aspects", 1, on_shown);
}

NodeLink::~NodeLink() {
  state_.shutdown();
  progress_.shutdown();
  shown_.shutdown();
  candidates_.shutdown();
  selected_.shutdown();
}

void NodeLink::select(int aspect) {
  std_msgs::UInt32 message;
  message.data = static_cast<std::uint32_t>(aspect);
  selected_.publish(message);
}

NodeLink::News NodeLink::news() {
  const bool is_there = ping_.answers() && state_.getNumPublishers() > 0;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_there != news_.is_there) {
    news_.is_there = is_there;
    if (!is_there) {  // what a node sent before it ended is out of date
      news_.state.reset();
      news_.progress.reset();
      news_.candidates = {};
    }
  }
  return news_;
}

}  // namespace parallel_aspects
