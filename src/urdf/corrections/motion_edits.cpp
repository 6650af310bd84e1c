// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "urdf/corrections/edits.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;
using Joints = std::vector<std::size_t>;  // of the tree

constexpr double nearly_half_a_turn = -0.999;  // cosine of a turn whose axis is not known

bool are_same(JointMotion one, const Vector3d& one_axis, JointMotion other, const Vector3d& other_axis) {
  return one == other && (one == JointMotion::fixed || one_axis.cross(other_axis).norm() < rank_tolerance);
}

// "is fixed", "turns about (0, 0, 1)".
std::string text_of(JointMotion motion, const Vector3d& axis) {
  if (motion == JointMotion::fixed) return "is fixed";
  return (motion == JointMotion::revolute ? "turns about " : "slides along ") + in_brackets(axis);
}

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

// Those of other legs that move as the joint does.
std::vector<Sibling> siblings_in_other_legs(const Subject& s, std::size_t joint, std::size_t own_start) {
  std::vector<Sibling> found;
  for (const std::size_t sibling : s.loops.siblings(joint)) {
    const auto start = start_of_leg(s.tree, body_of(s.tree, s.resolved.base), sibling);
    if (start && *start != own_start && s.tree.joints[sibling].motion == s.tree.joints[joint].motion)
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

// The axes of the siblings of a joint, each turned about the middle of the legs from where its leg starts on
// the base to where that of the joint does, while all joints are zero; in the frame of the joint. Nothing
// where siblings have one axis in their own frames, which is what tells then.
std::vector<Vector3d> turned_axes(const Subject& s, std::size_t joint) {
  const auto own_start = start_of_leg(s.tree, body_of(s.tree, s.resolved.base), joint);
  if (!own_start) return {};
  const std::vector<Sibling> siblings = siblings_in_other_legs(s, joint, *own_start);
  if (any_have_one_axis(s.loops, siblings)) return {};
  const Poses poses = link_poses(s.tree, s.resolved.base, Eigen::VectorXd::Zero(s.tree.variables()));
  const auto pose = [&](std::size_t of) -> const Eigen::Isometry3d& {
    return poses[s.tree.joints[of].child];
  };
  std::set<std::size_t> starts{*own_start};
  for (const Sibling& sibling : siblings) starts.insert(sibling.start);
  Vector3d middle = Vector3d::Zero();
  for (const std::size_t start : starts)
    middle += pose(start).translation() / static_cast<double>(starts.size());
  const Vector3d own = (pose(*own_start).translation() - middle).normalized();
  std::vector<Vector3d> axes;
  for (const Sibling& sibling : siblings) {
    const Vector3d other = (pose(sibling.start).translation() - middle).normalized();
    if (!(other.dot(own) > nearly_half_a_turn)) continue;
    const Vector3d axis = pose(sibling.joint).linear() * s.tree.joints[sibling.joint].axis;
    axes.push_back(pose(joint).linear().transpose() * (shortest_rotation(other, own) * axis));
  }
  return axes;
}

class MotionEdits {
 public:
  MotionEdits(const Subject& subject, std::size_t joint)
      : s_(subject), index_(joint), joint_(subject.tree.joints[joint]) {}

  Edits find() {
    for (const UsualSibling& usual : usual_siblings(
             s_.loops, index_, [this](std::size_t a, std::size_t b) { return s_.loops.same_motion(a, b); })) {
      const TreeJoint& sibling = s_.tree.joints[usual.joint];
      add(sibling.motion, sibling.axis,
          ", where " + (usual.is_most ? "that of other legs" : s_.joint(usual.joint)) + " " +
              text_of(sibling.motion, sibling.axis),
          usual.is_most);
    }
    add_of_turned_legs();
    const bool is_fixed = joint_.motion == JointMotion::fixed,
               slides = joint_.motion == JointMotion::prismatic;
    if (joint_.motion == JointMotion::revolute && any_slides()) add(JointMotion::prismatic, joint_.axis);
    // A passive slide is seldom meant.
    if (slides) add(JointMotion::revolute, joint_.axis, "", !s_.is_actuated(index_));
    if (!is_fixed) add(JointMotion::fixed, joint_.axis);
    for (const Eigen::Index k : {2, 1, 0})
      add(is_fixed ? JointMotion::revolute : joint_.motion, Vector3d::Unit(k));
    return std::move(found_);
  }

 private:
  bool any_slides() const {
    return std::any_of(s_.loops.all().begin(), s_.loops.all().end(), [this](std::size_t joint) {
      return s_.tree.joints[joint].motion == JointMotion::prismatic;
    });
  }

  // Of files whose frames are all parallel: the axis that two siblings at least have, turned with their legs
  // to the place of this one.
  void add_of_turned_legs() {
    if (joint_.motion == JointMotion::fixed) return;
    const std::vector<Vector3d> axes = turned_axes(s_, index_);
    for (std::size_t k = 0; k < axes.size(); ++k)
      for (std::size_t other = 0; other < k; ++other)
        if (axes[k].cross(axes[other]).norm() < rank_tolerance)
          return add(joint_.motion, axes[k],
                     ", where that of other legs, turned with them, " + text_of(joint_.motion, axes[k]),
                     true);
  }

  // An actuated joint moves.
  void add(JointMotion motion, const Vector3d& axis, const std::string& reason = "",
           bool like_others = false) {
    const bool is_known = std::any_of(found_.begin(), found_.end(), [&](const Edit& other) {
      const auto& change = std::get<MotionChange>(other.changes.front());
      return are_same(motion, axis, change.motion, change.axis);
    });
    if (is_known || are_same(motion, axis, joint_.motion, joint_.axis)) return;
    if (s_.is_actuated(index_) && motion == JointMotion::fixed) return;
    found_.push_back(edit_of(s_, s_.files.urdf + " " + present_text() + reason,
                             {MotionChange{index_, motion, axis}}, like_others));
  }

  std::string present_text() const {
    if (joint_.motion == JointMotion::fixed) return "fixes " + s_.joint(index_);
    return "lets " + s_.joint(index_) +
           (joint_.motion == JointMotion::revolute ? " turn about " : " slide along ") +
           in_brackets(joint_.axis);
  }

  const Subject& s_;
  std::size_t index_;
  const TreeJoint& joint_;
  Edits found_;
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

Edits motion_edits(const Subject& subject, std::size_t joint) { return MotionEdits(subject, joint).find(); }

Edits series_edits(const Subject& subject) {
  std::vector<Change> fixed;
  std::string names;
  for (const std::size_t joint : subject.loops.all()) {
    if (subject.tree.joints[joint].motion != JointMotion::prismatic || subject.is_actuated(joint)) continue;
    const auto other = slide_in_series(subject.tree, joint);
    if (!other || !subject.is_actuated(*other)) continue;
    fixed.emplace_back(MotionChange{joint, JointMotion::fixed, subject.tree.joints[joint].axis});
    names += (names.empty() ? "" : ", ") + subject.joint(joint) + " in series with " +
             subject.joint(*other).substr(6);
  }
  if (fixed.empty()) return {};
  return {edit_of(subject,
                  subject.files.urdf + " lets " + names +
                      " slide along the same direction, and only one of each two is actuated",
                  std::move(fixed), true)};
}

Edits passive_slide_edits(const Subject& subject) {
  Edits found;
  for (const auto& part : joints_by_leg(subject.system, subject.resolved.actuated_joints, subject.files)) {
    const auto of_tree = [&](const LegJoint& joint) { return subject.tree.movable[joint.variable]; };
    if (std::any_of(part.begin(), part.end(),
                    [&](const LegJoint& joint) { return subject.is_actuated(of_tree(joint)); }))
      continue;
    for (const LegJoint& joint : part)
      for (Edit& edit : motion_edits(subject, of_tree(joint)))
        if (subject.tree.joint_of(joint.variable).motion == JointMotion::prismatic &&
            std::get<MotionChange>(edit.changes.front()).motion == JointMotion::prismatic)
          found.push_back(std::move(edit));
  }
  return found;
}

namespace {

// Whether no sibling that is alike comes before it, so that each group is edited once.
bool is_first_of_its_kind(const Subject& s, std::size_t joint) {
  const std::vector<std::size_t> siblings = s.loops.siblings(joint);
  return std::none_of(siblings.begin(), siblings.end(),
                      [&](std::size_t other) { return other < joint && s.loops.same_motion(joint, other); });
}

}  // namespace

Edits motions_of_like_legs(const Subject& subject) {
  Edits found;
  for (const std::size_t joint : subject.loops.all()) {
    if (!is_first_of_its_kind(subject, joint)) continue;
    std::string names;
    std::vector<std::size_t> like;
    for (const std::size_t sibling : subject.loops.siblings(joint))
      if (subject.loops.same_motion(joint, sibling)) {
        like.push_back(sibling);
        names += (names.empty() ? "" : ", ") + subject.joint(sibling);
      }
    if (like.empty()) continue;
    for (const Edit& edit : motion_edits(subject, joint)) {
      std::vector<Change> changes = edit.changes;
      for (const std::size_t sibling : like) {
        MotionChange change = std::get<MotionChange>(edit.changes.front());
        change.joint = sibling;
        changes.emplace_back(change);
      }
      found.push_back(edit_of(subject, edit.fault + ", and likewise " + names, std::move(changes)));
    }
  }
  return found;
}

namespace {

bool are_alike(const Tree& tree, const Joints& one, const Joints& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [&](std::size_t a, std::size_t b) {
    return are_same(tree.joints[a].motion, tree.joints[a].axis, tree.joints[b].motion, tree.joints[b].axis);
  });
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
  explicit MissingJoints(const Subject& subject) : s_(subject), tree_(subject.tree) {
    for (std::vector<LegJoint> part :
         joints_by_leg(subject.system, subject.resolved.actuated_joints, subject.files)) {
      std::sort(part.begin(), part.end(),
                [](const LegJoint& one, const LegJoint& other) { return one.depth < other.depth; });
      legs_.emplace_back();
      for (const LegJoint& joint : part) legs_.back().push_back(tree_.movable[joint.variable]);
    }
  }

  Edits find() {
    for (const Joints& leg : legs_)
      if (const Joints* usual = usual_of(leg))
        for (std::size_t k = 0; k < usual->size(); ++k)
          if (are_alike(tree_, without(*usual, k), leg) && !s_.is_actuated((*usual)[k])) add(leg, *usual, k);
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
    const bool is_last = index == leg.size();
    const std::size_t beside = is_last ? leg.back() : leg[index];
    if (index > 0 && !is_last && !carries(leg[index - 1], beside)) return;
    const TreeJoint& missing = tree_.joints[usual[index]];
    if (!missing.origin.isApprox(Eigen::Isometry3d::Identity())) return;  // where it is to be is open
    const std::string& like = tree_.joints[usual[is_last ? index - 1 : index + 1]].name;
    found_.push_back(edit_of(
        s_,
        s_.files.urdf + " has one joint less in the leg of " + s_.joint(beside) +
            " than in others: it lacks what " + s_.joint(usual[index]) + " is in one of these",
        {JointAddition{beside, !is_last, free_name(renamed(missing.name, like, tree_.joints[beside].name)),
                       missing.motion, missing.axis}},
        true));
  }

  const Subject& s_;
  const Tree& tree_;
  std::vector<Joints> legs_;
  Edits found_;
};

}  // namespace

Edits missing_joint_edits(const Subject& subject) { return MissingJoints(subject).find(); }

}  // namespace parallel_aspects
