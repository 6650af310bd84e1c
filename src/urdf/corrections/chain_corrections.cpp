// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/chain_corrections.h"

#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using Directions = std::vector<Eigen::Vector3d>;
using Eigen::Vector3d;

constexpr double least_beside = 0.1;  // that a direction is beside those which are there, of unit length
constexpr std::array<const char*, 3> axis_names{"x", "y", "z"}, angle_names{"roll", "pitch", "yaw"};

bool are_along(const Vector3d& one, const Vector3d& other) {
  return one.cross(other).norm() < rank_tolerance;
}

bool are_across(const Vector3d& one, const Vector3d& other) {
  return std::abs(one.dot(other)) < rank_tolerance;
}

// What is left of a direction beside others.
Vector3d beside(Vector3d direction, const Directions& others) {
  Directions known;
  for (Vector3d other : others) {
    for (const Vector3d& one : known) other -= one * one.dot(other);
    if (other.norm() > least_beside) known.push_back(other.normalized());
  }
  for (const Vector3d& one : known) direction -= one * one.dot(direction);
  return direction;
}

// Joints that are to come in before a chain, which slide, and after it, which turn.
struct Missing {
  std::vector<Eigen::Index> slides;  // along axes of the link that the chain starts at
  std::vector<Eigen::Index> turns;   // about the same axes
};

// A chain of joints from the base on, each carried by the one before.
class ChainCorrections {
 public:
  ChainCorrections(const Tree& tree, const SourceNames& files, std::vector<std::size_t> joints,
                   std::size_t actuated_joints)
      : tree_(tree), files_(files), joints_(std::move(joints)), actuated_joints_(actuated_joints) {
    const Poses all =
        link_poses(tree, tree.joints[joints_.front()].parent, Eigen::VectorXd::Zero(tree.variables()));
    for (const std::size_t joint : joints_) {
      poses_.push_back(all[tree.joints[joint].child]);
      axes_.push_back(poses_.back().linear() * tree.joints[joint].axis);
      names_ += (names_.empty() ? "'" : ", '") + tree.joints[joint].name + "'";
      (slides(joint) ? slides_ : turns_).push_back(axes_.back());
    }
  }

  // Each slide along another axis of the link that the chain starts at.
  Corrections find_axes() {
    for (std::size_t k = 0; k < joints_.size(); ++k)
      for (Eigen::Index axis = 0; axis < 3 && slides(joints_[k]); ++axis)
        if (!are_along(axes_[k], Vector3d::Unit(axis)))
          add_axis(joints_[k], poses_[k].linear().transpose() * Vector3d::Unit(axis));
    return std::move(found_);
  }

  Corrections find() {
    for (const Missing& missing : all_missing()) add(missing, false);
    if (turns_.empty() || joints_.size() < 2 || !is_planar_arm()) return std::move(found_);
    add({}, true);
    if (joints_.size() == 2) add({{}, {normal_axis()}}, true);
    return std::move(found_);
  }

 private:
  bool slides(std::size_t joint) const { return tree_.joints[joint].motion == JointMotion::prismatic; }

  // For translations, for motions in a plane, and for all motions.
  std::vector<Missing> all_missing() const {
    std::vector<Missing> all;
    const auto consider = [&](const Missing& missing) {
      if (!missing.slides.empty() || !missing.turns.empty()) all.push_back(missing);
    };
    for (const Eigen::Index normal : {2, 1, 0})
      if (is_in_plane(Vector3d::Unit(normal))) {
        consider({slides_beside(normal), {}});
        if (turns_.empty()) consider({slides_beside(normal), {normal}});
      }
    if (turns_.empty()) {
      consider({slides_beside(-1), {}});
      if (actuated_joints_ > slides_.size()) consider({slides_beside(-1), {0, 1, 2}});
    }
    std::stable_sort(all.begin(), all.end(), [](const Missing& one, const Missing& other) {
      return one.slides.size() + one.turns.size() < other.slides.size() + other.turns.size();
    });
    return all;
  }

  bool is_in_plane(const Vector3d& normal) const {
    return std::all_of(slides_.begin(), slides_.end(),
                       [&](const Vector3d& slide) { return are_across(slide, normal); }) &&
           std::all_of(turns_.begin(), turns_.end(),
                       [&](const Vector3d& turn) { return are_along(turn, normal); });
  }

