// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/joint_corrections.h"

#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double nearly_half_a_turn = -0.999;  // cosine of a turn whose axis is not known

// The joint on the base that carries a joint, or is it.
std::optional<std::size_t> start_of_leg(const Tree& tree, std::size_t base, std::size_t joint) {
  for (std::optional<std::size_t> at = joint; at;
       at = tree.joint_above[body_of(tree, tree.joints[*at].parent)])
    if (body_of(tree, tree.joints[*at].parent) == base) return at;
  return std::nullopt;
}

struct Sibling {
  std::size_t joint = 0, start = 0;
};

// Those of other legs.
std::vector<Sibling> siblings_in_other_legs(const Tree& tree, std::size_t base, const LoopJoints& loops,
                                            std::size_t joint, std::size_t own_start) {
  std::vector<Sibling> found;
  for (const std::size_t sibling : loops.siblings(joint)) {
    const auto start = start_of_leg(tree, base, sibling);
    if (start && *start != own_start && tree.joints[sibling].motion == tree.joints[joint].motion)
      found.push_back({sibling, *start});
  }
  return found;
}

bool any_have_one_axis(const LoopJoints& loops, const std::vector<Sibling>& siblings) {
  for (const Sibling& one : siblings)
    for (const Sibling& other : siblings)
      if (one.start != other.start && loops.same_motion(one.joint, other.joint)) return true;
  return false;
}

}  // namespace

std::vector<Vector3d> turned_axes(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                                  std::size_t joint) {
  const std::size_t base = body_of(tree, resolved.base);
  const auto own_start = start_of_leg(tree, base, joint);
  if (!own_start) return {};
  const std::vector<Sibling> siblings = siblings_in_other_legs(tree, base, loops, joint, *own_start);
  if (any_have_one_axis(loops, siblings)) return {};
  const Poses poses = link_poses(tree, resolved.base, Eigen::VectorXd::Zero(tree.variables()));
  const auto place = [&](std::size_t start) {
    return Vector3d(poses[tree.joints[start].child].translation());
  };
  std::set<std::size_t> starts{*own_start};
  for (const Sibling& sibling : siblings) starts.insert(sibling.start);
  Vector3d middle = Vector3d::Zero();
  for (const std::size_t start : starts) middle += place(start) / static_cast<double>(starts.size());
  const Vector3d own = (place(*own_start) - middle).normalized();
  std::vector<Vector3d> axes;
  for (const Sibling& sibling : siblings) {
    const Vector3d other = (place(sibling.start) - middle).normalized();
    if (!(other.dot(own) > nearly_half_a_turn)) continue;
    const Vector3d axis = poses[tree.joints[sibling.joint].child].linear() * tree.joints[sibling.joint].axis;
    axes.push_back(poses[tree.joints[joint].child].linear().transpose() *
                   (shortest_rotation(other, own) * axis));
  }
  return axes;
}

namespace {

using Eigen::Vector3d;

// What a joint is to be: its type, and the axis where it is not fixed.
struct Motion {
  JointMotion type = JointMotion::fixed;
  Vector3d axis = Vector3d::UnitX();
};

void remove_variable(Tree& tree, ResolvedConfig& resolved, std::size_t joint) {
  const std::size_t removed = *tree.joints[joint].variable;
  tree.joints[joint].variable.reset();
  tree.movable.erase(tree.movable.begin() + static_cast<std::ptrdiff_t>(removed));
  for (TreeJoint& other : tree.joints)
    if (other.variable && *other.variable > removed) --*other.variable;
  for (std::size_t& actuated : resolved.actuated_joints.variables)
    if (actuated > removed) --actuated;
}

void set_motion(Tree& tree, ResolvedConfig& resolved, std::size_t joint, const Motion& motion) {
  TreeJoint& changed = tree.joints[joint];
  if (changed.motion != motion.type && motion.type != JointMotion::prismatic) changed.limits = {};
  changed.motion = motion.type;
  changed.axis = motion.axis;
  const bool is_movable = motion.type != JointMotion::fixed;
  if (is_movable == changed.variable.has_value()) return;
  if (!is_movable) return remove_variable(tree, resolved, joint);
  changed.variable = tree.movable.size();
  tree.movable.push_back(joint);
}

std::string type_name(JointMotion type) {
  if (type == JointMotion::fixed) return "fixed";
  return type == JointMotion::revolute ? "continuous" : "prismatic";
}

// "is fixed", "turns about (0, 0, 1)".
std::string text_of(const Motion& motion) {
  if (motion.type == JointMotion::fixed) return "is fixed";
  return (motion.type == JointMotion::revolute ? "turns about " : "slides along ") + in_brackets(motion.axis);
}

bool are_same(const Motion& one, const Motion& other) {
  return one.type == other.type &&
         (one.type == JointMotion::fixed || one.axis.cross(other.axis).norm() < rank_tolerance);
}

class JointCorrections {
 public:
  JointCorrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                   std::size_t joint, const SourceNames& files)
      : tree_(tree),
        resolved_(resolved),
        loops_(loops),
        index_(joint),
        joint_(tree.joints[joint]),
        files_(files) {
    const auto& actuated = resolved.actuated_joints.variables;
    is_actuated_ =
        joint_.variable && std::find(actuated.begin(), actuated.end(), *joint_.variable) != actuated.end();
  }

