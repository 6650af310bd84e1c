// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/chain.h"
#include "urdf/corrections/edits.h"

#include <algorithm>
#include <map>
#include <utility>

namespace parallel_aspects {
namespace {

using Choice = std::vector<std::size_t>;  // of joint values

constexpr std::size_t max_points = 16;  // links that are tried as operational point: a hexapod has 13

bool lists(const Choice& choice, std::size_t variable) {
  return std::find(choice.begin(), choice.end(), variable) != choice.end();
}

class ActuationEdits {
 public:
  explicit ActuationEdits(const Subject& subject)
      : s_(subject),
        listed_(subject.resolved.actuated_joints.variables),
        legs_(joints_by_leg(subject.system, subject.resolved.actuated_joints, subject.files)) {
    std::map<std::size_t, std::size_t> counts;
    for (const auto& leg : legs_)
      for (const LegJoint& joint : listed_of(leg)) ++counts[joint.depth];
    for (const auto& [depth, count] : counts)
      if (count > counts[usual_depth_]) usual_depth_ = depth;
  }

  Edits find() {
    if (!is_actuation_count(listed_.size())) add_one_of_each_leg();
    for (const auto& leg : legs_) {
      const std::vector<LegJoint> listed = listed_of(leg);
      if (listed.empty()) add_one_of(leg);
      if (listed.size() == 1) exchange(listed.front(), leg);
      if (listed.size() > 1) remove_one_of(listed);
    }
    std::stable_partition(found_.begin(), found_.end(), [](const Edit& edit) { return edit.like_others; });
    return std::move(found_);
  }

 private:
  std::vector<LegJoint> listed_of(const std::vector<LegJoint>& leg) const {
    std::vector<LegJoint> listed;
    for (const LegJoint& joint : leg)
      if (lists(listed_, joint.variable)) listed.push_back(joint);
    return listed;
  }

  bool is_usual(const LegJoint& joint) const { return joint.depth == usual_depth_; }

  // Those of the listed ones that are where most are.
  void add_one_of_each_leg() {
    Choice choice;
    for (const std::size_t variable : listed_)
      for (const auto& leg : legs_)
        for (const LegJoint& joint : leg)
          if (joint.variable == variable && is_usual(joint)) choice.push_back(variable);
    if (choice.size() < listed_.size()) add(choice, "lists several joints of a leg", true);
  }

  void add_one_of(const std::vector<LegJoint>& leg) {
    for (const LegJoint& joint : leg)
      add(with(listed_, joint.variable), "does not list joint " + name_of(joint), is_usual(joint));
  }

  // For the joint where others have theirs.
  void exchange(const LegJoint& listed, const std::vector<LegJoint>& leg) {
    for (const LegJoint& joint : leg) {
      if (is_usual(listed) || !is_usual(joint)) continue;
      Choice choice = listed_;
      std::replace(choice.begin(), choice.end(), std::size_t{listed.variable}, std::size_t{joint.variable});
      add(choice, "lists joint " + name_of(listed) + ", where other legs have the one of " + name_of(joint),
          true);
    }
  }

  // Another leg may have none.
  void remove_one_of(const std::vector<LegJoint>& leg) {
    for (const LegJoint& joint : leg) {
      Choice fewer = listed_;
      fewer.erase(std::find(fewer.begin(), fewer.end(), joint.variable));
      const std::string fault = "lists joint " + name_of(joint) + " besides another one of its leg";
      add(fewer, fault, !is_usual(joint));
      for (const auto& other : legs_)
        if (listed_of(other).empty())
          for (const LegJoint& added : other)
            add(with(fewer, added.variable), fault + ", and none of the leg of " + name_of(added),
                !is_usual(joint) && is_usual(added));
    }
  }

  // In the order of the file, where the others are.
  static Choice with(Choice choice, std::size_t variable) {
    const bool in_order = std::is_sorted(choice.begin(), choice.end());
    const auto place = std::upper_bound(choice.begin(), choice.end(), variable);
    choice.insert(in_order ? place : choice.end(), variable);
    return choice;
  }

  std::string name_of(const LegJoint& joint) const {
    return "'" + s_.tree.joint_of(joint.variable).name + "'";
  }

  void add(const Choice& choice, const std::string& fault, bool like_others) {
    if (std::any_of(choice.begin(), choice.end(),
                    [this](std::size_t variable) { return s_.tree.joint_of(variable).mimics; }))
      return;
    Edit edit = edit_of(s_, s_.files.config + " " + fault + " in " + s_.files.key("actuated_joints"),
                        {ActuationChange{choice}}, like_others);
    if (!like_others) edit.element = edit.remedy;
    found_.push_back(std::move(edit));
  }

  const Subject& s_;
  const Choice& listed_;
  std::vector<std::vector<LegJoint>> legs_;
  std::size_t usual_depth_ = 0;  // of the actuated joints in their legs
  Edits found_;
};

// The base as it is where they have none together.
std::size_t usual_link_of_actuation(const Subject& s) {
  std::size_t base = s.resolved.base;
  std::ptrdiff_t most = 1;
  const Choice& actuated = s.resolved.actuated_joints.variables;
  for (const std::size_t variable : actuated) {
    const std::size_t link = s.tree.joint_of(variable).parent;
    const auto count = std::count_if(actuated.begin(), actuated.end(), [&](std::size_t other) {
      return body_of(s.tree, s.tree.joint_of(other).parent) == body_of(s.tree, link);
    });
    if (count > most) base = link;
    most = std::max(most, count);
  }
  return base;
}

}  // namespace

Edits actuation_edits(const Subject& subject) { return ActuationEdits(subject).find(); }

Edits base_edits(const Subject& subject) {
  const Tree& tree = subject.tree;
  const std::size_t present = subject.resolved.base, usual = usual_link_of_actuation(subject);
  const bool is_elsewhere = body_of(tree, usual) != body_of(tree, present);
  const std::size_t base = is_elsewhere ? usual : 0;
  if (body_of(tree, base) == body_of(tree, present) || body_of(tree, base) == subject.platform()) return {};
  return {edit_of(
      subject,
      subject.files.config + " has " + subject.files.key("base_link") + " " + subject.link(present) +
          (is_elsewhere ? ", which is not where the actuated joints are fixed"
                        : ", while the tree of " + subject.files.urdf + " starts at link " + subject.link(0)),
      {BaseChange{base}})};
}

Edits operational_point_edits(const Subject& subject) {
  const Tree& tree = subject.tree;
  const std::size_t point = subject.resolved.actuated_joints.platform_link;
  std::vector<std::size_t> links, once, joints_at(tree.links.size(), 0);
  for (const Closure& closure : subject.resolved.closures)
    for (const LinkFrame& frame : closure.frames) links.push_back(frame.link);
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable && subject.system.in_loop()[*joint.variable]) ++joints_at[joint.parent];
  for (std::size_t link = 0; link < joints_at.size(); ++link)
    if (joints_at[link] > 1) links.push_back(link);
  Edits found;
  for (const std::size_t link : links) {
    if (link == subject.resolved.base || link == point || lists(once, link) || once.size() == max_points)
      continue;
    once.push_back(link);
    found.push_back(edit_of(subject,
                            subject.files.config + " has " +
                                operational_point_text(tree, point, subject.files) + ", but the legs of " +
                                subject.files.urdf + " meet in link " + subject.link(link),
                            {PointChange{link}}));
  }
  return found;
}

}  // namespace parallel_aspects
