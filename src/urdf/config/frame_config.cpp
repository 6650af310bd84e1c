// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/config/frame_config.h"

#include <yaml-cpp/yaml.h>

#include <vector>

namespace parallel_aspects {
namespace {

bool read_vector(const YamlValues& yaml, const YAML::Node& node, const std::string& where,
                 Eigen::Vector3d& vector) {
  std::vector<double> values;
  if (!node.IsDefined()) return true;
  if (!yaml.numbers(node, where, values)) return false;
  if (values.size() != 3) {
    yaml.problem("has " + std::to_string(values.size()) + " numbers in " + where + "; give three.");
    return false;
  }
  vector = Eigen::Vector3d(values[0], values[1], values[2]);
  return true;
}

}  // namespace

bool read_frame(const YamlValues& yaml, const YAML::Node& node, const std::string& where,
                ConfiguredFrame& frame) {
  if (!node.IsDefined() || !node.IsMap()) return yaml.text(node, where, frame.link);
  yaml.check_keys(node, {"link", "xyz", "rpy", "name"}, where);
  frame.is_link = false;
  if (!node["link"].IsDefined()) {
    yaml.problem("does not say " + where + ".link; name the link that the frame is fixed to.");
    return false;
  }
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero(), rpy = Eigen::Vector3d::Zero();
  bool good = yaml.text(node["link"], where + ".link", frame.link);
  good = read_vector(yaml, node["xyz"], where + ".xyz", xyz) && good;
  good = read_vector(yaml, node["rpy"], where + ".rpy", rpy) && good;
  if (node["name"].IsDefined()) good = yaml.text(node["name"], where + ".name", frame.name) && good;
  frame.in_link = Eigen::Translation3d(xyz) * Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
  return good;
}

}  // namespace parallel_aspects
