// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/reading/tree_reader.h"

#include "urdf/reading/urdf_inspection.h"

#include <urdf_parser/urdf_parser.h>

#include <cmath>
#include <console_bridge/console.h>
#include <exception>
#include <unordered_map>

namespace parallel_aspects {
namespace {

// Keeps what urdfdom would print.
class ConsoleCapture : public console_bridge::OutputHandler {
 public:
  ConsoleCapture() { console_bridge::useOutputHandler(this); }
  ~ConsoleCapture() override { console_bridge::restorePreviousOutputHandler(); }
  ConsoleCapture(const ConsoleCapture&) = delete;
  ConsoleCapture& operator=(const ConsoleCapture&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_error.empty()) first_error = text;
  }

  std::string first_error;
};

Eigen::Isometry3d isometry(const urdf::Pose& pose) {
  Eigen::Quaterniond rotation;
  pose.rotation.getQuaternion(rotation.x(), rotation.y(), rotation.z(), rotation.w());
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * rotation.normalized();
}

JointMotion motion(const urdf::Joint& joint) {
  if (joint.type == urdf::Joint::FIXED) return JointMotion::fixed;
  return joint.type == urdf::Joint::PRISMATIC ? JointMotion::prismatic : JointMotion::revolute;
}

urdf::ModelInterfaceSharedPtr parsed(const std::string& text, std::string& refusal) {
  ConsoleCapture console;
  try {
    auto model = urdf::parseURDF(text);
    refusal = console.first_error;
    return model;
  } catch (const std::exception& error) {
    refusal = error.what();
    return nullptr;
  }
}

class TreeBuilder {
 public:
  TreeBuilder(const urdf::ModelInterface& model, const UrdfInspection& inspection)
      : model_(model), inspection_(inspection) {}

  Tree build() {
    tree_.name = model_.getName();
    tree_.links = {model_.getRoot()->name};
    tree_.joint_above = {std::nullopt};
    // The list grows while it is walked: every link brings its children.
    for (std::size_t link = 0; link < tree_.links.size(); ++link)
      for (const auto& joint : model_.getLink(tree_.links[link])->child_joints) add(*joint, link);
    number_joints();
    return std::move(tree_);
  }

 private:
  void add(const urdf::Joint& joint, std::size_t parent) {
    TreeJoint added;
    added.name = joint.name;
    added.motion = motion(joint);
    added.parent = parent;
    added.mimics = inspection_.mimics.count(joint.name) > 0;
    added.child = tree_.links.size();
    added.origin = isometry(joint.parent_to_joint_origin_transform);
    if (const auto wide = inspection_.wide_angles.find(joint.name); wide != inspection_.wide_angles.end())
      added.wide_angles = Eigen::Vector3d(wide->second[0], wide->second[1], wide->second[2]);
    if (added.motion != JointMotion::fixed)
      added.axis = Eigen::Vector3d(joint.axis.x, joint.axis.y, joint.axis.z).normalized();
    const bool limited = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::PRISMATIC;
    if (limited && inspection_.without_limits.count(joint.name) == 0)
      added.limits = {joint.limits->lower, joint.limits->upper};
    // Zero is what urdfdom demands of those who have no limit to give.
    if (joint.limits && std::isfinite(joint.limits->velocity) && joint.limits->velocity > 0.0)
      added.limits.velocity = joint.limits->velocity;
    tree_.links.push_back(joint.child_link_name);
    tree_.joint_above.emplace_back(tree_.joints.size());
    tree_.joints.push_back(added);
  }

  void number_joints() {
    std::unordered_map<std::string, std::size_t> indices;
    for (std::size_t k = 0; k < tree_.joints.size(); ++k) indices.emplace(tree_.joints[k].name, k);
    for (const std::string& name : inspection_.joints) {
      const std::size_t index = indices.at(name);
      if (tree_.joints[index].motion == JointMotion::fixed) continue;
      tree_.joints[index].variable = tree_.movable.size();
      tree_.movable.push_back(index);
    }
  }

  const urdf::ModelInterface& model_;
  const UrdfInspection& inspection_;
  Tree tree_;
};

}  // namespace

std::optional<Tree> read_tree(const std::string& text, const std::string& file, Problems& problems,
                              Notes& notes) {
  const std::size_t before = problems.size();
  const UrdfInspection inspection = inspect_urdf(text, file, problems, notes);
  if (problems.size() > before) return std::nullopt;
  std::string refusal;
  const urdf::ModelInterfaceSharedPtr model = parsed(inspection.text, refusal);
  if (!model || !model->getRoot()) {
    problems.push_back(file + " is refused by urdfdom: " + refusal);
    return std::nullopt;
  }
  return TreeBuilder(*model, inspection).build();
}

}  // namespace parallel_aspects
