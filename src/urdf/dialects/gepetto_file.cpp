// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/dialects/closure_dialects.h"

#include <unordered_set>

namespace parallel_aspects::dialects {
namespace {

std::string scalar(const YAML::Node& node) {
  return node.IsDefined() && node.IsScalar() ? node.Scalar() : "";
}

// A frame by the name of its link, or of the joint that the link is attached to.
std::optional<LinkFrame> frame_named(const LoopSource& source, const std::string& name, Problems& problems) {
  if (const auto joint = source.tree.joint_named(name)) return LinkFrame{source.tree.joints[*joint].child};
  const auto link = described_link(source, name, source.files.config + " in closed_loop", problems);
  if (!link) return std::nullopt;
  return LinkFrame{*link};
}

// One type for each closure, or one for all.
ClosureType type_of(const LoopSource& source, std::size_t index, Problems& problems) {
  const YAML::Node types = source.config["type"];
  if (!types.IsDefined()) return ClosureType::automatic;
  const std::string type =
      types.IsSequence() ? (index < types.size() ? scalar(types[index]) : "") : scalar(types);
  if (type == "3d" || type == "3D") return ClosureType::point;
  if (type == "6d" || type == "6D") return ClosureType::fixed;
  problems.push_back(source.files.config + " gives closed_loop[" + std::to_string(index) + "] the type '" +
                     type + "'; write 3d or 6d for each, or leave out the types.");
  return ClosureType::automatic;
}

// A joint of that name, or else every joint whose name contains it.
std::vector<std::string> joints_named(const LoopSource& source, const std::string& word) {
  if (source.tree.joint_named(word)) return {word};
  std::vector<std::string> joints;
  for (const std::size_t joint : source.tree.movable)
    if (!word.empty() && source.tree.joints[joint].name.find(word) != std::string::npos)
      joints.push_back(source.tree.joints[joint].name);
  return joints;
}

// `name_mot` is a list of names, or one text that the names contain.
std::vector<std::string> actuated_joints(const LoopSource& source, Problems& problems) {
  const YAML::Node motors = source.config["name_mot"];
  std::vector<std::string> words;
  if (motors.IsDefined() && motors.IsSequence())
    for (const YAML::Node& motor : motors) words.push_back(scalar(motor));
  else if (motors.IsDefined())
    words.push_back(scalar(motors));
  std::vector<std::string> joints;
  std::unordered_set<std::string> known, read;
  for (const std::string& word : words) {
    if (!read.insert(word).second) continue;
    const std::vector<std::string> named = joints_named(source, word);
    for (const std::string& joint : named)
      if (known.insert(joint).second) joints.push_back(joint);
    if (named.empty())
      problems.push_back(source.files.config + " has '" + word + "' in name_mot, but " + source.files.urdf +
                         " has no movable joint with that in its name; correct it, or list "
                         "mechanism.actuated_joints.");
  }
  return joints;
}

// The toolbox can put other joints in the place of those of the URDF.
void check_no_replaced_joints(const LoopSource& source, Problems& problems) {
  const YAML::Node names = source.config["joint_name"];
  if (!names.IsDefined() || !names.IsSequence()) return;
  for (const YAML::Node& name : names)
    problems.push_back(source.files.config + " replaces joint '" + scalar(name) +
                       "' by a joint of another type in joint_name, which is not read; write two or three "
                       "revolute joints in its place into " +
                       source.files.urdf + ".");
}

}  // namespace

DescribedLoops gepetto_file(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  const YAML::Node pairs = source.config.IsMap() ? source.config["closed_loop"] : YAML::Node();
  if (!pairs.IsDefined() || !source.config.IsMap()) return loops;
  if (!pairs.IsSequence())
    problems.push_back(source.files.config +
                       " has a closed_loop that is not a list; write one pair [frame, frame] for "
                       "each loop.");
  for (std::size_t k = 0; pairs.IsSequence() && k < pairs.size(); ++k) {
    if (!pairs[k].IsSequence() || pairs[k].size() != 2) {
      problems.push_back(source.files.config + " has a closed_loop[" + std::to_string(k) +
                         "] that is not a pair; name two links or joints.");
      continue;
    }
    const auto one = frame_named(source, scalar(pairs[k][0]), problems);
    const auto other = frame_named(source, scalar(pairs[k][1]), problems);
    const ClosureType type = type_of(source, k, problems);
    if (one && other)
      loops.closures.push_back({scalar(pairs[k][0]) + " - " + scalar(pairs[k][1]), {*one, *other}, type});
  }
  check_no_replaced_joints(source, problems);
  loops.actuated_joints = actuated_joints(source, problems);
  return loops;
}

}  // namespace parallel_aspects::dialects
