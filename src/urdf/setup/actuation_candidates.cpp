// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/actuation_candidates.h"

#include "urdf/closing/chain.h"
#include "urdf/description/messages.h"
#include "urdf/description/name_words.h"
#include "urdf/description/xml_values.h"

#include <tinyxml2.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

// The first two decide alone. The others are habits of those who write URDFs: all of them together, 45, stay
// below what decides.
constexpr int weight_stated_alone = 1000, weight_effort = 100, least_weight_that_decides = 50,
              weight_stated = 20, weight_name = 10, weight_passive = -10, weight_effort_by_habit = 5,
              weight_at_base = 3, weight_slide = 3, weight_usual = 4;

using Variables = std::vector<std::size_t>;

StatedEffort stated_effort(const tinyxml2::XMLElement* joint) {
  const auto effort = numbers(attribute(joint->FirstChildElement("limit"), "effort"));
  if (!effort || effort->size() != 1) return StatedEffort::none;
  if (!(effort->front() > 0.0)) return StatedEffort::zero;
  return attribute(joint, "type") == "continuous" ? StatedEffort::meant : StatedEffort::by_habit;
}

class Combiner {
 public:
  Combiner(const Tree& tree, const std::vector<GraphPart>& legs, const JointEvidence& evidence,
           bool with_followers)
      : tree_(tree), legs_(legs), evidence_(evidence), with_followers_(with_followers) {}

  std::vector<ActuationCandidate> find() {
    const auto stated = [&](std::size_t joint) { return evidence_.stated[joint]; };
    if (add(stated)) {
      stated_alone_ = combinations_.front();
      return weighed();
    }
    if (add([&](std::size_t joint) { return has_effort(joint); })) with_effort_ = combinations_.front();
    add([&](std::size_t joint) { return says_drive(tree_.joint_of(joint).name); });
    for (const GraphPart& leg : legs_) {
      for (const std::size_t joint : leg.variables) {
        const std::string role = role_of(tree_.joint_of(joint).name);
        add([&](std::size_t other) { return role_of(tree_.joint_of(other).name) == role; });
      }
      for (const std::size_t depth : leg.depths) add_at(depth);
    }
    add([&](std::size_t joint) { return is_usual(joint); });
    return weighed();
  }

 private:
  bool may_drive(std::size_t joint) const { return with_followers_ || !tree_.joint_of(joint).mimics; }

  bool has_effort(std::size_t joint) const {
    return evidence_.efforts[joint] == StatedEffort::by_habit ||
           evidence_.efforts[joint] == StatedEffort::meant;
  }

  // Whether those that alone have an effort were meant to: by these joints, or by a zero at all others.
  bool effort_is_meant() const {
    const bool by_these = std::all_of(with_effort_.begin(), with_effort_.end(), [&](std::size_t joint) {
      return evidence_.efforts[joint] == StatedEffort::meant;
    });
    return by_these || std::all_of(legs_.begin(), legs_.end(), [&](const GraphPart& leg) {
             return std::all_of(leg.variables.begin(), leg.variables.end(), [&](std::size_t joint) {
               return has_effort(joint) || evidence_.efforts[joint] == StatedEffort::zero;
             });
           });
  }

  // Where each leg has one joint that `selects` takes.
  template <class Selects>
  bool add(const Selects& selects) {
    Variables chosen;
    for (const GraphPart& leg : legs_) {
      Variables fit;
      for (const std::size_t joint : leg.variables)
        if (may_drive(joint) && selects(joint)) fit.push_back(joint);
      if (fit.size() != 1) return false;
      chosen.push_back(fit.front());
    }
    return add(chosen);
  }

  // Where each leg has one joint at this depth.
  void add_at(std::size_t depth) {
    Variables chosen;
    for (const GraphPart& leg : legs_) {
      Variables fit;
      for (std::size_t k = 0; k < leg.variables.size(); ++k)
        if (leg.depths[k] == depth && may_drive(leg.variables[k])) fit.push_back(leg.variables[k]);
      if (fit.size() != 1) return;
      chosen.push_back(fit.front());
    }
    add(chosen);
  }

  // A joint drives one leg; false only where there is none.
  bool add(const Variables& chosen) {
    if (chosen.empty()) return false;
    if (known_.insert(chosen).second) combinations_.push_back(chosen);
    return true;
  }

  template <class Holds>
  static bool all(const Variables& chosen, const Holds& holds) {
    return std::all_of(chosen.begin(), chosen.end(), holds);
  }

  bool at_base(std::size_t joint) const {
    return std::any_of(legs_.begin(), legs_.end(), [joint](const GraphPart& leg) {
      for (std::size_t k = 0; k < leg.variables.size(); ++k)
        if (leg.variables[k] == joint) return leg.depths[k] == 0;
      return false;
    });
  }

  bool is_slide(std::size_t joint) const { return tree_.joint_of(joint).motion == JointMotion::prismatic; }

  // The slide of a leg, and else what is next to the base.
  bool is_usual(std::size_t joint) const {
    return is_slide(joint) ||
           (at_base(joint) && std::none_of(legs_.begin(), legs_.end(), [&](const GraphPart& leg) {
              return std::count(leg.variables.begin(), leg.variables.end(), joint) > 0 &&
                     std::any_of(leg.variables.begin(), leg.variables.end(),
                                 [&](std::size_t other) { return is_slide(other); });
            }));
  }

