// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/edit.h"

#include "model/message_text.h"
#include "urdf/description/xml_values.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double rounding = 1e-9;  // of the longest coordinate, which adding up rounded frames leaves

std::string listed(const Eigen::Vector3d& vector, const std::string& between) {
  const double least = rounding * vector.lpNorm<Eigen::Infinity>();
  std::string text;
  for (Eigen::Index k = 0; k < 3; ++k)
    text += (k == 0 ? "" : between) + coordinate_text(std::abs(vector[k]) < least ? 0.0 : vector[k]);
  return text;
}

}  // namespace

std::string as_attribute(const Eigen::Vector3d& vector) { return listed(vector, " "); }

std::string in_brackets(const Eigen::Vector3d& vector) { return "(" + listed(vector, ", ") + ")"; }

std::string as_list(const Eigen::Vector3d& vector) { return "[" + listed(vector, ", ") + "]"; }

namespace {

// As an attribute of the elements of a URDF, whose words differ.
bool has_attributes(const ResolvedConfig& resolved) {
  return resolved.closure_dialect == "<gazebo><joint>" || resolved.closure_dialect == "<loop_joint>" ||
         resolved.closure_dialect == "<constraint>";
}

}  // namespace

std::string type_word(const ResolvedConfig& resolved, ClosureType type) {
  const bool is_constraint = resolved.closure_dialect == "<constraint>";
  std::string word(name(type));
  if (has_attributes(resolved) && type == ClosureType::point)
    word = resolved.closure_dialect == "<gazebo><joint>" ? "ball" : "spherical";
  return is_constraint ? word + "_joint" : word;
}

std::string type_text(const ResolvedConfig& resolved, ClosureType type) {
  return has_attributes(resolved) ? "type=\"" + type_word(resolved, type) + "\""
                                  : "type: " + type_word(resolved, type);
}

Subject::Subject(std::shared_ptr<const Tree> of, const ResolvedConfig& config, const SourceNames& names)
    : shared_tree(std::move(of)),
      tree(*shared_tree),
      resolved(config),
      files(names),
      system(shared_tree, config.base, with_type(config.closures, ClosureType::point)),
      loops(tree, config.closures, system.size()) {}

bool Subject::is_actuated(std::size_t joint) const {
  const auto& actuated = resolved.actuated_joints.variables;
  const auto variable = tree.joints[joint].variable;
  return variable && std::find(actuated.begin(), actuated.end(), *variable) != actuated.end();
}

std::string Subject::joint(std::size_t joint) const { return "joint '" + tree.joints[joint].name + "'"; }

std::string Subject::closure(std::size_t closure) const {
  return "closure '" + resolved.closures[closure].name + "'";
}

std::string Subject::link(std::size_t link) const { return "'" + tree.links[link] + "'"; }

bool Subject::is_closed(std::size_t link) const {
  return std::any_of(resolved.closures.begin(), resolved.closures.end(), [&](const Closure& closure) {
    return closure.frames[0].link == link || closure.frames[1].link == link;
  });
}

namespace {

std::string type_name(JointMotion type) {
  if (type == JointMotion::fixed) return "fixed";
  return type == JointMotion::revolute ? "continuous" : "prismatic";
}

// What one change concerns, and what is to be written for it.
struct ChangeText {
  std::string element, remedy;
};

class ChangeWriter {
 public:
  explicit ChangeWriter(const Subject& subject) : subject_(subject) {}

