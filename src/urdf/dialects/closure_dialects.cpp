// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/dialects/closure_dialects.h"

#include "urdf/description/nearest_name.h"
#include "urdf/description/xml_values.h"

#include <algorithm>
#include <array>

namespace parallel_aspects {
namespace {

// The first link above, itself included, that a movable joint carries.
std::size_t carried_link(const Tree& tree, std::size_t link) {
  for (auto joint = tree.joint_above[link]; joint && tree.joints[*joint].motion == JointMotion::fixed;
       joint = tree.joint_above[link])
    link = tree.joints[*joint].parent;
  return link;
}

// Such elements also tell simulators to fix the base to the world.
bool closes_no_loop(const Tree& tree, const Closure& closure) {
  return carried_link(tree, closure.frames[0].link) == carried_link(tree, closure.frames[1].link);
}

// Robots are closed with fixed joints that could not move otherwise.
void take_as_weld(Closure& closure) {
  const bool rigid = closure.type == ClosureType::fixed;
  if (!rigid) closure.weld = Weld::none;
  if (rigid && closure.weld == Weld::none) closure.weld = Weld::at_frames;
  if (rigid) closure.type = ClosureType::automatic;
}

}  // namespace

const std::vector<ClosureDialect>& closure_dialects() {
  static const std::vector<ClosureDialect> dialects{
      {"<gazebo><joint>", dialects::gazebo_joint},
      {"closing frames", dialects::closing_frames},
      {"closed_loop", dialects::gepetto_file},
      {"loop_closures.yaml", dialects::loop_closures_file},
      {"<constraint>", dialects::constraint_element},
      {"DetachableJoint", dialects::detachable_joint},
      {"<loop_joint>", dialects::loop_joint},
      {"<drake:ball_constraint>", dialects::drake_ball_constraint},
      {"<equality>", dialects::equality},
      {"the SDF", dialects::sdf_joint},
  };
  return dialects;
}

FoundLoops find_described_loops(const LoopSource& source, Problems& problems) {
  for (const ClosureDialect& dialect : closure_dialects()) {
    const std::size_t before = problems.size();
    DescribedLoops loops = dialect.read(source, problems);
    loops.closures.erase(
        std::remove_if(loops.closures.begin(), loops.closures.end(),
                       [&](const Closure& closure) { return closes_no_loop(source.tree, closure); }),
        loops.closures.end());
    std::for_each(loops.closures.begin(), loops.closures.end(), take_as_weld);
    if (!loops.closures.empty() || problems.size() > before) return {dialect.name, loops};
  }
  return {};
}

std::optional<std::size_t> described_link(const LoopSource& source, const std::string& name,
                                          const std::string& where, Problems& problems) {
  // Simulators write MODEL::LINK.
  const auto scope = name.rfind("::");
  const std::string link = scope == std::string::npos ? name : name.substr(scope + 2);
  const auto found = source.tree.link_named(link);
  if (!found)
    problems.push_back(where + " names link '" + link + "', but " + source.files.urdf + " has no such link" +
                       suggestion(link, source.tree.links, problems));
  return found;
}

std::optional<ClosureType> described_type(std::string name) noexcept {
  const std::string suffix = "_joint";
  if (name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
    name.resize(name.size() - suffix.size());
  constexpr std::array<std::pair<std::string_view, ClosureType>, 9> known{
      {{"revolute", ClosureType::revolute},
       {"continuous", ClosureType::revolute},
       {"hinge", ClosureType::revolute},
       {"ball", ClosureType::point},
       {"spherical", ClosureType::point},
       {"point", ClosureType::point},
       {"universal", ClosureType::universal},
       {"fixed", ClosureType::fixed},
       {"weld", ClosureType::fixed}}};
  for (const auto& [word, type] : known)
    if (word == name) return type;
  return std::nullopt;
}

Poses poses_at_zero(const Tree& tree) { return link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables())); }