  // All axes but the normal along which the chain does not slide.
  std::vector<Eigen::Index> slides_beside(Eigen::Index normal) const {
    std::vector<Eigen::Index> found;
    Directions known = slides_;
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (k == normal || beside(Vector3d::Unit(k), known).norm() < least_beside) continue;
      found.push_back(k);
      known.push_back(Vector3d::Unit(k));
    }
    return found;
  }

  // The axis of the base that all joints turn about.
  Eigen::Index normal_axis() const {
    Eigen::Index normal = 0;
    turns_.front().cwiseAbs().maxCoeff(&normal);
    return normal;
  }

  // One of the first two joints turns, and the others, which all turn about the normal, come after both.
  bool is_planar_arm() const {
    const Vector3d normal = turns_.front();
    return is_in_plane(normal) && (!slides(joints_[0]) || !slides(joints_[1])) &&
           std::none_of(joints_.begin() + 2, joints_.end(),
                        [this](std::size_t joint) { return slides(joint); });
  }

  // Those of the first two joints that are to be slides, with their axes in their own frames.
  std::vector<std::pair<std::size_t, Vector3d>> as_slides() const {
    const Vector3d normal = turns_.front().normalized();
    Vector3d first = axes_[0];
    if (slides(joints_[1])) first = axes_[1].cross(normal);
    if (!slides(joints_[0]) && !slides(joints_[1])) {
      Eigen::Index along = 0;
      normal.cwiseAbs().minCoeff(&along);
      first = beside(Vector3d::Unit(along), {normal}).normalized();
    }
    std::vector<std::pair<std::size_t, Vector3d>> result;
    const std::array<Vector3d, 2> axes{first, normal.cross(first)};
    for (const std::size_t k : {0, 1})
      if (!slides(joints_[k])) result.emplace_back(joints_[k], poses_[k].linear().transpose() * axes[k]);
    return result;
  }

  std::string free_name(std::string name) const {
    while (tree_.link_named(name) || tree_.joint_named(name)) name += "_";
    return name;
  }

  const std::string& name_of(std::size_t joint) const { return tree_.joints[joint].name; }

  static std::string element_of(const NewJoint& added, const std::string& parent, const std::string& child) {
    const bool slides = added.motion == JointMotion::prismatic;
    return "add <link name=\"" + added.name + "\"/><joint name=\"" + added.name + "\" type=\"" +
           (slides ? "prismatic" : "continuous") + "\"><parent link=\"" + parent + "\"/><child link=\"" +
           child + "\"/><axis xyz=\"" + as_attribute(added.axis) + "\"/></joint>";
  }

  std::vector<NewJoint> new_slides(const Missing& missing) const {
    std::vector<NewJoint> added;
    for (const Eigen::Index k : missing.slides)
      added.push_back({free_name(std::string("carrier_") + axis_names.at(static_cast<std::size_t>(k))),
                       JointMotion::prismatic, Vector3d::Unit(k)});
    return added;
  }

  // In the frame of what the last joint carries.
  std::vector<NewJoint> new_turns(const Missing& missing) const {
    std::vector<NewJoint> added;
    for (const Eigen::Index k : missing.turns)
      added.push_back({free_name(std::string("carrier_") + angle_names.at(static_cast<std::size_t>(k))),
                       JointMotion::revolute, poses_.back().linear().transpose() * Vector3d::Unit(k)});
    return added;
  }

  void add_axis(std::size_t joint, const Vector3d& axis) {
    const std::string name = "joint '" + name_of(joint) + "'";
    found_.push_back({name,
                      files_.urdf + " lets " + name + " slide along " +
                          in_brackets(tree_.joints[joint].axis) + " in the chain of " + names_ +
                          ", which has no actuated joint",
                      "write <axis xyz=\"" + as_attribute(axis) + "\"/> for " + name, false,
                      [joint, axis](Tree& tree, ResolvedConfig&) { tree.joints[joint].axis = axis; }});
  }

  void add(const Missing& missing, bool with_slides) {
    const std::vector<NewJoint> before = new_slides(missing), after = new_turns(missing);
    const auto converted = with_slides ? as_slides() : std::vector<std::pair<std::size_t, Vector3d>>{};
    const std::string first = name_of(joints_.front()), last = name_of(joints_.back());
    found_.push_back({"chain of " + names_, fault(before.empty() && after.empty(), with_slides),
                      remedy(before, after, converted), false,
                      [before, after, converted, first, last](Tree& tree, ResolvedConfig&) {
                        for (const auto& [joint, axis] : converted) {
                          tree.joints[joint].motion = JointMotion::prismatic;
                          tree.joints[joint].axis = axis;
                          tree.joints[joint].limits = {};
                        }
                        for (const NewJoint& added : before) insert_before(tree, first, added);
                        for (auto added = after.rbegin(); added != after.rend(); ++added)
                          insert_after(tree, last, *added);
                      }});
  }

  std::string fault(bool is_complete, bool with_slides) const {
    return files_.urdf + " joins the platform to the base by the chain of " + names_ +
           ", without actuated joint, which " +
           (with_slides ? "is an arm whose own reach would bound the robot" : "") +
           (with_slides && !is_complete ? ", and " : "") +
           (is_complete ? "" : "lets the platform move in fewer ways than the actuated joints need");
  }

  std::string remedy(const std::vector<NewJoint>& before, const std::vector<NewJoint>& after,
                     const std::vector<std::pair<std::size_t, Vector3d>>& converted) const {
    std::string text;
    const auto append = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
    for (const auto& [joint, axis] : converted)
      append("write type=\"prismatic\" and <axis xyz=\"" + as_attribute(axis) +
             "\"/> without <limit> for joint '" + name_of(joint) + "'");
    const TreeJoint &first = tree_.joints[joints_.front()], &last = tree_.joints[joints_.back()];
    for (std::size_t k = 0; k < before.size(); ++k)
      append(element_of(before[k], k == 0 ? tree_.links[first.parent] : before[k - 1].name, before[k].name));
    if (!before.empty())
      append("write <parent link=\"" + before.back().name + "\"/> for joint '" + first.name + "'");
    for (std::size_t k = 0; k < after.size(); ++k)
      append(element_of(after[k], after[k].name,
                        k + 1 < after.size() ? after[k + 1].name : tree_.links[last.child]));
    if (!after.empty())
      append("write <child link=\"" + after.front().name + "\"/> for joint '" + last.name + "'");
    return text;
  }

  const Tree& tree_;
  const SourceNames& files_;
  std::vector<std::size_t> joints_;       // of the tree
  std::size_t actuated_joints_;           // of the robot
  std::vector<Eigen::Isometry3d> poses_;  // of what they carry, at zero, in the link that the first starts at
  Directions axes_, slides_, turns_;      // in the same frame: of all; of those that slide and that turn
  std::string names_;
  Corrections found_;
};

