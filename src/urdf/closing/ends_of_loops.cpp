// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/ends_of_loops.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

// Of each link: the joints that its body carries, each with how many are in the longest chain from it on.
struct Carried {
  std::size_t joint = 0, chain = 0;
};

std::vector<std::vector<Carried>> carried_joints(const Tree& tree) {
  std::vector<std::vector<Carried>> carried(tree.links.size());
  for (std::size_t k = tree.joints.size(); k-- > 0;) {
    const TreeJoint& joint = tree.joints[k];
    if (!joint.variable) continue;
    std::size_t chain = 1;
    for (const Carried& next : carried[joint.child]) chain = std::max(chain, next.chain + 1);
    carried[body_of(tree, joint.parent)].push_back({k, chain});
  }
  return carried;
}

}  // namespace

std::optional<std::string> serial_arm_text(const Tree& tree, const std::string& urdf_name) {
  const std::vector<std::vector<Carried>> carried = carried_joints(tree);
  std::size_t link = 0, joints = 0;
  while (!carried[link].empty()) {
    const auto chains = std::count_if(carried[link].begin(), carried[link].end(),
                                      [](const Carried& each) { return each.chain > 1; });
    const bool is_hand = chains == 0 && carried[link].size() > 1;
    if (chains > 1 || (link == 0 && carried[link].size() > 1)) return std::nullopt;
    if (is_hand) break;
    const auto longest =
        std::max_element(carried[link].begin(), carried[link].end(),
                         [](const Carried& one, const Carried& other) { return one.chain < other.chain; });
    link = tree.joints[longest->joint].child;
    ++joints;
  }
  if (joints == 0) return std::nullopt;
  return urdf_name + " is a serial arm, one chain of " + std::to_string(joints) +
         (joints == 1 ? " joint" : " joints") + " from link '" + tree.links.front() + "' to link '" +
         tree.links[link] +
         "' without a loop; only the command `aspects` treats serial arms, with a YAML as `aspects setup` "
         "writes it.";
}

namespace {

using Variables = std::vector<std::size_t>;

// From one link to a body of the loops.
struct WayIn {
  std::size_t link = 0;  // the first that is fixed to such a body
  Variables passed;      // joints outside of the loops
};

class EndsOfLoops {
 public:
  EndsOfLoops(const ClosureSystem& system, const ActuatedJoints& actuated_joints, const SourceNames& files)
      : tree_(system.tree()),
        in_loop_(system.in_loop()),
        actuated_(actuated_joints.variables),
        files_(files),
        touched_(tree_.links.size(), false) {
    for (const TreeJoint& joint : tree_.joints)
      if (joint.variable && in_loop_[*joint.variable]) touched_[joint.parent] = touched_[joint.child] = true;
    for (const Closure& closure : system.closures())
      for (const LinkFrame& frame : closure.frames) touched_[frame.link] = true;
    spread_over_fixed_joints();
  }

  WrongEnds find(std::size_t base, std::size_t platform) {
    wrong_.base = base;
    wrong_.actuated_joints.variables = actuated_;
    wrong_.actuated_joints.platform_link = platform;
    const auto below = way_in(base, platform), after = way_in(platform, base);
    if (!below || !after) return wrong_;  // the loops are elsewhere
    if (!below->passed.empty()) {
      add(files_.config + " has " + files_.key("base_link") + " '" + tree_.links[base] + "', but " +
              listed(below->passed) + " moves all loops of " + files_.urdf,
          files_.entry("base_link", tree_.links[below->link]), below->passed);
      wrong_.base = below->link;
    }
    if (!after->passed.empty()) {
      add(files_.config + " has " + operational_point_text(tree_, platform, files_) + ", which " +
              listed(after->passed) + " moves against all loops of " + files_.urdf,
          files_.entry("operational_point", tree_.links[after->link]), after->passed);
      wrong_.actuated_joints.platform_link = after->link;
    }
    if (wrong_.found.empty()) find_outside();
    return std::move(wrong_);
  }

