// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_ROBOT_SERVER_H
#define PARALLEL_ASPECTS_ROS_NODE_ROBOT_SERVER_H

#include "ros/monitor/decimation.h"
#include "ros/monitor/frame_watch.h"
#include "ros/monitor/map_worker.h"
#include "ros/monitor/robot_monitor.h"
#include "ros/node/diagnostics.h"
#include "ros/node/guarded_input.h"
#include "ros/node/log_queue.h"
#include "ros/node/plan_server.h"
#include "ros/parameters/load_options.h"
#include "ros/parameters/reconfiguration.h"
#include "ros/pictures/display.h"
#include "ros/probe/probe.h"
#include "ros/questions/map_queries.h"
#include "ros/questions/motion_queries.h"
#include "ros/questions/queries.h"

#include <parallel_aspects/ComputeMapAction.h>

#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include <actionlib/server/simple_action_server.h>
#include <actionlib_msgs/GoalID.h>
#include <atomic>
#include <memory>
#include <mutex>
#include <sensor_msgs/JointState.h>

namespace parallel_aspects {

/// One robot in the node: connects topics, services, an action, tf and timers to the objects that do the
/// work.
///
/// Threads of its own, so that nothing long holds up what is short: joint_states, which neither logs nor
/// draws; services, display and diagnostics; the action; the map.
class RobotServer {
 public:
  /// Advertises everything. `nh` resolves joint_states and /diagnostics, `private_nh` the rest.
  RobotServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, NodeSetup setup);
  ~RobotServer();
  RobotServer(const RobotServer&) = delete;
  RobotServer& operator=(const RobotServer&) = delete;

  /// What this robot was made of, with what was reconfigured since.
  NodeSetup setup() const;

 private:
  using Transforms = ros::MessageEvent<const tf2_msgs::TFMessage>;
  using ComputeMapServer = actionlib::SimpleActionServer<ComputeMapAction>;

  void advertise();
  void subscribe();
  void accept_reconfiguration();
  template <typename Service, typename Answers>
  void serve(const std::string& name, const Answers& answers);
  void start_guard();
  void start_probe();
  void stop_probe();

  void on_joint_states(const ros::MessageEvent<const sensor_msgs::JointState>& event);
  void on_velocity_command(const geometry_msgs::TwistStamped& command);
  void publish_guarded(const GuardedCommand& command);
  TurnedTwist turned(const geometry_msgs::TwistStamped& command) const;
  std::string no_transform(const std::string& frame, const std::exception& failure) const;
  void publish_robot(const TrackedState& tracked, const ros::Time& stamp);
  void on_tf(const Transforms& event);
  void on_tf_static(const Transforms& event);
  void watch(const Transforms& event, FrameWatch::Topic topic);
  void on_map_progress(const MapProgress& progress, const std::shared_ptr<const AspectMap>& map);
  void on_compute_map(const ComputeMapGoalConstPtr& goal);
  void on_cancel_map(const actionlib_msgs::GoalID& goal);
  Status status_of_goal(const MapOptions& options) const;
  MapProgress wait_for_map(MapWorker::Job job);
  void finish(const MapProgress& progress, ComputeMapResult result);
  void check_age();
  void show();
  void work();
  void report_stand_off();
  void report_silence();
  void send_platform(const Eigen::Isometry3d& platform, const ros::Time& stamp);
  std::optional<geometry_msgs::Pose> to_base(const geometry_msgs::PoseStamped& pose,
                                             std::string& message) const;

  const NodeSetup setup_;
  GuardedQueue tracking_queue_, service_queue_, work_queue_;
  GuardedQueue tf_queue_;                               // tf2 throws for stamps at the end of time
  ros::NodeHandle tracking_nh_, service_nh_, work_nh_;  // private namespace
  ros::NodeHandle joint_states_nh_;                     // of the input topic
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  tf2_ros::TransformBroadcaster tf_broadcaster_;

  RobotMonitor monitor_;
  Display display_;
  ros::Publisher guarded_velocity_, guarded_joint_velocities_;  // where the guard is on
  ros::Publisher state_, transitions_, last_transition_, joint_states_, candidates_, map_progress_;
  MapWorker worker_;
  std::atomic<MapWorker::Job> first_map_{0};  // that the node computes at its start
  Queries queries_;
  MotionQueries motions_;
  MapQueries maps_;
  WorkspaceQueries workspaces_;
  FrameWatch frame_watch_;
  Diagnostics diagnostics_;
  LogQueue log_;  // what the threads of joint_states have to say
  CheckedGoals<ComputeMapActionGoal> goals_;
  Decimation thinned_, completed_;  // of joint_states_: state, and what is drawn from it
  std::unique_ptr<ComputeMapServer> compute_map_;
  std::unique_ptr<PlanServer> plan_path_;
  std::unique_ptr<Reconfiguration> reconfiguration_;
  std::mutex probe_mutex_;        // of the pointer
  std::unique_ptr<Probe> probe_;  // where it is on
  std::vector<ros::ServiceServer> services_;
  ros::Subscriber subscriber_, tf_subscriber_, tf_static_subscriber_;
  ros::Subscriber command_subscriber_, cancel_subscriber_;
  ros::SteadyTimer age_timer_, command_timer_;
  ros::WallTimer display_timer_, diagnostics_timer_, log_timer_, work_timer_, stand_off_timer_,
      silence_timer_;
  std::atomic<bool> stopping_{false};
  ros::AsyncSpinner tracking_spinner_, service_spinner_, work_spinner_, tf_spinner_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_ROBOT_SERVER_H
