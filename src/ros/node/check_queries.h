// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_CHECK_QUERIES_H
#define PARALLEL_ASPECTS_ROS_NODE_CHECK_QUERIES_H

#include "parallel_aspects/aspects/segment_certifier.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "ros/node/queries.h"

#include <parallel_aspects/CheckTrajectory.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Answers ~check_trajectory. May be called from any number of threads.
class CheckQueries {
 public:
  /// `manipulator` with the constraints that are checked; `monitor` must outlive the object.
  CheckQueries(std::shared_ptr<const Manipulator> manipulator, const RobotMonitor& monitor,
               PoseTransformer to_base);

  CheckTrajectory::Response answer(const CheckTrajectory::Request& request) const;

 private:
  struct Question {
    Status status;  ///< what keeps it from being asked
    std::vector<JointWaypoint> joints;
    TrajectoryStart start;
    std::vector<PoseWaypoint> poses;
    WorkingMode mode;
    TrajectoryCheckOptions options;
    std::size_t distances = 0;  ///< at how many times
  };

  TrajectoryCheck check(const Question& question) const;
  Question read(const CheckTrajectory::Request& request) const;
  void read_joints(const CheckTrajectory::Request& request, Question& question) const;
  void read_poses(const CheckTrajectory::Request& request, Question& question) const;
  void start_joints_now(Question& question) const;
  void start_poses_now(Question& question) const;

  std::shared_ptr<const Manipulator> manipulator_;
  SegmentCertifier certifier_;
  const RobotMonitor& monitor_;
  PoseTransformer to_base_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_CHECK_QUERIES_H