  ChangeText operator()(const OriginChange& change) const {
    std::string values;
    if (change.place) values = "xyz=\"" + as_attribute(*change.place) + "\"";
    if (change.angles)
      values += (values.empty() ? "rpy=\"" : " rpy=\"") + as_attribute(*change.angles) + "\"";
    return of_joint(change.joint, values + " in the origin of ");
  }
  ChangeText operator()(const MotionChange& change) const {
    const TreeJoint& joint = subject_.tree.joints[change.joint];
    const bool other_type = change.motion != joint.motion;
    const bool other_axis =
        change.motion != JointMotion::fixed &&
        (joint.motion == JointMotion::fixed || (change.axis - joint.axis).norm() > rank_tolerance);
    return of_joint(change.joint,
                    (other_type ? "type=\"" + type_name(change.motion) + "\"" : "") +
                        (other_type && other_axis ? " and " : "") +
                        (other_axis ? "<axis xyz=\"" + as_attribute(change.axis) + "\"/>" : "") + " for ");
  }
  ChangeText operator()(const LimitsChange& change) const {
    return of_joint(change.joint, "lower=\"" + number_text(change.lower) + "\" upper=\"" +
                                      number_text(change.upper) + "\" for ");
  }
  ChangeText operator()(const ParentChange& change) const {
    return of_joint(change.joint, "<parent link=\"" + subject_.tree.links[change.parent] + "\"/> for ");
  }
  ChangeText operator()(const JointAddition& added) const {
    const TreeJoint& next = subject_.tree.joints[added.next];
    const std::string &parent = added.is_before ? subject_.tree.links[next.parent] : added.name,
                      &child = added.is_before ? added.name : subject_.tree.links[next.child];
    const std::string element = subject_.joint(added.next);
    return {"leg of " + element,
            "add <link name=\"" + added.name + "\"/><joint name=\"" + added.name + "\" type=\"" +
                type_name(added.motion) + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
                "\"/><axis xyz=\"" + as_attribute(added.axis) + "\"/></joint> and write <" +
                (added.is_before ? "parent" : "child") + " link=\"" + added.name + "\"/> for " + element};
  }
  ChangeText operator()(const FrameChange& change) const {
    const LinkFrame& present = subject_.resolved.closures[change.closure].frames[change.end];
    const std::string element = subject_.closure(change.closure);
    if (change.frame.link != present.link)
      return {element, "write link " + subject_.link(change.frame.link) + " in the place of " +
                           subject_.link(present.link) + " in " + element};
    return {element, "write " + place(change.frame.in_link.translation()) + " in link " +
                         subject_.link(present.link) + " of " + element};
  }
  ChangeText operator()(const TypeChange& change) const {
    const std::string element = subject_.closure(change.closure);
    return {element, "write " + type_text(subject_.resolved, change.type) + " for " + element};
  }
  ChangeText operator()(const ClosureAddition& added) const {
    const auto& [one, other] = added.closure.frames;
    const std::string &first = subject_.tree.links[one.link], &second = subject_.tree.links[other.link];
    const bool described = !subject_.resolved.closure_dialect.empty();
    const std::string pair = shell_word(first + "=" + second),
                      element = "closure '" + added.closure.name + "'";
    if (subject_.files.as_options)
      return {element, described ? "add --closures " + pair : "add " + pair + " to --closures"};
    return {element, "add {frames: [" + first + ", " + second +
                         "], type: " + std::string(name(added.closure.type)) + "} to mechanism." +
                         (described ? "added_closures" : "closures")};
  }
  ChangeText operator()(const ActuationChange& change) const {
    std::vector<std::string> names;
    for (const std::size_t variable : change.variables)
      names.push_back(subject_.tree.joint_of(variable).name);
    return {"actuated_joints", "write " + subject_.files.entry("actuated_joints", names)};
  }
  ChangeText operator()(const BaseChange& change) const {
    return {"base_link", "write " + subject_.files.entry("base_link", subject_.tree.links[change.link])};
  }
  ChangeText operator()(const PointChange& change) const {
    return {"operational_point",
            "write " + subject_.files.entry("operational_point", subject_.tree.links[change.link])};
  }

 private:
  ChangeText of_joint(std::size_t joint, const std::string& written) const {
    const std::string element = subject_.joint(joint);
    return {element, "write " + written + element};
  }

  // How the description says it.
  std::string place(const Eigen::Vector3d& place) const {
    const std::string& dialect = subject_.resolved.closure_dialect;
    if (dialect.empty()) return "xyz: " + as_list(place);
    if (dialect == "<gazebo><joint>") return "<pose> starting with " + as_attribute(place);
    return (dialect == "<drake:ball_constraint>" ? "value=\"" : "xyz=\"") + as_attribute(place) + "\"";
  }

  const Subject& subject_;
};

// Those nearer to the root first again.
void sort_joints(Tree& tree) {
  std::vector<bool> placed(tree.links.size(), false);
  placed.front() = true;
  std::vector<TreeJoint> joints;
  while (joints.size() < tree.joints.size())
    for (const TreeJoint& next : tree.joints) {
      if (!placed[next.parent] || placed[next.child]) continue;
      placed[next.child] = true;
      tree.joint_above[next.child] = joints.size();
      if (next.variable) tree.movable[*next.variable] = joints.size();
      joints.push_back(next);
    }
  tree.joints = std::move(joints);
}

class Editor {
 public:
  Editor(Tree& tree, ResolvedConfig& resolved) : tree_(tree), resolved_(resolved) {}

