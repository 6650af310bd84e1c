// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/arm_reading.h"

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/ends_of_loops.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/description/yaml_values.h"
#include "urdf/dialects/closure_dialects.h"
#include "urdf/reading/tree_reader.h"

#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

// Movable joints from the base link to another, nearest first; nothing where that does not hang on the base.
std::optional<std::vector<std::size_t>> arm_joints_between(const Tree& tree, std::size_t base,
                                                           std::size_t tip) {
  std::vector<std::size_t> joints;
  for (std::size_t link = tip; link != base;) {
    const auto above = tree.joint_above[link];
    if (!above) return std::nullopt;
    if (tree.joints[*above].variable) joints.push_back(*above);
    link = tree.joints[*above].parent;
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

std::optional<ArmTask> stated_arm_task(const YAML::Node& root, const std::string& file) {
  const YAML::Node node = root["mechanism"]["task"];
  if (!node.IsDefined()) return std::nullopt;
  Problems problems;
  std::string word, names;
  if (!YamlValues(file, problems).text(node, "mechanism.task", word)) throw InvalidDescription(problems);
  for (const ArmTask task : choices(ArmTask{})) {
    if (word == name(task)) return task;
    names += (names.empty() ? "" : ", ") + std::string(name(task));
  }
  throw InvalidDescription({file + " has the unknown mechanism.task '" + word + "'; write one of " + names +
                            ", or leave it out."});
}

// Two places of a tree, and what is between them.
struct ArmChain {
  std::size_t base = 0, tip = 0;
  std::vector<std::size_t> joints;
};

ArmDescription described_arm(const Tree& tree, const ArmChain& chain, const std::string& robot) {
  ArmDescription arm;
  arm.name = robot.empty() ? tree.name : robot;
  arm.base_link = tree.links[chain.base];
  arm.tip_link = tree.links[chain.tip];
  const Poses poses = link_poses(tree, chain.base, Eigen::VectorXd::Zero(tree.variables()));
  for (const std::size_t index : chain.joints) {
    const TreeJoint& joint = tree.joints[index];
    const Eigen::Isometry3d& frame = poses[joint.child];
    arm.axes.push_back({joint.name, joint.motion == JointMotion::revolute, frame.translation(),
                        frame.linear() * joint.axis, joint.limits});
  }
  arm.tip = poses[chain.tip];
  return arm;
}

// No joint of an arm follows another one.
void check_arm_mimics(const Tree& tree, const ArmChain& chain, const std::string& urdf_name) {
  for (const std::size_t joint : chain.joints)
    if (tree.joints[joint].mimics)
      throw InvalidDescription({urdf_name + " lets joint '" + tree.joints[joint].name +
                                "' of the arm follow another one; arms whose joints are coupled are not "
                                "treated. Take its <mimic> out if it has a drive of its own."});
}

std::vector<std::string> arm_joint_names(const Tree& tree, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t joint : joints) names.push_back(tree.joints[joint].name);
  return names;
}

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Those of the YAML, or those of the URDF that are in the chain.
std::vector<std::string> arm_actuation(const MechanismConfig& config, const LoopSource& source,
                                       const std::vector<std::string>& in_chain) {
  if (config.lists_actuated_joints) return config.actuated_joints;
  std::vector<std::string> names;
  for (const std::string& name : described_actuation(source).joints)
    if (is_among(in_chain, name)) names.push_back(name);
  return names;
}

// Nothing where the joints are not those of one chain.
std::optional<ArmChain> arm_chain(const Tree& tree, const MechanismConfig& config, const LoopSource& source) {
  const auto base =
      config.base_link.empty() ? std::make_optional<std::size_t>(0) : tree.link_named(config.base_link);
  const auto tip = tree.link_named(config.operational_point.link);
  if (!base || !tip) return std::nullopt;
  const auto joints = arm_joints_between(tree, *base, *tip);
  if (!joints || joints->size() < 2) return std::nullopt;
  const std::vector<std::string> in_chain = arm_joint_names(tree, *joints),
                                 actuated = arm_actuation(config, source, in_chain);
  if (actuated.size() < 2 || !std::all_of(actuated.begin(), actuated.end(),
                                          [&](const std::string& each) { return is_among(in_chain, each); }))
    return std::nullopt;
  for (const std::string& each : in_chain)
    if (!is_among(actuated, each)) {
      if (!serial_arm_text(tree, source.files.urdf)) return std::nullopt;
      throw InvalidDescription({source.files.config + " does not list joint '" + each +
                                "' in mechanism.actuated_joints, which is between the base link and the "
                                "operational point; list it, or make it fixed in " +
                                source.files.urdf + "."});
    }
  return ArmChain{*base, *tip, *joints};
}

}  // namespace

