// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/urdf/closure_dialects.h"
#include "parallel_aspects/urdf/xml_values.h"

namespace parallel_aspects::dialects {
namespace {

using tinyxml2::XMLElement;

// Position and fixed-axis angles in one text, as SDF writes a pose.
std::optional<Eigen::Isometry3d> pose_of(const XMLElement& joint) {
  const auto values = numbers(child_text(joint, "pose"));
  if (values && values->empty()) return Eigen::Isometry3d::Identity();
  if (!values || values->size() != 6) return std::nullopt;
  const auto& v = *values;
  return Eigen::Translation3d(v[0], v[1], v[2]) * Eigen::AngleAxisd(v[5], Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(v[4], Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(v[3], Eigen::Vector3d::UnitX());
}

std::optional<Eigen::Vector3d> axis_of(const XMLElement& joint, const char* name) {
  const auto* axis = joint.FirstChildElement(name);
  const Eigen::Vector3d otherwise = Eigen::Vector3d::UnitZ();
  const auto found = axis != nullptr ? vector_or(child_text(*axis, "xyz"), otherwise) : otherwise;
  if (!found || found->norm() < 1e-9) return std::nullopt;
  return found;
}

void read_joint(const LoopSource& source, const XMLElement& joint, std::vector<Closure>& closures,
                Problems& problems) {
  const std::string name = attribute(&joint, "name");
  const std::string where = source.files.urdf + " has a <gazebo> joint '" + name + "' that";
  const auto parent = described_link(source, child_text(joint, "parent"), where, problems);
  const auto child = described_link(source, child_text(joint, "child"), where, problems);
  const auto type = described_type(attribute(&joint, "type"));
  const auto pose = pose_of(joint);
  const auto axis = axis_of(joint, "axis"), second = axis_of(joint, "axis2");
  if (!type)
    problems.push_back(where + " has the type '" + attribute(&joint, "type") +
                       "', which cannot close a loop; use revolute, ball, universal or fixed.");
  if (!pose || !axis || !second)
    problems.push_back(where +
                       " has a pose or an axis that is not a list of finite numbers; give six for the pose, "
                       "three for an axis.");
  if (!parent || !child || !type || !pose || !axis || !second) return;
  LinkFrame frame{*child, *pose};
  frame.in_link.rotate(axes_with_z(*axis));
  Closure closure = closed_at_zero(source.tree, name, *parent, frame, *type);
  // A universal closure keeps z of the first frame orthogonal to x of the second.
  if (*type == ClosureType::universal) {
    frame.in_link.linear() =
        pose->linear() * axes_with_z(*second) * axes_with_z(Eigen::Vector3d::UnitX()).transpose();
    closure.frames[1] = frame;
  }
  closures.push_back(closure);
}

}  // namespace

DescribedLoops gazebo_joint(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (const auto* gazebo = source.robot.FirstChildElement("gazebo"); gazebo != nullptr;
       gazebo = gazebo->NextSiblingElement("gazebo"))
    for (const auto* joint = gazebo->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      read_joint(source, *joint, loops.closures, problems);
  return loops;
}

}  // namespace parallel_aspects::dialects
