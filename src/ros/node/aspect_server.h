// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_ASPECT_SERVER_H
#define PARALLEL_ASPECTS_ROS_NODE_ASPECT_SERVER_H

#include "ros/node/guarded_input.h"
#include "ros/node/robot_server.h"
#include "ros/parameters/load_options.h"

#include <parallel_aspects/Reload.h>

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/wall_timer.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace parallel_aspects {

/// Asks the master whether it still knows the topics and services of this process, and registers those that
/// it has forgotten, as after it was started anew. What is connected stays connected: nothing is shut down.
///
/// Calls of the master may block, so `look` belongs on a thread that has nothing urgent to do.
class MasterWatch {
 public:
  enum class Master {
    present,     ///< knows everything
    forgetful,   ///< did not know everything; what was missing is registered
    unreachable  ///< no answer
  };

  /// Compares once, and logs a message where something has changed since the call before. The first call
  /// shall be made when everything is advertised: of the services, those are known that a master has listed.
  Master look();

 private:
  Master compare();
  void compare_services(const std::set<std::string>& known);
  void count(bool registered);

  std::set<std::string> services_;  ///< of this process, as the master knew them
  Master last_ = Master::present;
  std::size_t registered_ = 0, refused_ = 0;  ///< topics and services, by the last `look`
};

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
