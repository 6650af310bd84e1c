// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/xml_values.h"
#include "urdf/dialects/closure_dialects.h"

#include <algorithm>

namespace parallel_aspects {
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
  const auto commanded = joints_in(source, "ros2_control", [](const XMLElement& joint) {
    return joint.FirstChildElement("command_interface") != nullptr && !mimics(joint);
  });
  if (!commanded.empty()) return {"command interface of <ros2_control>", commanded};
  const auto transmitted =
      joints_in(source, "transmission", [](const XMLElement& joint) { return !only_reports(joint); });
  return {"<transmission>", transmitted};
}

}  // namespace parallel_aspects