Closure closed_at_zero(const Poses& poses, const std::string& name, std::size_t parent,
                       const LinkFrame& child, ClosureType type) {
  const LinkFrame in_parent{parent, poses[parent].inverse() * poses[child.link] * child.in_link};
  return {name, {in_parent, child}, type, Weld::none, Eigen::Isometry3d::Identity()};
}

namespace {

using tinyxml2::XMLElement;

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// Encoders have transmissions too, that only carry their state.
bool only_reports(const XMLElement& joint) {
  bool reports = false;
  for (const auto* interface = joint.FirstChildElement("hardwareInterface"); interface != nullptr;
       interface = interface->NextSiblingElement("hardwareInterface")) {
    const std::string name = interface->GetText() != nullptr ? interface->GetText() : "";
    if (name.find("JointStateInterface") == std::string::npos) return false;
    reports = true;
  }
  return reports;
}

// ros2_control copies the commands of another joint to one that mimics it.
bool mimics(const XMLElement& joint) {
  for (const auto* parameter = joint.FirstChildElement("param"); parameter != nullptr;
       parameter = parameter->NextSiblingElement("param"))
    if (attribute(parameter, "name") == "mimic") return true;
  return joint.Attribute("mimic") != nullptr && attribute(&joint, "mimic") != "false";
}

// The joints in elements of one kind that `selects` takes, in the order of the file.
template <class Selects>
std::vector<std::string> joints_in(const LoopSource& source, const char* kind, const Selects& selects) {
  std::vector<std::string> joints;
  for (const auto* element = source.robot.FirstChildElement(kind); element != nullptr;
       element = element->NextSiblingElement(kind))
    for (const auto* joint = element->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      if (selects(*joint)) add_once(attribute(joint, "name"), joints);
  return joints;
}

}  // namespace

DescribedActuation described_actuation(const LoopSource& source) {
  std::vector<std::string> driven;
  for (const auto* driver = source.robot.FirstChildElement("actuated_joint"); driver != nullptr;
       driver = driver->NextSiblingElement("actuated_joint"))
    add_once(attribute(driver, "name"), driven);
  if (!driven.empty()) return {"motor in <actuator>", driven};
  const auto commanded = joints_in(source, "ros2_control", [](const XMLElement& joint) {
    return joint.FirstChildElement("command_interface") != nullptr && !mimics(joint);
  });
  if (!commanded.empty()) return {"command interface of <ros2_control>", commanded};
  const auto transmitted =
      joints_in(source, "transmission", [](const XMLElement& joint) { return !only_reports(joint); });
  return {"<transmission>", transmitted};
}

}  // namespace parallel_aspects

namespace parallel_aspects::dialects {
namespace {

// X of `closing_X_1` and `closing_X_A`, with what comes before it; empty for any other name.
std::string closing_pair(const std::string& link) {
  const std::string start = "closing_";
  const std::size_t length = link.size() - std::min<std::size_t>(link.size(), 2);
  const std::string end = link.substr(length);
  const bool is_first = end == "_1" || end == "_A";
  return is_first && length > start.size() && link.compare(0, start.size(), start) == 0
             ? link.substr(0, length)
             : std::string();
}

}  // namespace

DescribedLoops closing_frames(const LoopSource& source, Problems& problems) {
  DescribedLoops loops;
  for (std::size_t link = 0; link < source.tree.links.size(); ++link) {
    const std::string& name = source.tree.links[link];
    const std::string pair = closing_pair(name);
    if (pair.empty()) continue;
    const std::string other = pair + (name.back() == '1' ? "_2" : "_B");
    const auto found = source.tree.link_named(other);
    if (found) {
      loops.closures.push_back({pair, {LinkFrame{link}, LinkFrame{*found}}, ClosureType::automatic});
    } else {
      problems.push_back(source.files.urdf + " has the closing frame '" + name + "' but no '" + other +
                         "'; add it, or list the closures in " + source.files.config + ".");
    }
  }
  return loops;
}

}  // namespace parallel_aspects::dialects
