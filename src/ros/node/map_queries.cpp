// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/map_queries.h"

#include "ros/messages/conversions.h"
#include "ros/messages/map_messages.h"

namespace parallel_aspects {

GetMap::Response MapQueries::answer(const GetMap::Request& request) const {
  GetMap::Response response;
  const Manipulator& manipulator = *setup_.mechanism->manipulator();
  response.urdf = setup_.urdf;
  response.description = setup_.description;
  response.base_frame = manipulator.base_frame();
  response.task_space = std::string(name(manipulator.task_space()));
  if (!has_map(manipulator.task_space())) {
    response.status = make_status(Status::NO_MAP, "There is no map of six degrees of freedom, now or later.");
    return response;
  }
  const std::shared_ptr<const AspectMap> map = worker_.map();
  if (!map) {
    response.status =
        make_status(Status::MAP_NOT_READY, "There is no map yet. " + worker_.progress().message);
    return response;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (map == known_ && request.known_revision == revision_) {
    response.revision = revision_;
    return response;
  }
  add_map(*map, response);
  known_ = map;
  revision_ = response.revision;
  if (response.revision == request.known_revision) response.map.clear();
  return response;
}

}  // namespace parallel_aspects