// The joints of the tree of a part without actuated joint, where each carries the next; else nothing.
std::optional<std::vector<std::size_t>> passive_chain(const Tree& tree, const ResolvedConfig& resolved,
                                                      std::vector<LegJoint> part) {
  std::sort(part.begin(), part.end(),
            [](const LegJoint& one, const LegJoint& other) { return one.depth < other.depth; });
  std::vector<std::size_t> joints;
  std::size_t body = body_of(tree, resolved.base);
  for (const LegJoint& joint : part) {
    const auto& actuated = resolved.actuated_joints.variables;
    const TreeJoint& next = tree.joint_of(joint.variable);
    if (std::find(actuated.begin(), actuated.end(), joint.variable) != actuated.end() ||
        body_of(tree, next.parent) != body)
      return std::nullopt;
    body = next.child;
    joints.push_back(tree.movable[joint.variable]);
  }
  return joints.empty() ? std::nullopt : std::optional<std::vector<std::size_t>>(joints);
}

std::vector<JointMotion> motions_of(const Tree& tree, const std::vector<LegJoint>& part) {
  std::vector<JointMotion> motions;
  for (const LegJoint& joint : part) motions.push_back(tree.joint_of(joint.variable).motion);
  return motions;
}

// Whether another part is like it: then it is a leg whose actuated joint is not listed.
bool is_like_a_leg(const Tree& tree, const std::vector<std::vector<LegJoint>>& parts, std::size_t part) {
  for (std::size_t other = 0; other < parts.size(); ++other)
    if (other != part && motions_of(tree, parts[other]) == motions_of(tree, parts[part])) return true;
  return false;
}

}  // namespace

std::vector<Corrections> chain_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                           const ClosureSystem& system, const SourceNames& files) {
  Corrections of_axes, of_joints;
  const auto parts = joints_by_leg(system, resolved.actuated_joints, files);
  const std::size_t platform = body_of(tree, resolved.actuated_joints.platform_link);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto joints = passive_chain(tree, resolved, parts[k]);
    if (!joints || (tree.joints[joints->back()].child != platform && is_like_a_leg(tree, parts, k))) continue;
    const auto chain = [&] {
      return ChainCorrections(tree, files, *joints, resolved.actuated_joints.variables.size());
    };
    for (Correction& correction : chain().find_axes()) of_axes.push_back(std::move(correction));
    for (Correction& correction : chain().find()) of_joints.push_back(std::move(correction));
  }
  return {of_axes, of_joints};
}

}  // namespace parallel_aspects
