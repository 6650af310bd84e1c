// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_MAP_MESSAGES_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_MAP_MESSAGES_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <parallel_aspects/GetMap.h>

#include <cstddef>
#include <memory>
#include <string>

namespace parallel_aspects {

/// The largest map that is sent [bytes].
inline constexpr std::size_t most_map_bytes = 20000000;

/// Fills in map, options and revision, of which the texts of the response are a part, or the status that says
/// why there are none.
void add_map(const AspectMap& map, GetMap::Response& response, std::size_t most_bytes = most_map_bytes);

/// The mechanism that the response is about. Throws `InvalidDescription`.
SharedMechanism mechanism_of(const GetMap::Response& response);

/// The map of a response with the status OK that brings one, of its mechanism.
MapResult map_of(const GetMap::Response& response, const Mechanism& mechanism);

/// The aspects of a map as lines of text, for the console.
std::string aspect_table(const AspectMap& map);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_MAP_MESSAGES_H
