// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/missing_joints.h"

#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Joints = std::vector<std::size_t>;  // of the tree, from the base on

bool are_alike(const TreeJoint& one, const TreeJoint& other) {
  return one.motion == other.motion && one.axis.cross(other.axis).norm() < rank_tolerance;
}

bool are_alike(const Tree& tree, const Joints& one, const Joints& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [&](std::size_t a, std::size_t b) { return are_alike(tree.joints[a], tree.joints[b]); });
}

Joints without(Joints joints, std::size_t index) {
  joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(index));
  return joints;
}

// With the last number of `to` in the place of that of `from`: "yoke_2" like "piston_2" becomes "yoke_3" like
// "piston_3".
std::string renamed(std::string name, const std::string& from, const std::string& to) {
  const auto number_of = [](const std::string& text) {
    std::size_t end = text.size();
    while (end > 0 && std::isdigit(static_cast<unsigned char>(text[end - 1])) == 0) --end;
    std::size_t start = end;
    while (start > 0 && std::isdigit(static_cast<unsigned char>(text[start - 1])) != 0) --start;
    return text.substr(start, end - start);
  };
  const std::string old = number_of(from);
  const std::size_t at = old.empty() ? std::string::npos : name.rfind(old);
  if (at == std::string::npos) return name;
  return name.replace(at, old.size(), number_of(to));
}

class MissingJoints {
 public:
  MissingJoints(const Tree& tree, const ResolvedConfig& resolved, const ClosureSystem& system,
                const SourceNames& files)
      : tree_(tree), resolved_(resolved), files_(files) {
    for (std::vector<LegJoint> part : joints_by_leg(system, resolved.actuated_joints, files)) {
      std::sort(part.begin(), part.end(),
                [](const LegJoint& one, const LegJoint& other) { return one.depth < other.depth; });
      Joints joints;
      for (const LegJoint& joint : part) joints.push_back(tree.movable[joint.variable]);
      legs_.push_back(joints);
    }
  }

  Corrections find() {
    for (const Joints& leg : legs_)
      if (const Joints* usual = usual_of(leg))
        for (std::size_t k = 0; k < usual->size(); ++k)
          if (are_alike(tree_, without(*usual, k), leg) && !is_actuated((*usual)[k])) add(leg, *usual, k);
    return std::move(found_);
  }

 private:
  // Fixed ones and frames, too, that a leg begins with or carries.
  std::size_t all_joints_of(const Joints& leg) const {
    const auto is_carried = [&](const TreeJoint& joint) {
      for (auto above = tree_.joint_above[joint.child]; above;
           above = tree_.joint_above[tree_.joints[*above].parent])
        if (*above == leg.front()) return true;
      return false;
    };
    return static_cast<std::size_t>(std::count_if(tree_.joints.begin(), tree_.joints.end(), is_carried));
  }

  // A leg of one joint more that another one is like. With as many, one is fixed that is to move.
  const Joints* usual_of(const Joints& lacking) const {
    if (lacking.empty()) return nullptr;
    for (const Joints& leg : legs_)
      if (leg.size() == lacking.size() + 1 && all_joints_of(leg) == all_joints_of(lacking) + 1 &&
          std::count_if(legs_.begin(), legs_.end(),
                        [&](const Joints& other) { return are_alike(tree_, leg, other); }) >= 2)
        return &leg;
    return nullptr;
  }

  bool is_actuated(std::size_t joint) const {
    const auto& actuated = resolved_.actuated_joints.variables;
    return std::find(actuated.begin(), actuated.end(), *tree_.joints[joint].variable) != actuated.end();
  }

  // Whether the tree goes from the one to the other.
  bool carries(std::size_t joint, std::size_t next) const {
    return body_of(tree_, tree_.joints[next].parent) == tree_.joints[joint].child;
  }

  std::string free_name(std::string name) const {
    while (tree_.link_named(name) || tree_.joint_named(name)) name += "_";
    return name;
  }

  // Before the joint that comes next, or after the last.
  void add(const Joints& leg, const Joints& usual, std::size_t index) {
    if (leg.empty()) return;
    const bool is_last = index == leg.size();
    const std::size_t beside = is_last ? leg.back() : leg[index];
    if (index > 0 && !is_last && !carries(leg[index - 1], beside)) return;
    const TreeJoint& missing = tree_.joints[usual[index]];
    if (!missing.origin.isApprox(Eigen::Isometry3d::Identity())) return;  // where it is to be is open
    const TreeJoint& next = tree_.joints[beside];
    const std::string like = tree_.joints[usual[is_last ? index - 1 : index + 1]].name;
    const NewJoint added{free_name(renamed(missing.name, like, next.name)), missing.motion, missing.axis};
    const std::string type = missing.motion == JointMotion::prismatic ? "prismatic" : "continuous";
    const std::string parent = is_last ? added.name : tree_.links[next.parent],
                      child = is_last ? tree_.links[next.child] : added.name;
    found_.push_back({"leg of joint '" + next.name + "'",
                      files_.urdf + " has one joint less in the leg of joint '" + next.name +
                          "' than in others: it lacks what joint '" + missing.name + "' is in one of these",
                      "add <link name=\"" + added.name + "\"/><joint name=\"" + added.name + "\" type=\"" +
                          type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
                          "\"/><axis xyz=\"" + as_attribute(added.axis) + "\"/></joint> and write <" +
                          (is_last ? "child" : "parent") + " link=\"" + added.name + "\"/> for joint '" +
                          next.name + "'",
                      true, [added, is_last, name = next.name](Tree& tree, ResolvedConfig&) {
                        if (is_last)
                          insert_after(tree, name, added);
                        else
                          insert_before(tree, name, added);
                      }});
  }

  const Tree& tree_;
  const ResolvedConfig& resolved_;
  const SourceNames& files_;
  std::vector<Joints> legs_;
  Corrections found_;
};

}  // namespace

Corrections missing_joint_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                      const ClosureSystem& system, const SourceNames& files) {
  return MissingJoints(tree, resolved, system, files).find();
}

}  // namespace parallel_aspects
