// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_QUESTIONS_QUERIES_H
#define PARALLEL_ASPECTS_ROS_QUESTIONS_QUERIES_H

#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/distance.h"
#include "ros/messages/configurations.h"
#include "ros/messages/conversions.h"
#include "ros/monitor/map_worker.h"
#include "ros/monitor/robot_monitor.h"

#include <parallel_aspects/Configuration.h>
#include <parallel_aspects/GetCurrentAspect.h>
#include <parallel_aspects/GetJacobian.h>
#include <parallel_aspects/GetSingularityDistance.h>
#include <parallel_aspects/GetWorkingMode.h>
#include <parallel_aspects/ListAspects.h>
#include <parallel_aspects/SetAssemblyMode.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Answers the services. May be called from any number of threads.
class Queries {
 public:
  /// `monitor` and `worker` must outlive the object. `read_only`: whether set_assembly_mode is refused.
  Queries(std::shared_ptr<const Manipulator> manipulator, RobotMonitor& monitor, const MapWorker& worker,
          PoseTransformer to_base, bool read_only);

  GetWorkingMode::Response answer(const GetWorkingMode::Request& request) const;
  GetCurrentAspect::Response answer(const GetCurrentAspect::Request& request) const;
  GetSingularityDistance::Response answer(const GetSingularityDistance::Request& request) const;
  GetJacobian::Response answer(const GetJacobian::Request& request) const;
  ListAspects::Response answer(const ListAspects::Request& request) const;
  SetAssemblyMode::Response answer(const SetAssemblyMode::Request& request) const;

 private:
  /// The configurations that a request means.
  struct Meant {
    Status status;    ///< OK with at least one configuration, or why there is none
    ros::Time stamp;  ///< of them
    std::vector<ask::LocatedConfiguration> configurations;
  };

  Meant locate(const Configuration& configuration, const KnownAspects& known) const;
  Status read(const Configuration& configuration, ask::LocateQuestion& question, ros::Time& stamp) const;
  Status start(const Configuration& configuration) const;
  std::vector<SolvedConfiguration> messages(const Meant& meant) const;
  BoundaryDistances distances(const ask::LocatedConfiguration& located) const;

  std::shared_ptr<const Manipulator> manipulator_;
  RobotMonitor& monitor_;
  const MapWorker& worker_;
  PoseTransformer to_base_;
  const bool read_only_;
  mutable std::mutex session_mutex_;
  mutable ask::Session session_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_QUESTIONS_QUERIES_H
