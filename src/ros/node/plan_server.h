// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_PLAN_SERVER_H
#define PARALLEL_ASPECTS_ROS_NODE_PLAN_SERVER_H

#include "parallel_aspects/motion/plan_path.h"
#include "parallel_aspects/motion/time_path.h"
#include "ros/monitor/map_worker.h"
#include "ros/monitor/robot_monitor.h"
#include "ros/node/checked_goals.h"
#include "ros/node/pose_reading.h"
#include "ros/parameters/load_options.h"

#include <parallel_aspects/PlanPathAction.h>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <actionlib/server/simple_action_server.h>
#include <atomic>
#include <memory>
#include <string>

namespace parallel_aspects {

/// Serves the action ~plan_path, on a thread of its own, and publishes what was planned. It moves nothing.
class PlanServer {
 public:
  /// `nh`: the private namespace, and the queue that goals come from. The others must outlive the object.
  PlanServer(const ros::NodeHandle& nh, const NodeSetup& setup, const RobotMonitor& monitor,
             const MapWorker& worker, PoseTransformer to_base);
  ~PlanServer() { shutdown(); }
  PlanServer(const PlanServer&) = delete;
  PlanServer& operator=(const PlanServer&) = delete;

  /// Cancels, waits, and accepts no more.
  void shutdown();

 private:
  using Server = actionlib::SimpleActionServer<PlanPathAction>;

  /// A goal, understood.
  struct Question {
    PathEnd from, to;
    PathWish wish;
    KnownAspects known;
    bool timed = true;
  };

  /// A path, and how the pose runs between two of its points.
  struct Plan {
    PlannedPath path;
    PoseBetween between = pose_between;
  };

  void on_goal(const PlanPathGoalConstPtr& goal);
  Status read(const PlanPathGoal& goal, Question& question) const;
  Status read_wish(const PlanPathGoal& goal, PathWish& wish) const;
  Status read_limits() const;
  Status read_end(const Configuration& configuration, const std::string& which, PathEnd& end) const;
  Status read_now(PathEnd& end) const;
  PathWish timed(PathWish wish, const PoseBetween& between, const MapControl& control) const;
  Plan plan(const Question& question);
  MapControl control(const std::string& doing);
  void finish(const Plan& plan, const Question& question, PlanPathResult result);
  void publish(const Plan& plan, const PlanPathResult& result);

  const NodeSetup& setup_;
  const std::shared_ptr<const Manipulator> manipulator_;
  const RobotMonitor& monitor_;
  const MapWorker& worker_;
  const PoseTransformer to_base_;
  const SegmentCertifier certifier_;
  ros::Publisher path_, trajectory_, markers_;
  CheckedGoals<PlanPathActionGoal> goals_;
  std::shared_ptr<const AspectMap> map_;  // of the planner, which knows its gates
  std::shared_ptr<PathPlanner> planner_;
  std::atomic<bool> stopping_{false}, cancelled_{false};
  std::unique_ptr<Server> server_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_PLAN_SERVER_H
