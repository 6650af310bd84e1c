// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/xml_values.h"
#include "urdf/dialects/closure_dialects.h"

namespace parallel_aspects::dialects {
namespace {

using tinyxml2::XMLElement;

// The frame of one side: z along its axis, or x along it where it is the second axis of a universal joint.
std::optional<LinkFrame> side(const LoopSource& source, const XMLElement& constraint, const std::string& name,
                              bool second_axis, const std::string& where, Problems& problems) {
  const auto link =
      described_link(source, attribute(constraint.FirstChildElement(name.c_str()), "link"), where, problems);
  const auto* origin = constraint.FirstChildElement((name + "_origin").c_str());
  const auto frame = frame_of(attribute(origin, "xyz"), attribute(origin, "rpy"));
  const auto* stated = constraint.FirstChildElement((name + "_axis").c_str());
  const auto axis = vector_or(attribute(stated, "xyz"), Eigen::Vector3d::UnitZ());
  if (!frame || !axis || axis->norm() < 1e-9)
    problems.push_back(where + " has a " + name + "_origin or " + name +
                       "_axis that is not three finite numbers, or zero; write three, separated by blanks.");
  if (!link || !frame || !axis || axis->norm() < 1e-9) return std::nullopt;
  LinkFrame result{*link, *frame};
  result.in_link.rotate(axes_with_z(*axis));
  if (second_axis) result.in_link.rotate(axes_with_z(Eigen::Vector3d::UnitX()).transpose());
  return result;
}

}  // namespace

DescribedLoops constraint_element(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (const auto* constraint = source.robot.FirstChildElement("constraint"); constraint != nullptr;
       constraint = constraint->NextSiblingElement("constraint")) {
    const std::string name = attribute(constraint, "name");
    const std::string where = source.files.urdf + " has a <constraint> '" + name + "' that";
    const auto type = described_type(attribute(constraint, "type"));
    if (!type)
      problems.push_back(
          where + " has the type '" + attribute(constraint, "type") +
          "', which cannot close a loop; use spherical_joint, revolute_joint, universal_joint or "
          "fixed_joint.");
    const auto parent = side(source, *constraint, "parent", false, where, problems);
    const auto child = side(source, *constraint, "child", type == ClosureType::universal, where, problems);
    if (parent && child && type) loops.closures.push_back({name, {*parent, *child}, *type});
  }
  return loops;
}

}  // namespace parallel_aspects::dialects
