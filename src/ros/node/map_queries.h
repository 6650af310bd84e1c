// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_MAP_QUERIES_H
#define PARALLEL_ASPECTS_ROS_NODE_MAP_QUERIES_H

#include "ros/monitor/map_worker.h"
#include "ros/parameters/load_options.h"

#include <parallel_aspects/GetMap.h>

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_MAP_QUERIES_H
