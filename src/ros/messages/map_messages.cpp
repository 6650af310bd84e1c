// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/map_messages.h"

#include "parallel_aspects/aspects/aspect_map.h"
#include "ros/messages/conversions.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>

namespace parallel_aspects {
namespace {

// Of the bytes, whose last four are their checksum, and of the texts.
std::string revision_of(const GetMap::Response& response) {
  std::string text;
  const std::size_t size = response.map.size();
  for (std::size_t i = size - std::min<std::size_t>(4, size); i < size; ++i) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned>(response.map[i]));
    text += digits;
  }
  const std::size_t texts =
      std::hash<std::string>()(response.urdf + '\n' + response.description + '\n' + response.base_frame);
  return text + "-" + std::to_string(size) + "-" + std::to_string(texts);
}

}  // namespace

void add_map(const AspectMap& map, GetMap::Response& response, std::size_t most_bytes) {
  response.map = map_bytes(map);
  response.revision = revision_of(response);
  if (response.map.size() > most_bytes) {
    const std::size_t megabytes = (response.map.size() + 999999) / 1000000;
    response.map.clear();
    response.status =
        make_status(Status::FAILED, "The map takes " + std::to_string(megabytes) + " MB, and no more than " +
                                        std::to_string(most_bytes / 1000000) +
                                        " are sent; set map/resolution to a coarser one.");
    return;
  }
  const MapOptions options = options_of(map);
  response.resolution = *options.resolution;
  response.extra_levels = static_cast<std::uint8_t>(options.extra_levels);
  if (!options.region) return;
  const Box& region = *options.region;
  for (std::size_t i = 0; i < region.dimension; ++i) {
    response.lower.push_back(region.lower[i]);
    response.upper.push_back(region.upper[i]);
  }
}

SharedMechanism mechanism_of(const GetMap::Response& response) {
  return load_mechanism(response.urdf, "urdf of get_map", response.description, "description of get_map");
}

MapResult map_of(const GetMap::Response& response, const Mechanism& mechanism) {
  MapOptions options;
  options.resolution = response.resolution;
  options.extra_levels = response.extra_levels;
  if (response.lower.size() != response.upper.size() || response.lower.size() > max_map_dimension)
    return {MapStatus::refused, "The region of the map that was received is none.", nullptr};
  if (!response.lower.empty()) {
    options.region.emplace();
    options.region->dimension = response.lower.size();
    std::copy(response.lower.begin(), response.lower.end(), options.region->lower.begin());
    std::copy(response.upper.begin(), response.upper.end(), options.region->upper.begin());
  }
  return map_from_bytes(mechanism.mapped_manipulator(), options, response.map);
}

std::string aspect_table(const AspectMap& map) {
  const TaskSpace space = map.manipulator()->task_space();
  const std::string unit(measure_unit(space));
  char line[160];
  std::snprintf(line, sizeof line, "%7s  %-16s %-6s %14s  %s\n", "aspect", "working mode", "det A",
                ("size [" + unit + "]").c_str(), "deepest pose");
  std::string table = line;
  for (const Aspect& aspect : map.aspects()) {
    std::snprintf(line, sizeof line, "%7d  %-16s %-6s %14.5g  ", aspect.id, to_string(aspect.mode).c_str(),
                  aspect.determinant_sign > 0 ? "> 0" : "< 0", aspect.measure);
    table += line + to_string(space, aspect.deepest) + "\n";
  }
  return table;
}

}  // namespace parallel_aspects
