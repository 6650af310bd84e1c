// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/ends_of_loops.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {
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

  void check(std::size_t base, std::size_t platform, Problems& problems) {
    const auto below = way_in(base, platform), after = way_in(platform, base);
    if (!below || !after) return;  // the loops are elsewhere
    if (!below->passed.empty())
      problems.push_back(files_.config + " has base_link '" + tree_.links[base] + "', but " +
                         listed(below->passed) + " moves all loops of " + files_.urdf +
                         "; write base_link: " + tree_.links[below->link] + remedy(below->passed) + ".");
    if (!after->passed.empty())
      problems.push_back(files_.config + " has " + operational_point_text(tree_, platform) + ", which " +
                         listed(after->passed) + " moves against all loops of " + files_.urdf +
                         "; write operational_point: " + tree_.links[after->link] + remedy(after->passed) +
                         ".");
    if (!below->passed.empty() || !after->passed.empty()) return;
    for (const std::size_t variable : actuated_)
      if (!in_loop_[variable])
        problems.push_back(files_.config + " actuates joint '" + tree_.joint_of(variable).name +
                           "', which is in no loop of " + files_.urdf + "; write " + without({variable}) +
                           ", or add the closure of its leg.");
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
    std::string text;
    for (const std::size_t joint : joints) text += (text.empty() ? "" : ", ") + quoted(joint);
    return (joints.size() == 1 ? "joint " : "each of the joints ") + text;
  }

  std::string quoted(std::size_t joint) const { return "'" + tree_.joint_of(joint).name + "'"; }

  // Where one of these is actuated.
  std::string remedy(const Variables& joints) const {
    const bool any = std::any_of(joints.begin(), joints.end(), [this](std::size_t joint) {
      return std::find(actuated_.begin(), actuated_.end(), joint) != actuated_.end();
    });
    return any ? " and " + without(joints) : "";
  }

  // The actuated joints but these, as the YAML has them.
  std::string without(const Variables& joints) const {
    std::string text;
    for (const std::size_t joint : actuated_)
      if (std::find(joints.begin(), joints.end(), joint) == joints.end())
        text += (text.empty() ? "" : ", ") + tree_.joint_of(joint).name;
    return "actuated_joints: [" + text + "]";
  }

  const Tree& tree_;
  const std::vector<bool>& in_loop_;
  const Variables& actuated_;
  const SourceNames& files_;
  std::vector<bool> touched_;  // by link: its body has a joint of the loops
};

}  // namespace

void check_ends_of_loops(const ClosureSystem& system, const ActuatedJoints& actuated_joints,
                         const SourceNames& files, Problems& problems) {
  const auto& in_loop = system.in_loop();
  if (std::find(in_loop.begin(), in_loop.end(), true) == in_loop.end()) return;
  EndsOfLoops(system, actuated_joints, files).check(system.base(), actuated_joints.platform_link, problems);
}

}  // namespace parallel_aspects
