// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/actuation_notes.h"

#include "urdf/description/xml_values.h"

#include <tinyxml2.h>

#include <algorithm>

namespace parallel_aspects {
namespace {

bool has(const std::vector<std::size_t>& variables, std::size_t variable) {
  return std::find(variables.begin(), variables.end(), variable) != variables.end();
}

const GraphPart* leg_with(const TakenActuation& taken, std::size_t variable) {
  for (const GraphPart& leg : taken.legs)
    if (has(leg.variables, variable)) return &leg;
  return nullptr;
}

std::string quoted(const Tree& tree, std::size_t variable) {
  return "'" + tree.joint_of(variable).name + "'";
}

std::string reason_to_leave_out(const TakenActuation& taken, std::size_t variable) {
  if (taken.tree.joint_of(variable).mimics)
    return "which mimics another joint; if it is actuated, take out its <mimic>";
  if (!taken.in_loop[variable]) return "which is in no loop";
  if (const GraphPart* leg = leg_with(taken, variable))
    for (const std::size_t other : leg->variables)
      if (has(taken.variables, other))
        return "whose leg has one actuated joint and " + quoted(taken.tree, other) + " is taken";
  return "which is in no leg that these actuate";
}

}  // namespace

std::optional<std::string> note_on_stated(const TakenActuation& taken, const std::string& urdf_name) {
  const std::vector<bool>& stated = taken.evidence.stated;
  std::string left_out, instead;
  for (std::size_t joint = 0; joint < stated.size(); ++joint)
    if (stated[joint] && !has(taken.variables, joint))
      left_out += (left_out.empty() ? "" : ", and of ") + quoted(taken.tree, joint) + ", " +
                  reason_to_leave_out(taken, joint);
  if (left_out.empty()) return std::nullopt;
  for (const std::size_t joint : taken.variables)
    if (!stated[joint]) instead += (instead.empty() ? "" : ", ") + quoted(taken.tree, joint);
  return urdf_name + " has a " + taken.evidence.stated_in + " of joints that are not taken as actuated: of " +
         left_out + (instead.empty() ? "." : "; taken without one: " + instead + ".");
}

std::optional<ActuationCandidate> ruled_out_by_mimic(const TakenActuation& taken) {
  const auto may_drive = actuation_candidates(taken.tree, taken.legs, taken.evidence, true);
  const auto mimics = [&](std::size_t joint) { return taken.tree.joint_of(joint).mimics; };
  int weight = 0;
  for (const ActuationCandidate& candidate : may_drive)
    if (candidate.variables == taken.variables) weight = candidate.weight;
  for (const ActuationCandidate& candidate : may_drive)
    if (candidate.weight > weight &&
        std::any_of(candidate.variables.begin(), candidate.variables.end(), mimics))
      return candidate;
  return std::nullopt;
}

std::string note_on_mimic(const Tree& tree, const ActuationCandidate& ruled_out,
                          const std::string& urdf_name) {
  std::string followers, all;
  for (const std::size_t joint : ruled_out.variables) {
    all += (all.empty() ? "" : ", ") + quoted(tree, joint);
    if (tree.joint_of(joint).mimics) followers += (followers.empty() ? "" : ", ") + quoted(tree, joint);
  }
  return urdf_name + " lets joints mimic others, " + followers +
         ", which are not taken as actuated for that alone; if " + all +
         " are the actuated joints, take out the <mimic> of these.";
}

std::string without_mimic(const std::string& urdf_text, const Tree& tree,
                          const std::vector<std::size_t>& variables) {
  tinyxml2::XMLDocument document;
  document.Parse(urdf_text.data(), urdf_text.size());
  for (auto* joint = document.RootElement()->FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint"))
    for (const std::size_t variable : variables)
      if (attribute(joint, "name") == tree.joint_of(variable).name)
        if (auto* mimic = joint->FirstChildElement("mimic")) joint->DeleteChild(mimic);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace parallel_aspects