std::shared_ptr<const SerialArm> read_arm(const std::string& urdf_text, const std::string& urdf_name,
                                          const std::string& config_text, const std::string& config_name) {
  Problems problems;
  MechanismConfig config = read_mechanism_config(config_text, config_name, problems);
  if (!problems.empty() || !config.closures.empty() || !config.added_closures.empty()) return nullptr;
  const std::string text = from_latin_1(urdf_text).value_or(urdf_text);
  Notes notes;
  auto tree = read_tree(text, urdf_name, problems, notes);
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  if (!tree || document.FirstChildElement("robot") == nullptr) return nullptr;
  const YAML::Node yaml = yaml_document(config_text);
  const SourceNames files{urdf_name, config_name};
  add_operational_point(config.operational_point, files, *tree, problems);
  const LoopSource source{*document.FirstChildElement("robot"), yaml, *tree, files};
  const FoundLoops loops = find_described_loops(source, problems);
  if (!problems.empty() || !loops.loops.closures.empty()) return nullptr;
  const auto chain = arm_chain(*tree, config, source);
  if (!chain) return nullptr;
  check_arm_mimics(*tree, *chain, urdf_name);
  ArmDescription description = described_arm(*tree, *chain, config.name);
  description.task = stated_arm_task(yaml, config_name);
  return std::make_shared<const SerialArm>(description);
}

namespace {

// Names that makers give the frame at the flange, the commonest first.
constexpr std::array<const char*, 8> flange_names{"tool0",     "flange",  "ee_link",      "tool",
                                                  "tool_link", "gripper", "end_effector", "tcp"};

std::size_t joints_above(const Tree& tree, std::size_t link) {
  std::size_t count = 0;
  for (auto above = tree.joint_above[link]; above; above = tree.joint_above[tree.joints[*above].parent])
    if (tree.joints[*above].variable && !tree.joints[*above].mimics) ++count;
  return count;
}

// Whether several joints without others behind them are on this body: fingers of a hand.
bool is_on_hand(const Tree& tree, std::size_t link) {
  const std::size_t body = body_of(tree, link);
  const auto above = tree.joint_above[body];
  if (!above) return false;
  const std::size_t palm = body_of(tree, tree.joints[*above].parent);
  const auto beside = std::count_if(tree.joints.begin(), tree.joints.end(), [&](const TreeJoint& joint) {
    return joint.variable && body_of(tree, joint.parent) == palm;
  });
  return beside > 1;
}

// The frame at the end of the longest chain, without fingers.
std::size_t flange_of(const Tree& tree) {
  for (const char* wanted : flange_names)
    if (const auto link = tree.link_named(wanted); link && joints_above(tree, *link) > 1) return *link;
  std::size_t best = 0;
  for (std::size_t link = 0; link < tree.links.size(); ++link)
    if (!is_on_hand(tree, link) && joints_above(tree, link) >= joints_above(tree, best)) best = link;
  return best;
}

std::size_t base_of(const Tree& tree, std::size_t tip) {
  std::size_t base = 0;
  for (auto above = tree.joint_above[tip]; above; above = tree.joint_above[tree.joints[*above].parent])
    if (tree.joints[*above].variable) base = tree.joints[*above].parent;
  return base;
}

}  // namespace

std::optional<ArmSetup> set_up_arm(const std::string& urdf_text, const std::string& urdf_name,
                                   const std::string& config_name, const ArmAnswers& answers) {
  Problems problems;
  Notes notes;
  const auto tree = read_tree(from_latin_1(urdf_text).value_or(urdf_text), urdf_name, problems, notes);
  if (!tree || !problems.empty()) return std::nullopt;
  const auto asked_tip = tree->link_named(answers.operational_point),
             asked_base = tree->link_named(answers.base_link);
  const std::size_t tip = asked_tip.value_or(flange_of(*tree)),
                    base = asked_base.value_or(base_of(*tree, tip));
  const auto joints = arm_joints_between(*tree, base, tip);
  if (!joints || joints->size() < 2) return std::nullopt;
  std::vector<std::string> names = arm_joint_names(*tree, *joints);
  if (!answers.actuated_joints.empty()) names = answers.actuated_joints;
  YAML::Emitter robot, list, base_text, tip_text;
  robot << tree->name;
  base_text << tree->links[base];
  tip_text << tree->links[tip];
  list << YAML::Flow << names;
  ArmSetup result;
  result.config =
      "# What " + urdf_name +
      ", a serial arm, does not say. Written by `aspects setup`: check the guesses.\n"
      "mechanism:\n  # Name of the robot in messages.\n  name: " +
      std::string(robot.c_str()) + "\n\n  # Link in whose frame poses are: " +
      (asked_base ? "as asked" : "the one that the first joint of the chain is on") +
      ".\n  base_link: " + base_text.c_str() + "\n\n  # Link whose origin is the operational point: " +
      (asked_tip ? "as asked"
                 : "the end of the chain with the most joints, without fingers, or its flange by its name") +
      ".\n  operational_point: " + tip_text.c_str() +
      "\n\n  # All joints between the two, from the base on.\n  actuated_joints: " + list.c_str() + "\n";
  result.arm = read_arm(urdf_text, urdf_name, result.config, config_name);
  if (!result.arm) return std::nullopt;
  result.config +=
      "\n  # By the number of joints; plane_position, plane_pose, position, direction, orientation,\n"
      "  # position_and_turn, position_and_direction or pose.\n  task: " +
      std::string(name(result.arm->task())) + "\n";
  return result;
}

}  // namespace parallel_aspects
