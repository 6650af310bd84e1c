// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/urdf/closure_dialects.h"

namespace parallel_aspects::dialects {
namespace {

std::string scalar(const YAML::Node& node) {
  return node.IsDefined() && node.IsScalar() ? node.Scalar() : "";
}

// A frame by the name of its link, or of the joint that the link hangs on.
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

std::vector<std::string> joints_named_like(const LoopSource& source, const std::string& part) {
  std::vector<std::string> joints;
  for (const std::size_t joint : source.tree.movable)
    if (source.tree.joints[joint].name.find(part) != std::string::npos)
      joints.push_back(source.tree.joints[joint].name);
  return joints;
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
  const std::string part = scalar(source.config["name_mot"]);
  if (!part.empty()) loops.driven_joints = joints_named_like(source, part);
  return loops;
}

}  // namespace parallel_aspects::dialects