  Corrections find() {
    add_of_siblings();
    add_of_turned_legs();
    const bool is_fixed = joint_.motion == JointMotion::fixed;
    if (joint_.motion == JointMotion::revolute && any_slides()) add({JointMotion::prismatic, joint_.axis});
    if (joint_.motion == JointMotion::prismatic)
      add({JointMotion::revolute, joint_.axis}, "", !is_actuated_);  // a passive slide is seldom meant
    if (!is_fixed) add({JointMotion::fixed, joint_.axis});
    for (const Eigen::Index k : {2, 1, 0})
      add({is_fixed ? JointMotion::revolute : joint_.motion, Vector3d::Unit(k)});
    return std::move(found_);
  }

 private:
  bool any_slides() const {
    return std::any_of(loops_.all().begin(), loops_.all().end(), [this](std::size_t joint) {
      return tree_.joints[joint].motion == JointMotion::prismatic;
    });
  }

  // What as many siblings are, at least, as are like this joint.
  void add_of_siblings() {
    const std::vector<std::size_t> siblings = loops_.siblings(index_);
    const auto like = [&](std::size_t joint) {
      return std::count_if(siblings.begin(), siblings.end(),
                           [&](std::size_t other) { return loops_.same_motion(joint, other); });
    };
    const auto own = like(index_) + 1;
    for (const std::size_t sibling : siblings) {
      const auto count = like(sibling);
      if (loops_.same_motion(index_, sibling) || count < own) continue;
      const Motion motion{tree_.joints[sibling].motion, tree_.joints[sibling].axis};
      const bool like_others = count > own && count > 1;
      add(motion,
          ", where " + (like_others ? "that of other legs" : "joint '" + tree_.joints[sibling].name + "'") +
              " " + text_of(motion),
          like_others);
    }
  }

  // Of files whose frames are all parallel: the axis that two siblings at least have, turned with their legs
  // to the place of this one.
  void add_of_turned_legs() {
    if (joint_.motion == JointMotion::fixed) return;
    const std::vector<Vector3d> axes = turned_axes(tree_, resolved_, loops_, index_);
    for (std::size_t k = 0; k < axes.size(); ++k)
      for (std::size_t other = 0; other < k; ++other)
        if (axes[k].cross(axes[other]).norm() < rank_tolerance) {
          const Motion motion{joint_.motion, axes[k]};
          return add(motion, ", where that of other legs, turned with them, " + text_of(motion), true);
        }
  }