  void operator()(const OriginChange& change) const {
    Eigen::Isometry3d& origin = tree_.joints[change.joint].origin;
    if (change.place) origin.translation() = *change.place;
    if (change.angles) origin.linear() = rotation_of(*change.angles);
  }
  void operator()(const MotionChange& change) const {
    TreeJoint& joint = tree_.joints[change.joint];
    if (joint.motion != change.motion && change.motion != JointMotion::prismatic) joint.limits = {};
    joint.motion = change.motion;
    joint.axis = change.axis.normalized();
    const bool is_movable = change.motion != JointMotion::fixed;
    if (is_movable == joint.variable.has_value()) return;
    if (!is_movable) return remove_variable(joint);
    joint.variable = tree_.movable.size();
    tree_.movable.push_back(change.joint);
  }
  void operator()(const LimitsChange& change) const {
    tree_.joints[change.joint].limits.lower = change.lower;
    tree_.joints[change.joint].limits.upper = change.upper;
  }
  void operator()(const ParentChange& change) const {
    tree_.joints[change.joint].parent = change.parent;
    sort_joints(tree_);
  }
  void operator()(const JointAddition& added) const {
    tree_.links.push_back(added.name);
    tree_.joint_above.emplace_back();
    const std::size_t link = tree_.links.size() - 1;
    TreeJoint& next = tree_.joints[added.next];
    TreeJoint joint;
    joint.name = added.name;
    joint.motion = added.motion;
    joint.axis = added.axis;
    joint.parent = added.is_before ? std::exchange(next.parent, link) : link;
    joint.child = added.is_before ? link : std::exchange(next.child, link);
    joint.variable = tree_.movable.size();
    tree_.movable.push_back(tree_.joints.size());
    tree_.joints.push_back(joint);
    sort_joints(tree_);
  }
  void operator()(const FrameChange& change) const {
    resolved_.closures[change.closure].frames[change.end] = change.frame;
  }
  void operator()(const TypeChange& change) const { resolved_.closures[change.closure].type = change.type; }
  void operator()(const ClosureAddition& added) const { resolved_.closures.push_back(added.closure); }
  void operator()(const ActuationChange& change) const {
    resolved_.actuated_joints.variables = change.variables;
  }
  void operator()(const BaseChange& change) const { resolved_.base = change.link; }
  void operator()(const PointChange& change) const { resolved_.actuated_joints.platform_link = change.link; }

 private:
  void remove_variable(TreeJoint& joint) const {
    const std::size_t removed = *joint.variable;
    joint.variable.reset();
    tree_.movable.erase(tree_.movable.begin() + static_cast<std::ptrdiff_t>(removed));
    for (TreeJoint& other : tree_.joints)
      if (other.variable && *other.variable > removed) --*other.variable;
    for (std::size_t& actuated : resolved_.actuated_joints.variables)
      if (actuated > removed) --actuated;
  }

  Tree& tree_;
  ResolvedConfig& resolved_;
};

void append(std::string& list, const std::string& text, const std::string& between) {
  list += (list.empty() ? "" : between) + text;
}

}  // namespace

Edit edit_of(const Subject& subject, const Note& fault, std::vector<Change> changes, bool like_others) {
  Edit edit{"", fault, "", std::move(changes), like_others};
  for (const Change& change : edit.changes) {
    const ChangeText text = std::visit(ChangeWriter(subject), change);
    append(edit.element, text.element, ", ");
    append(edit.remedy, text.remedy, " and ");
  }
  return edit;
}

Edited edited(const Subject& subject, const Edit& edit) {
  auto tree = std::make_shared<Tree>(subject.tree);
  ResolvedConfig resolved = subject.resolved;
  for (const Change& change : edit.changes) std::visit(Editor(*tree, resolved), change);
  place_at_zero(*tree, resolved.closures);
  return {std::move(tree), std::move(resolved)};
}

Edit together(const Edit& first, const Edit& second) {
  Edit both{first.element, first.fault + ", and " + second.fault, first.remedy + " and " + second.remedy,
            first.changes, false};
  both.changes.insert(both.changes.end(), second.changes.begin(), second.changes.end());
  return both;
}
namespace {

// What of a frame its closure sees.
LinkFrame as_seen(LinkFrame frame, ClosureType type) {
  const bool any_axis = type == ClosureType::universal || type == ClosureType::fixed;
  const bool is_upright = (frame.in_link.linear().col(2) - Eigen::Vector3d::UnitZ()).norm() < 1e-9;
  if (type == ClosureType::point || (!any_axis && is_upright)) frame.in_link.linear().setIdentity();
  return frame;
}

std::string written(const Tree& tree, const LinkFrame& frame, const SourceNames& files) {
  const std::string& link = tree.links[frame.link];
  if (frame.in_link.isApprox(Eigen::Isometry3d::Identity())) return link;
  if (files.as_options)
    return placed_name(link, frame.in_link.translation(), roll_pitch_yaw(frame.in_link.linear()));
  return "{link: " + link + ", xyz: " + as_list(frame.in_link.translation()) +
         ", rpy: " + as_list(roll_pitch_yaw(frame.in_link.linear())) + "}";
}

}  // namespace

Note closures_entry(const Tree& tree, const std::vector<Closure>& closures, const SourceNames& files) {
  std::vector<std::string> list;
  for (const Closure& closure : closures) {
    std::array<std::string, 2> ends;
    for (const std::size_t end : {0, 1})
      ends[end] = written(tree, as_seen(closure.frames[end], closure.type), files);
    list.push_back(files.as_options ? ends[0] + "=" + ends[1]
                                    : "{frames: [" + ends[0] + ", " + ends[1] +
                                          "], type: " + std::string(name(closure.type)) + "}");
  }
  if (files.as_options) return files.entry("closures", list);
  return Note(Note::Piece::Kind::closures, list) + " under mechanism in " + files.config;
}

}  // namespace parallel_aspects
