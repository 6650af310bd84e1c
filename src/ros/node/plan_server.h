// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_PLAN_SERVER_H
#define PARALLEL_ASPECTS_ROS_NODE_PLAN_SERVER_H

#include "parallel_aspects/ask/plan.h"
#include "ros/messages/configurations.h"
#include "ros/monitor/map_worker.h"
#include "ros/monitor/robot_monitor.h"
#include "ros/node/guarded_input.h"
#include "ros/parameters/load_options.h"
#include "ros/questions/plan_question.h"

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
    ask::PlanQuestion asked;
    std::string note;  // of what was taken for an end
    bool stay_in_domain = false;
    KnownAspects known;
    double margin = 0.0;  // parallel index to be kept; 0 for what the robot keeps anyway
  };

  /// Whom questions are asked of, and what it was made for: it has planners, which know the gates of its map.
  struct Prepared {
    KnownAspects known;  // of the node
    double margin = 0.0;
    std::unique_ptr<ask::Session> session;  // null before the first question
  };

  void on_goal(const PlanPathGoalConstPtr& goal);
  Status read(const PlanPathGoal& goal, Question& question) const;
  Status read_ends(const PlanPathGoal& goal, Question& question) const;
  Status read_map(Question& question) const;
  Status read_end(const Configuration& configuration, const std::string& which, ask::EndQuestion& end) const;
  Status read_now(ask::EndQuestion& end) const;
  void keep_to_domain(const Question& question, const PathDomains& domains, ask::PlanAnswer& answer) const;
  ask::Session& session_for(const Question& question);
  ask::Control control();
  ask::Acceleration acceleration_for(const PlanPathGoal& goal) const;
  void finish(ask::Outcome<ask::PlanAnswer> outcome, const Question& question, PlanPathResult result);
  void publish(const ask::PlanAnswer& answer, const PlanPathResult& result);

  const NodeSetup& setup_;
  const std::shared_ptr<const Manipulator> manipulator_;
  const RobotMonitor& monitor_;
  const MapWorker& worker_;
  const PoseTransformer to_base_;
  ros::Publisher path_, trajectory_, markers_;
  CheckedGoals<PlanPathActionGoal> goals_;
  Prepared prepared_;
  std::atomic<bool> stopping_{false}, cancelled_{false};
  std::unique_ptr<Server> server_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_PLAN_SERVER_H
