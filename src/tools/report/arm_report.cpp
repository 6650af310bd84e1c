// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/arm_report.h"

#include "tools/report/report.h"

namespace parallel_aspects::tools {
namespace {

std::string values_text(const ask::NamedValues& values) {
  std::string text;
  for (const auto& [name, value] : values) text += (text.empty() ? "" : ", ") + name + " " + shown(value);
  return text;
}

std::string signs_text(const std::vector<int>& signs) {
  std::string text;
  for (const int sign : signs) text += (text.empty() ? "" : ",") + std::string(sign > 0 ? "+" : "-");
  return "(" + text + ")";
}

std::string count_text(const ask::ArmMapAnswer& answer) {
  const std::string proved = std::to_string(answer.proved_count);
  if (answer.count_at_most == answer.proved_count) return proved + ", proved";
  return "at least " + proved +
         (answer.count_at_most ? ", at most " + std::to_string(*answer.count_at_most) : "") + ", proved";
}

std::string place_sign(const ask::ArmPlace& place) {
  return place.sign == 0 ? "not proved" : place.sign > 0 ? "+" : "-";
}

}  // namespace

std::string arm_text(const ask::ArmSession& /*session*/, const ask::ArmDescribed& answer) {
  std::string text = answer.mechanism + ": a serial arm from '" + answer.base_link + "' to '" +
                     answer.tip_link + "'\ntask " + answer.task + ":";
  for (const std::string& each : answer.coordinates) text += " " + each;
  text += "\n\n";
  TextTable joints({"joint", "kind", "limits"});
  for (const ask::DescribedArmJoint& joint : answer.joints)
    joints.add({joint.name, joint.kind,
                joint.limits.limited()
                    ? "[" + shown(joint.limits.lower) + ", " + shown(joint.limits.upper) + "] " + joint.unit +
                          (joint.turns_freely ? ", a full turn: none" : "")
                    : "none"});
  text += joints.text() + "\nfactors of det J, exactly but for a constant:\n";
  for (const ask::DescribedFactor& factor : answer.factors) text += "  " + factor.text + "\n";
  if (answer.factors.empty()) text += "  none: det J is constant\n";
  text += "\ninverse solutions: " + answer.method + "\n";
  for (const std::string& note : answer.notes) text += "note: " + note + "\n";
  return text;
}

std::string arm_text(const ask::ArmSession& /*session*/, const ask::ArmMapAnswer& answer) {
  std::string text = answer.mechanism + ", aspects in the space of";
  for (const std::string& each : answer.mapped_joints) text += " " + each;
  TextTable table({">aspect", "det J", "factors", ">measure [" + answer.unit + "]", "joint values in it"});
  for (const ask::ArmAspect& each : answer.aspects)
    table.add({std::to_string(each.id), each.sign > 0 ? "+" : "-", signs_text(each.factor_signs),
               shown_briefly(each.measure), values_text(each.witness)});
  return text + "\n\n" + table.text() + "\naspects: " + count_text(answer) + "\n";
}

std::string arm_text(const ask::ArmSession& session, const ask::ArmPlace& answer) {
  return session.arm().name() + " at " + values_text(answer.joints) +
         "\noperational point: " + values_text(answer.coordinates) + "\ndet J " + shown(answer.determinant) +
         ", sign " + place_sign(answer) +
         (answer.factor_signs.empty() ? "" : ", factors " + signs_text(answer.factor_signs)) +
         (answer.aspect ? "\naspect " + std::to_string(*answer.aspect) : "") +
         (answer.within_limits ? "" : "\nnote: outside joint limits") + "\n";
}

std::string arm_text(const ask::ArmSession& session, const ask::ArmInverseAnswer& answer) {
  TextTable table({"joint values", ">det J", "sign", "factors", ""});
  for (const ask::ArmPlace& each : answer.solutions)
    table.add({values_text(each.joints), shown(each.determinant), place_sign(each),
               each.factor_signs.empty() ? "-" : signs_text(each.factor_signs),
               each.within_limits ? "" : "outside joint limits"});
  return session.arm().name() + ": " + counted(answer.solutions.size(), "inverse solution") +
         (answer.complete ? ", all: " : ", perhaps not all: ") + answer.reason + "\n\n" + table.text();
}

std::string arm_text(const ask::ArmSession& session, const ask::ArmConnectAnswer& answer) {
  std::string text =
      session.arm().name() + ", same aspect: " + name(answer.same_aspect) + "\n" + answer.reason + "\n";
  for (const ask::NamedValues& each : answer.path) text += "  " + values_text(each) + "\n";
  return text;
}

std::string arm_text(const ask::ArmSession& session, const ask::ArmUniquenessAnswer& answer) {
  std::string text =
      session.arm().name() + ", cuspidal: " + name(answer.cuspidal) + "\n" + answer.reason + "\n";
  for (const ask::NamedValues& each : answer.solutions) text += "  " + values_text(each) + "\n";
  if (!answer.cusps) return text;
  text += "\n" + counted(answer.cusps->size(), "cusp") +
          (answer.cusps_complete ? ", all" : ", perhaps not all") + "\n";
  if (answer.cusps->empty()) return text;
  TextTable table({">rho [m]", ">z [m]", "joints"});
  for (const ask::DescribedCusp& each : *answer.cusps)
    table.add({shown(each.rho), shown(each.z), values_text(each.joints)});
  return text + table.text();
}

}  // namespace parallel_aspects::tools
