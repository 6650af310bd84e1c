// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/urdf/closure_dialects.h"
#include "parallel_aspects/urdf/xml_values.h"

namespace parallel_aspects::dialects {
namespace {

using tinyxml2::XMLElement;

std::optional<LinkFrame> end_of(const LoopSource& source, const XMLElement* end, const std::string& where,
                                Problems& problems) {
  const auto link = described_link(source, attribute(end, "link"), where, problems);
  const auto frame = frame_of(attribute(end, "xyz"), attribute(end, "rpy"));
  if (!frame)
    problems.push_back(
        where + " has an xyz or rpy that is not three finite numbers; write three, separated by blanks.");
  if (!link || !frame) return std::nullopt;
  return LinkFrame{*link, *frame};
}

// Stated, or told by an axis; else unsaid.
std::optional<ClosureType> type_of(const XMLElement& joint) {
  const std::string type = attribute(&joint, "type");
  if (!type.empty()) return described_type(type);
  return joint.FirstChildElement("axis") != nullptr ? ClosureType::revolute : ClosureType::automatic;
}

}  // namespace

DescribedLoops loop_joint(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (const auto* joint = source.robot.FirstChildElement("loop_joint"); joint != nullptr;
       joint = joint->NextSiblingElement("loop_joint")) {
    const std::string name = attribute(joint, "name");
    const std::string where = source.files.urdf + " has a <loop_joint> '" + name + "' that";
    auto one = end_of(source, joint->FirstChildElement("link1"), where, problems);
    auto other = end_of(source, joint->FirstChildElement("link2"), where, problems);
    const auto type = type_of(*joint);
    const auto axis = vector_or(attribute(joint->FirstChildElement("axis"), "xyz"), Eigen::Vector3d::UnitZ());
    if (!type || !axis || axis->norm() < 1e-9)
      problems.push_back(
          where +
          " has a type or an axis that cannot close a loop; use spherical, revolute, universal or "
          "fixed, and an axis of three numbers.");
    if (!one || !other || !type || !axis || axis->norm() < 1e-9) continue;
    if (*type == ClosureType::revolute)
      for (LinkFrame* end : {&*one, &*other}) end->in_link.rotate(axes_with_z(*axis));
    loops.closures.push_back({name, {*one, *other}, *type});
  }
  return loops;
}

}  // namespace parallel_aspects::dialects
