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
#include "ros/plan/cusp_question.h"
#include "ros/plan/path_domains.h"

#include <parallel_aspects/PlanPathAction.h>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <actionlib/server/simple_action_server.h>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
    std::optional<CuspQuestion> cusp;  // in place of `to`
    bool stay_in_domain = false;
    PathWish wish;
    KnownAspects known;
    bool timed = true;
    double margin = 0.0;  // parallel index to be kept; 0 for what the robot keeps anyway
  };

  /// A path, how the pose runs between two of its points, and what proves it, with the margins that it keeps.
  struct Plan {
    Status status;  // not OK where the question turned out to have no answer
    PlannedPath path;
    std::vector<int> turns_around_cusps;  // empty where not asked for
    std::shared_ptr<const SegmentCertifier> certifier;
    PoseBetween between = pose_between;
  };

  /// A planner, and what it was made for.
  struct Prepared {
    std::shared_ptr<const AspectMap> map;  // of the node
    double margin = 0.0;
    std::shared_ptr<PathPlanner> planner;  // null before the first question
    std::shared_ptr<const SegmentCertifier> certifier;
  };

  void on_goal(const PlanPathGoalConstPtr& goal);
  Status read(const PlanPathGoal& goal, Question& question) const;
  Status read_wish(const PlanPathGoal& goal, PathWish& wish) const;
  Status read_ends(const PlanPathGoal& goal, Question& question) const;
  Status read_map(Question& question) const;
  Status read_limits() const;
  Status read_end(const Configuration& configuration, const std::string& which, PathEnd& end) const;
  Status read_now(PathEnd& end) const;
  PathWish timed(const PathWish& wish, const Plan& plan, const MapControl& control) const;
  Plan plan(const Question& question);
  Plan plan_around(const Question& question);
  void keep_to_domain(const Question& question, const PathDomains& domains, Plan& plan) const;
  std::string prepare(const Question& question);
  MapControl control(const std::string& doing);
  void finish(Plan plan, const Question& question, PlanPathResult result);
  void publish(const Plan& plan, const PlanPathResult& result);

  const NodeSetup& setup_;
  const std::shared_ptr<const Manipulator> manipulator_;
  const RobotMonitor& monitor_;
  const MapWorker& worker_;
  const PoseTransformer to_base_;
  const std::shared_ptr<const SegmentCertifier> certifier_;
  ros::Publisher path_, trajectory_, markers_;
  CheckedGoals<PlanPathActionGoal> goals_;
  Prepared prepared_;  // knows the gates of its map
  std::atomic<bool> stopping_{false}, cancelled_{false};
  std::unique_ptr<Server> server_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_PLAN_SERVER_H
