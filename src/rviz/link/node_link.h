// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_LINK_NODE_LINK_H
#define PARALLEL_ASPECTS_RVIZ_LINK_NODE_LINK_H

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AssemblyCandidates.h>
#include <parallel_aspects/MapProgress.h>

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>

#include "rviz/link/background_worker.h"
#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <std_msgs/UInt32MultiArray.h>
#include <string>

namespace parallel_aspects {

/// What one aspect_node publishes that a display draws from, as it came last.
class NodeLink {
 public:
  struct News {
    bool is_there = false;  ///< whether a node of this name publishes and can be reached
    std::optional<AspectState> state;
    std::optional<MapProgress> progress;
    std::uint64_t maps = 0;              ///< reports of a complete map
    std::uint64_t starts = 0;            ///< of nodes: another one may have another robot
    std::optional<std::set<int>> shown;  ///< ids that a panel chose
    AssemblyCandidates candidates;       ///< while it is not known where the robot is
  };

  /// `node`: its name, resolved by `nh`, whose queue calls back in any thread.
  NodeLink(ros::NodeHandle nh, const std::string& node);
  ~NodeLink();
  NodeLink(const NodeLink&) = delete;
  NodeLink& operator=(const NodeLink&) = delete;

  const std::string& name() const noexcept { return name_; }  ///< resolved

  /// Call from one thread.
  News news();

  /// Says on `~selected_aspect` which aspect somebody clicked.
  void select(int aspect);

 private:
  ros::NodeHandle nh_;
  const std::string name_;
  const NodePing ping_;
  std::mutex mutex_;
  News news_;
  ros::Subscriber state_, progress_, shown_, candidates_;
  ros::Publisher selected_;
  const void* connection_ = nullptr;  // that progress came by; compared only
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_LINK_NODE_LINK_H