  // An actuated joint moves.
  void add(const Motion& motion, const std::string& reason = "", bool like_others = false) {
    const bool is_known = std::any_of(tried_.begin(), tried_.end(),
                                      [&](const Motion& other) { return are_same(motion, other); });
    if (is_known || are_same(motion, {joint_.motion, joint_.axis})) return;
    if (is_actuated_ && motion.type == JointMotion::fixed) return;
    tried_.push_back(motion);
    Correction correction;
    correction.element = "joint '" + joint_.name + "'";
    correction.fault = files_.urdf + " " + present_text() + reason;
    correction.remedy = "write " + written(motion) + " for " + correction.element;
    correction.like_others = like_others;
    correction.fixes_joint = motion.type == JointMotion::fixed;
    correction.apply = [joint = index_, motion](Tree& tree, ResolvedConfig& resolved) {
      set_motion(tree, resolved, joint, motion);
    };
    found_.push_back(std::move(correction));
  }

  std::string present_text() const {
    const std::string name = "joint '" + joint_.name + "'";
    if (joint_.motion == JointMotion::fixed) return "fixes " + name;
    return "lets " + name + (joint_.motion == JointMotion::revolute ? " turn about " : " slide along ") +
           in_brackets(joint_.axis);
  }

  std::string written(const Motion& motion) const {
    const bool other_type = motion.type != joint_.motion;
    const bool other_axis =
        motion.type != JointMotion::fixed &&
        (joint_.motion == JointMotion::fixed || motion.axis.cross(joint_.axis).norm() > rank_tolerance);
    return (other_type ? "type=\"" + type_name(motion.type) + "\"" : "") +
           (other_type && other_axis ? " and " : "") +
           (other_axis ? "<axis xyz=\"" + as_attribute(motion.axis) + "\"/>" : "");
  }

  const Tree& tree_;
  const ResolvedConfig& resolved_;
  const LoopJoints& loops_;
  std::size_t index_;
  const TreeJoint& joint_;
  const SourceNames& files_;
  bool is_actuated_ = false;
  std::vector<Motion> tried_;
  Corrections found_;
};

// The slide that carries this one, or that it carries, along the same direction.
std::optional<std::size_t> slide_in_series(const Tree& tree, std::size_t joint) {
  const Poses poses = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
  const auto axis = [&](std::size_t of) -> Vector3d {
    return poses[tree.joints[of].child].linear() * tree.joints[of].axis;
  };
  const TreeJoint& slide = tree.joints[joint];
  for (std::size_t other = 0; other < tree.joints.size(); ++other) {
    const TreeJoint& one = tree.joints[other];
    const bool is_next = body_of(tree, slide.parent) == one.child || body_of(tree, one.parent) == slide.child;
    if (one.motion == JointMotion::prismatic && is_next &&
        axis(joint).cross(axis(other)).norm() < rank_tolerance)
      return other;
  }
  return std::nullopt;
}

}  // namespace

Corrections series_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                               const SourceNames& files) {
  std::vector<std::size_t> passive;
  std::string names, remedy;
  for (const std::size_t joint : loops.all()) {
    const auto& actuated = resolved.actuated_joints.variables;
    const auto is_actuated = [&](std::size_t of) {
      return std::find(actuated.begin(), actuated.end(), *tree.joints[of].variable) != actuated.end();
    };
    if (tree.joints[joint].motion != JointMotion::prismatic || is_actuated(joint)) continue;
    const auto other = slide_in_series(tree, joint);
    if (!other || !is_actuated(*other)) continue;
    const std::string name = "joint '" + tree.joints[joint].name + "'";
    passive.push_back(joint);
    names += (names.empty() ? "" : ", ") + name + " in series with '" + tree.joints[*other].name + "'";
    remedy += (remedy.empty() ? "write type=\"fixed\" for " : " and write type=\"fixed\" for ") + name;
  }
  if (passive.empty()) return {};
  const bool is_one = passive.size() == 1;
  return {{is_one ? "joint '" + tree.joints[passive.front()].name + "'" : "slides in series",
           files.urdf + " lets " + names +
               " slide along the same direction, and only one of each two is actuated",
           remedy, true, [passive](Tree& changed, ResolvedConfig& config) {
             for (const std::size_t joint : passive)
               set_motion(changed, config, joint, {JointMotion::fixed, changed.joints[joint].axis});
           }}};
}

Corrections joint_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                              std::size_t joint, const SourceNames& files) {
  return JointCorrections(tree, resolved, loops, joint, files).find();
}

}  // namespace parallel_aspects
