// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_ASPECT_SERVER_H
#define PARALLEL_ASPECTS_ROS_NODE_ASPECT_SERVER_H

#include "ros/node/guarded_queue.h"
#include "ros/node/master_watch.h"
#include "ros/node/robot_server.h"
#include "ros/parameters/load_options.h"

#include <parallel_aspects/Reload.h>

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/wall_timer.h>

#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {

/// The node and the nodelet: serves the robot of `robot_description`, and another one when it is asked to
/// load it anew. A master that is started anew gets it registered again; robot, map and tracking stay.
class AspectServer {
 public:
  /// Loads everything before it advertises anything. Throws `InvalidDescription` with every problem found.
  AspectServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);
  ~AspectServer();
  AspectServer(const AspectServer&) = delete;
  AspectServer& operator=(const AspectServer&) = delete;

 private:
  AspectServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, NodeSetup setup);

  Reload::Response reload();
  void replace_robot(NodeSetup setup);
  void serve_last_again(const std::string& reason);

  // Of `reload`, which takes the robot's queues down, and of calls of the master, which may block.
  GuardedQueue queue_;
  ros::NodeHandle nh_, private_nh_;
  const bool read_only_;                // as the node was started, whatever the parameter is now
  std::unique_ptr<RobotServer> robot_;  // null once neither a new robot nor the one before could be served
  std::optional<NodeSetup> last_served_;
  ros::ServiceServer reload_;
  MasterWatch master_;
  ros::WallTimer master_timer_;
  ros::AsyncSpinner spinner_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_ASPECT_SERVER_H
