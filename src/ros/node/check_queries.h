// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_CHECK_QUERIES_H
#define PARALLEL_ASPECTS_ROS_NODE_CHECK_QUERIES_H

#include "parallel_aspects/ask/check.h"
#include "ros/node/queries.h"

#include <parallel_aspects/CheckTrajectory.h>

#include <memory>

namespace parallel_aspects {

/// Answers ~check_trajectory. May be called from any number of threads.
class CheckQueries {
 public:
  /// `manipulator` with the constraints that are checked; `monitor` must outlive the object.
  CheckQueries(std::shared_ptr<const Manipulator> manipulator, const RobotMonitor& monitor,
               PoseTransformer to_base);

  CheckTrajectory::Response answer(const CheckTrajectory::Request& request) const;

 private:
  Status read(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const;
  Status read_joints(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const;
  Status read_poses(const CheckTrajectory::Request& request, ask::CheckQuestion& question) const;
  Status start_joints_now(ask::CheckQuestion& question) const;
  Status start_poses_now(ask::CheckQuestion& question) const;

  std::shared_ptr<const Manipulator> manipulator_;
  const RobotMonitor& monitor_;
  PoseTransformer to_base_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_CHECK_QUERIES_H
