// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_QUESTIONS_MAP_QUERIES_H
#define PARALLEL_ASPECTS_ROS_QUESTIONS_MAP_QUERIES_H

#include "parallel_aspects/ask/workspace.h"
#include "ros/monitor/map_worker.h"
#include "ros/parameters/load_options.h"

#include <parallel_aspects/GetMap.h>
#include <parallel_aspects/GetRegularWorkspace.h>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace parallel_aspects {

/// Sends the map to displays, which draw it by themselves. May be called from any number of threads.
class MapQueries {
 public:
  /// Both must outlive the object.
  MapQueries(const NodeSetup& setup, const MapWorker& worker) : setup_(setup), worker_(worker) {}

  GetMap::Response answer(const GetMap::Request& request) const;

 private:
  const NodeSetup& setup_;
  const MapWorker& worker_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const AspectMap> known_;  // that the revision is of
  mutable std::string revision_;
};

/// Answers ~get_regular_workspace and draws the best. May be called from any number of threads.
class WorkspaceQueries {
 public:
  /// `worker` must outlive the object.
  WorkspaceQueries(ros::NodeHandle private_nh, const MapWorker& worker);

  GetRegularWorkspace::Response answer(const GetRegularWorkspace::Request& request) const;

  /// Ends what is under way, with the status CANCELLED.
  void cancel() { cancelled_ = true; }

 private:
  Status find(const std::shared_ptr<const AspectMap>& map, const GetRegularWorkspace::Request& request,
              GetRegularWorkspace::Response& response) const;

  const MapWorker& worker_;
  ros::Publisher markers_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_QUESTIONS_MAP_QUERIES_H
