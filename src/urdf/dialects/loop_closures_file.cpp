// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/config/mechanism_config.h"
#include "urdf/description/xml_values.h"
#include "urdf/dialects/closure_dialects.h"

#include <algorithm>

namespace parallel_aspects::dialects {
namespace {

constexpr double least_axis = 1e-9;  // shorter ones have no direction

// Nothing where the key is missing or has no three numbers.
std::optional<Eigen::Vector3d> vector_at(const YAML::Node& node, const char* key) {
  const YAML::Node values = node[key];
  if (!values.IsDefined() || !values.IsSequence() || values.size() != 3) return std::nullopt;
  std::string text;
  for (const YAML::Node& value : values) {
    if (!value.IsScalar() || value.Scalar().find(' ') != std::string::npos) return std::nullopt;
    text += value.Scalar() + " ";
  }
  const auto read = numbers(text.substr(0, text.size() - 1));
  if (!read || read->size() != 3) return std::nullopt;
  return Eigen::Vector3d((*read)[0], (*read)[1], (*read)[2]);
}

std::string text_at(const YAML::Node& node, const char* key) {
  const YAML::Node value = node[key];
  return value.IsDefined() && value.IsScalar() ? value.Scalar() : "";
}

std::vector<std::string> names_at(const YAML::Node& node, const char* key) {
  std::vector<std::string> names;
  const YAML::Node values = node[key];
  if (values.IsDefined() && values.IsSequence())
    for (const YAML::Node& value : values)
      if (value.IsScalar()) names.push_back(value.Scalar());
  return names;
}

void read_closure(const LoopSource& source, const YAML::Node& node, const std::string& key,
                  const Poses& poses, std::vector<Closure>& closures, Problems& problems) {
  const std::string where = source.files.config + " in " + key;
  if (!node.IsMap()) {
    problems.push_back(where +
                       " is no map; write {link_a: LINK, link_b: LINK, point: [x, y, z], axis: [x, y, z]}.");
    return;
  }
  const std::string names[2]{text_at(node, "link_a"), text_at(node, "link_b")};
  const auto one = described_link(source, names[0], where, problems),
             other = described_link(source, names[1], where, problems);
  const auto point = vector_at(node, "point"), axis = vector_at(node, "axis");
  const bool has_axis = node["axis"].IsDefined();
  if (!point || (has_axis && (!axis || axis->norm() < least_axis)))
    problems.push_back(where +
                       " has a point or an axis that is not three finite numbers, or zero; write three "
                       "each, in the frame of the root link while all joints are zero.");
  if (!one || !other || !point || (has_axis && !axis)) return;
  Eigen::Isometry3d frame(Eigen::Translation3d{*point});
  if (axis) frame.rotate(axes_with_z(*axis));
  closures.push_back(closed_at_zero(poses, names[0] + " - " + names[1], *one,
                                    LinkFrame{*other, poses[*other].inverse() * frame},
                                    axis ? ClosureType::revolute : ClosureType::point));
}

}  // namespace

DescribedLoops loop_closures_file(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  loops.actuated_joints_key = "independent";
  if (!is_loop_closures_file(source.config)) return loops;
  const YAML::Node closures = source.config["closures"];
  const Poses poses = poses_at_zero(source.tree);
  for (std::size_t k = 0; k < closures.size(); ++k)
    read_closure(source, closures[k], "closures[" + std::to_string(k) + "]", poses, loops.closures, problems);
  loops.actuated_joints = names_at(source.config, "independent");
  const std::vector<std::string> dependent = names_at(source.config, "dependent");
  if (!loops.actuated_joints.empty() || dependent.empty()) return loops;
  for (const std::size_t joint : source.tree.movable)
    if (std::find(dependent.begin(), dependent.end(), source.tree.joints[joint].name) == dependent.end())
      loops.actuated_joints.push_back(source.tree.joints[joint].name);
  return loops;
}

}  // namespace parallel_aspects::dialects