 private:
  // Links that are fixed to each other are one body.
  void spread_over_fixed_joints() {
    for (bool changed = true; changed;) {
      changed = false;
      for (const TreeJoint& joint : tree_.joints) {
        if (joint.variable || touched_[joint.parent] == touched_[joint.child]) continue;
        touched_[joint.parent] = touched_[joint.child] = changed = true;
      }
    }
  }

  Variables joints_above(std::size_t link) const {
    Variables joints;
    for (auto joint = tree_.joint_above[link]; joint; joint = tree_.joint_above[tree_.joints[*joint].parent])
      joints.push_back(*joint);
    return joints;
  }

  // Along the tree.
  std::optional<WayIn> way_in(std::size_t from, std::size_t to) const {
    WayIn way{from, {}};
    Variables up = joints_above(from), down = joints_above(to);
    while (!up.empty() && !down.empty() && up.back() == down.back()) {
      up.pop_back();
      down.pop_back();
    }
    std::reverse(down.begin(), down.end());
    const auto go = [&](std::size_t joint, std::size_t next) {
      if (touched_[way.link]) return;
      if (tree_.joints[joint].variable) way.passed.push_back(*tree_.joints[joint].variable);
      way.link = next;
    };
    for (const std::size_t joint : up) go(joint, tree_.joints[joint].parent);
    for (const std::size_t joint : down) go(joint, tree_.joints[joint].child);
    return touched_[way.link] ? std::optional<WayIn>(way) : std::nullopt;
  }

  std::string listed(const Variables& joints) const {
    return (joints.size() == 1 ? "joint " : "each of the joints ") + names(joints);
  }

  std::string quoted(std::size_t joint) const { return "'" + tree_.joint_of(joint).name + "'"; }

  // Where one of these is actuated, it is so no longer.
  void add(const std::string& fault, const std::string& remedy, const Variables& passed) {
    const bool any = std::any_of(passed.begin(), passed.end(), [this](std::size_t joint) {
      return std::find(actuated_.begin(), actuated_.end(), joint) != actuated_.end();
    });
    wrong_.found.push_back({fault, "write " + remedy + (any ? " and " + without(passed) : "")});
    for (const std::size_t joint : passed) leave_out(joint);
  }

  void find_outside() {
    Variables outside;
    for (const std::size_t variable : actuated_)
      if (!in_loop_[variable]) outside.push_back(variable);
    if (outside.empty()) return;
    wrong_.found.push_back({files_.config + " actuates " + (outside.size() == 1 ? "joint " : "the joints ") +
                                names(outside) + ", which " + (outside.size() == 1 ? "is" : "are") +
                                " in no loop of " + files_.urdf,
                            "write " + without(outside)});
    for (const std::size_t joint : outside) leave_out(joint);
  }

  void leave_out(std::size_t joint) {
    Variables& kept = wrong_.actuated_joints.variables;
    kept.erase(std::remove(kept.begin(), kept.end(), joint), kept.end());
  }

  std::string names(const Variables& joints) const {
    std::string text;
    for (const std::size_t joint : joints) text += (text.empty() ? "" : ", ") + quoted(joint);
    return text;
  }

  // The actuated joints but these, as the YAML has them.
  std::string without(const Variables& joints) const {
    std::vector<std::string> kept;
    for (const std::size_t joint : actuated_)
      if (std::find(joints.begin(), joints.end(), joint) == joints.end())
        kept.push_back(tree_.joint_of(joint).name);
    return files_.entry("actuated_joints", kept);
  }

  const Tree& tree_;
  const std::vector<bool>& in_loop_;
  const Variables& actuated_;
  const SourceNames& files_;
  WrongEnds wrong_;
  std::vector<bool> touched_;  // by link: its body has a joint of the loops
};

}  // namespace

Problems WrongEnds::problems() const {
  Problems problems;
  for (const Wrong& wrong : found) problems.push_back(wrong.fault + "; " + wrong.remedy + ".");
  return problems;
}

WrongEnds find_wrong_ends(const ClosureSystem& system, const ActuatedJoints& actuated_joints,
                          const SourceNames& files) {
  return EndsOfLoops(system, actuated_joints, files).find(system.base(), actuated_joints.platform_link);
}

}  // namespace parallel_aspects
