// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_QUESTIONS_MOTION_QUERIES_H
#define PARALLEL_ASPECTS_ROS_QUESTIONS_MOTION_QUERIES_H

#include "parallel_aspects/ask/check.h"
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/connect.h"
#include "ros/messages/configurations.h"
#include "ros/monitor/map_worker.h"
#include "ros/monitor/robot_monitor.h"

#include <parallel_aspects/CheckTrajectory.h>
#include <parallel_aspects/ChooseWorkingMode.h>
#include <parallel_aspects/Connect.h>

#include <memory>
#include <mutex>
#include <vector>

namespace parallel_aspects {

/// Answers whether a trajectory is safe, which working mode is best for a path or a region, and whether poses
/// are connected. May be called from any number of threads.
class MotionQueries {
 public:
  /// `manipulator` with the constraints that are checked, that maps are of; `monitor` and `worker` must
  /// outlive the object.
  MotionQueries(std::shared_ptr<const Manipulator> manipulator, const RobotMonitor& monitor,
                const MapWorker& worker, PoseTransformer to_base);

  CheckTrajectory::Response answer(const CheckTrajectory::Request& request) const;
  ChooseWorkingMode::Response answer(const ChooseWorkingMode::Request& request) const;
  Connect::Response answer(const Connect::Request& request) const;

 private:
  Status read(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const;
  Status read_joints(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const;
  Status read_poses(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const;
  Status start_joints_now(ask::CheckQuestion& question) const;
  Status start_poses_now(ask::CheckQuestion& question) const;
  Status choose(const ChooseWorkingMode::Request& request, ChooseWorkingMode::Response& response) const;
  Status read_path(const ChooseWorkingMode::Request& request, std::vector<PoseWaypoint>& waypoints) const;
  ask::Outcome<ask::ConnectAnswer> connect(const ask::ConnectQuestion& question) const;

  std::shared_ptr<const Manipulator> manipulator_;
  const RobotMonitor& monitor_;
  const MapWorker& worker_;
  PoseTransformer to_base_;
  mutable std::mutex session_mutex_;
  mutable ask::Session session_;  // its roadmap is made when it is first asked for
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_QUESTIONS_MOTION_QUERIES_H
