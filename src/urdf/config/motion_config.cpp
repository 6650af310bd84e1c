// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/config/motion_config.h"

#include "urdf/description/yaml_document.h"
#include "urdf/description/yaml_values.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <vector>

namespace parallel_aspects {
namespace {

MotionConfig read(const YAML::Node& node, const std::string& file, std::size_t joints, Problems& problems) {
  const YamlValues yaml(file, problems);
  MotionConfig config;
  if (node.IsNull() || !yaml.map(node, "motion", "write acceleration under it")) return config;
  yaml.check_keys(node, {"acceleration"}, "motion");
  std::vector<double> values;
  if (!yaml.numbers(node["acceleration"], "motion.acceleration", values)) return config;
  bool good = values.size() == joints;
  for (const double value : values) good = good && std::isfinite(value) && value > 0.0;
  if (good)
    config.acceleration = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(joints));
  else
    yaml.problem("has a motion.acceleration that is not a list of " + std::to_string(joints) +
                 " positive numbers; give one for each actuated joint, in rad/s^2 or m/s^2.");
  return config;
}

}  // namespace

MotionConfig read_motion_config(const std::string& text, const std::string& file, std::size_t joints,
                                Problems& problems) {
  try {
    const YAML::Node root = yaml_document(text);
    if (!root.IsMap() || !root["motion"].IsDefined()) return {};
    return read(root["motion"], file, joints, problems);
  } catch (const YAML::Exception&) {
    return {};
  }
}

}  // namespace parallel_aspects