  // By the evidence that every joint of the combination has.
  ActuationCandidate weighed(const Variables& chosen) const {
    ActuationCandidate candidate{chosen, 0, ""};
    const auto count = [&](bool holds, int weight, const std::string& reason) {
      if (!holds) return;
      candidate.weight += weight;
      if (weight > 0) candidate.reason += (candidate.reason.empty() ? "" : ", and ") + reason;
    };
    const auto joint_name = [&](std::size_t joint) { return tree_.joint_of(joint).name; };
    count(all(chosen, [&](std::size_t joint) { return evidence_.stated[joint]; }),
          chosen == stated_alone_ ? weight_stated_alone : weight_stated,
          "they have a " + evidence_.stated_in);
    count(chosen == with_effort_, effort_is_meant() ? weight_effort : weight_effort_by_habit,
          "they alone have effort limits above zero");
    count(all(chosen, [&](std::size_t joint) { return says_drive(joint_name(joint)); }), weight_name,
          "they are named as actuated joints");
    count(std::any_of(chosen.begin(), chosen.end(),
                      [&](std::size_t joint) { return says_passive(joint_name(joint)); }),
          weight_passive, "");
    const bool all_at_base = all(chosen, [&](std::size_t joint) { return at_base(joint); });
    const bool all_slide = all(chosen, [&](std::size_t joint) { return is_slide(joint); });
    count(all_at_base, weight_at_base, "they are next to the base, where actuated joints usually are");
    count(all_slide, weight_slide, "they are slides, which are seldom passive");
    count(!all_at_base && !all_slide && all(chosen, [&](std::size_t joint) { return is_usual(joint); }),
          weight_usual, "they are slides, and next to the base in legs that have none");
    return marked(candidate);
  }

  static ActuationCandidate marked(ActuationCandidate candidate) {
    if (candidate.reason.empty()) candidate.reason = "the mobility fits";
    candidate.is_guess = candidate.weight < least_weight_that_decides;
    if (candidate.is_guess) candidate.reason = "a guess: " + candidate.reason;
    return candidate;
  }

  std::vector<ActuationCandidate> weighed() const {
    std::vector<ActuationCandidate> result;
    for (const Variables& chosen : combinations_) result.push_back(weighed(chosen));
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& one, const auto& other) { return one.weight > other.weight; });
    return result;
  }

  const Tree& tree_;
  const std::vector<GraphPart>& legs_;
  const JointEvidence& evidence_;
  bool with_followers_;
  // One joint of each leg, the only one with what the name says; else none.
  Variables stated_alone_, with_effort_;
  std::set<Variables> known_;
  std::vector<Variables> combinations_;
};

}  // namespace

JointEvidence find_joint_evidence(const LoopSource& source) {
  const auto count = static_cast<std::size_t>(source.tree.variables());
  const DescribedActuation described = described_actuation(source);
  JointEvidence evidence{
      std::vector<bool>(count, false), std::vector<StatedEffort>(count), std::string(described.element), {}};
  const auto variable = [&](const std::string& name) {
    const auto joint = source.tree.joint_named(name);
    return joint ? source.tree.joints[*joint].variable : std::nullopt;
  };
  for (const std::string& name : described.joints)
    if (const auto joint = variable(name))
      evidence.stated[*joint] = true;
    else
      evidence.unknown.push_back(name);
  for (const auto* joint = source.robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint"))
    if (const auto found = variable(attribute(joint, "name")))
      evidence.efforts[*found] = stated_effort(joint);
  return evidence;
}

std::vector<ActuationCandidate> actuation_candidates(const Tree& tree, const std::vector<GraphPart>& legs,
                                                     const JointEvidence& evidence, bool with_followers) {
  return Combiner(tree, legs, evidence, with_followers).find();
}

ActuationCandidate stated_actuation(const JointEvidence& evidence) {
  ActuationCandidate candidate{{}, 0, "they have a " + evidence.stated_in, false};
  for (std::size_t joint = 0; joint < evidence.stated.size(); ++joint)
    if (evidence.stated[joint]) candidate.variables.push_back(joint);
  return candidate;
}

bool is_stated(const ActuationCandidate& candidate, const JointEvidence& evidence) {
  return std::all_of(candidate.variables.begin(), candidate.variables.end(),
                     [&](std::size_t joint) { return evidence.stated[joint]; });
}

bool lacks_a_leg(const ActuationCandidate& stated, const Tree& tree, const Bodies& bodies, std::size_t base,
                 const std::vector<bool>& in_loop) {
  const Variables& joints = stated.variables;
  if (!is_actuation_count(joints.size())) return false;
  const auto is_loose = [&](std::size_t joint) {
    return !in_loop[joint] && bodies.of(tree.joint_of(joint).parent) == base;
  };
  return std::any_of(joints.begin(), joints.end(), is_loose) &&
         std::any_of(joints.begin(), joints.end(), [&](std::size_t joint) { return in_loop[joint]; });
}

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
  NamesByReason reasons;  // of joints
  for (std::size_t joint = 0; joint < stated.size(); ++joint) {
    if (!stated[joint] || has(taken.variables, joint)) continue;
    add_name(reason_to_leave_out(taken, joint), taken.tree.joint_of(joint).name, reasons);
  }
  if (reasons.empty()) return std::nullopt;
  std::string left_out, instead;
  for (const auto& [reason, joints] : reasons)
    left_out += (left_out.empty() ? "" : ", and of ") + listed_names(joints).text() +
                (joints.size() == 1 || reason.rfind("whose", 0) == 0 ? ", " : ", each of ") + reason;
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

}  // namespace parallel_aspects
