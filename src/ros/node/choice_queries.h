// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_CHOICE_QUERIES_H
#define PARALLEL_ASPECTS_ROS_NODE_CHOICE_QUERIES_H

#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/aspects/segment_certifier.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "ros/monitor/map_worker.h"
#include "ros/node/pose_reading.h"

#include <parallel_aspects/ChooseWorkingMode.h>
#include <parallel_aspects/Connect.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Answers which working mode is best for a path or a region, and whether poses are connected. May be called
/// from any number of threads.
class ChoiceQueries {
 public:
  /// `manipulator`: that maps are of. `worker` must outlive the object.
  ChoiceQueries(std::shared_ptr<const Manipulator> manipulator, const MapWorker& worker,
                PoseTransformer to_base);

  ChooseWorkingMode::Response answer(const ChooseWorkingMode::Request& request) const;
  Connect::Response answer(const Connect::Request& request) const;

 private:
  Status choose(const ChooseWorkingMode::Request& request, ChooseWorkingMode::Response& response) const;
  Status read_path(const ChooseWorkingMode::Request& request, std::vector<PoseWaypoint>& waypoints) const;
  ask::Outcome<ask::ConnectAnswer> connect(const ask::ConnectQuestion& question) const;

  std::shared_ptr<const Manipulator> manipulator_;
  const MapWorker& worker_;
  PoseTransformer to_base_;
  mutable std::mutex session_mutex_;
  mutable ask::Session session_;  // its roadmap is made when it is first asked for
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_CHOICE_QUERIES_H
