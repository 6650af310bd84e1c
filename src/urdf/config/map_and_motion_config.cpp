// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/config/map_and_motion_config.h"

#include "parallel_aspects/model/manipulator.h"
#include "urdf/description/yaml_values.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace parallel_aspects {
namespace {

class MapReader {
 public:
  MapReader(const std::string& file, Problems& problems) : yaml_(file, problems) {}

  MapConfig read(const YAML::Node& node) {
    MapConfig config;
    if (node.IsNull() ||
        !yaml_.map(node, "map", "write resolution, region, threads or extra_levels under it"))
      return config;
    // The file that a map is kept in is for the node.
    yaml_.check_keys(node, {"resolution", "region", "threads", "extra_levels", "file"}, "map");
    read_resolution(node["resolution"], config);
    if (const auto threads = whole_number(node["threads"], "map.threads", 1024))
      config.threads = static_cast<unsigned>(*threads);
    config.extra_levels = whole_number(node["extra_levels"], "map.extra_levels", 20);
    read_region(node["region"], config);
    return config;
  }

 private:
  void read_resolution(const YAML::Node& node, MapConfig& config) {
    double value = 0.0;
    if (!yaml_.number(node, "map.resolution", value)) return;
    if (value > 0.0)
      config.resolution = value;
    else
      yaml_.problem("has a map.resolution that is not positive; give one in m or rad, or leave it out.");
  }

  std::optional<int> whole_number(const YAML::Node& node, const std::string& where, int largest) {
    double value = 0.0;
    if (!yaml_.number(node, where, value)) return std::nullopt;
    if (value == std::floor(value) && value >= 0.0 && value <= largest) return static_cast<int>(value);
    yaml_.problem("has a " + where + " that is no whole number from 0 to " + std::to_string(largest) +
                  "; give one.");
    return std::nullopt;
  }

  void read_region(const YAML::Node& node, MapConfig& config) {
    if (!yaml_.map(node, "map.region", "write lower and upper under it")) return;
    yaml_.check_keys(node, {"lower", "upper"}, "map.region");
    std::array<std::vector<double>, 2> corners;
    bool good = true;
    for (std::size_t end = 0; end < 2; ++end) {
      const std::string key = end == 0 ? "lower" : "upper", where = "map.region." + key;
      if (!node[key].IsDefined()) yaml_.problem("does not say " + where + "; give the corner in m.");
      good = yaml_.numbers(node[key], where, corners[end]) && good;
    }
    if (good) config.region = corners;
  }

  YamlValues yaml_;
};

/// The box between two corners of equally many numbers; nothing where one is not below the other.
std::optional<Box> box_between(const std::vector<double>& lower, const std::vector<double>& upper) {
  Box box{lower.size(), {}, {}};
  std::copy(lower.begin(), lower.end(), box.lower.begin());
  std::copy(upper.begin(), upper.end(), box.upper.begin());
  for (std::size_t i = 0; i < box.dimension; ++i)
    if (!(box.lower[i] < box.upper[i])) return std::nullopt;
  return box;
}

}  // namespace

MapConfig read_map_config(const std::string& text, const std::string& file, Problems& problems) {
  try {
    const YAML::Node root = yaml_document(text);
    if (!root.IsMap() || !root["map"].IsDefined()) return {};
    return MapReader(file, problems).read(root["map"]);
  } catch (const YAML::Exception&) {
    return {};
  }
}

std::optional<Box> resolve_region(const MapConfig& config, TaskSpace space, const std::string& file,
                                  Problems& problems) {
  if (!config.region) return std::nullopt;
  const auto& [lower, upper] = *config.region;
  const std::size_t count = directions(space);
  if (count == 0) {
    problems.push_back(file +
                       " has a map.region, but every orientation of a robot in SO3 is searched; "
                       "leave it out.");
    return std::nullopt;
  }
  if (lower.size() != count || upper.size() != count) {
    problems.push_back(file + " has a map.region with " + std::to_string(lower.size()) + " and " +
                       std::to_string(upper.size()) + " numbers; give " + std::to_string(count) +
                       " in lower and in upper, one a direction that the platform moves in.");
    return std::nullopt;
  }
  const std::optional<Box> box = box_between(lower, upper);
  if (!box)
    problems.push_back(file +
                       " has a map.region of which some number of lower is not below that of upper; correct "
                       "it.");
  return box;
}

namespace {

JointVector acceleration_of(const YAML::Node& node, const std::string& file, std::size_t joints,
                            Problems& problems) {
  const YamlValues yaml(file, problems);
  if (node.IsNull() || !yaml.map(node, "motion", "write acceleration under it")) return {};
  yaml.check_keys(node, {"acceleration"}, "motion");
  std::vector<double> values;
  if (!yaml.numbers(node["acceleration"], "motion.acceleration", values)) return {};
  bool good = values.size() == joints;
  for (const double value : values) good = good && std::isfinite(value) && value > 0.0;
  if (good) return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(joints));
  yaml.problem("has a motion.acceleration that is not a list of " + std::to_string(joints) +
               " positive numbers; give one for each actuated joint, in rad/s^2 or m/s^2.");
  return {};
}

}  // namespace

JointVector read_acceleration(const std::string& text, const std::string& file, std::size_t joints,
                              Problems& problems) {
  try {
    const YAML::Node root = yaml_document(text);
    if (!root.IsMap() || !root["motion"].IsDefined()) return {};
    return acceleration_of(root["motion"], file, joints, problems);
  } catch (const YAML::Exception&) {
    return {};
  }
}

}  // namespace parallel_aspects
