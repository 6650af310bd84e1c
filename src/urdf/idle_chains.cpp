// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/idle_chains.h"

#include "urdf/closing/actuation_choices.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/recognition/passive_chain.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr int starts_of_one = 4;  // of which zero, where most robots are drawn closed, is the first

// As they hold most.
std::vector<Closure> as_drawn(std::vector<Closure> closures) {
  for (Closure& closure : closures)
    if (closure.type == ClosureType::automatic)
      closure.type = closure.weld == Weld::none ? ClosureType::point : ClosureType::fixed;
  return closures;
}

std::vector<bool> joints_in_loops(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved) {
  return ClosureSystem(tree, resolved.base, as_drawn(resolved.closures)).in_loop();
}

bool has_joint(const std::vector<Chain>& chains, std::size_t joint) {
  return std::any_of(chains.begin(), chains.end(), [joint](const Chain& chain) {
    return std::any_of(chain.begin(), chain.end(),
                       [joint](const Pivot& pivot) { return pivot.variable == joint; });
  });
}

bool share_a_joint(const std::vector<Chain>& some, const std::vector<Chain>& others) {
  return std::any_of(some.begin(), some.end(), [&](const Chain& chain) {
    return std::any_of(chain.begin(), chain.end(), [&](const Pivot& pivot) {
      return pivot.variable && has_joint(others, *pivot.variable);
    });
  });
}

// Those that hold the platform in no way while their actuated joints are locked, with these.
std::vector<std::vector<Chain>> idle_chains(const std::shared_ptr<const Tree>& tree,
                                            const ResolvedConfig& resolved, const SourceNames& files) {
  const ClosureSystem system(tree, resolved.base, as_drawn(resolved.closures));
  const auto closed = closed_configurations(system, starts_of_one, 1);
  if (closed.empty()) return {};
  const std::vector<bool> none(system.in_loop().size(), false);
  std::vector<bool> locked = none;
  for (const std::size_t joint : resolved.actuated_joints.variables) locked[joint] = true;
  const ActuatedJoints& joints = resolved.actuated_joints;
  std::vector<std::vector<Chain>> idle;
  for (const JoiningPart& whole : joining_parts({system, closed.front(), none}, joints, files))
    for (const JoiningPart& part : joining_parts({system, closed.front(), locked}, joints, files))
      if (part.freedom == 6 && share_a_joint(part.chains, whole.chains)) idle.push_back(whole.chains);
  return idle;
}

// Those that were in a loop before and are in none now.
std::vector<std::size_t> taken_out(const std::vector<bool>& before, const std::vector<bool>& after) {
  std::vector<std::size_t> joints;
  for (std::size_t joint = 0; joint < before.size(); ++joint)
    if (before[joint] && !after[joint]) joints.push_back(joint);
  return joints;
}

// Those of the actuated joints that are in these chains, as where the platform hangs on one of them.
std::vector<std::size_t> motors_in(const std::vector<Chain>& chains, const ResolvedConfig& resolved) {
  std::vector<std::size_t> motors;
  for (const std::size_t joint : resolved.actuated_joints.variables)
    if (has_joint(chains, joint)) motors.push_back(joint);
  return motors;
}

void leave_out(const std::vector<std::size_t>& motors, ResolvedConfig& resolved) {
  auto& actuated = resolved.actuated_joints.variables;
  for (const std::size_t motor : motors)
    actuated.erase(std::remove(actuated.begin(), actuated.end(), motor), actuated.end());
}

// Opens what puts the joints of these chains into loops. Nothing where they are a passive chain that is
// recognised, or nothing would be left.
std::optional<ResolvedConfig> without(const std::vector<Chain>& chains,
                                      const std::shared_ptr<const Tree>& tree,
                                      const ResolvedConfig& resolved) {
  const std::vector<bool> before = joints_in_loops(tree, resolved);
  ResolvedConfig fewer = resolved;
  for (std::size_t k = fewer.closures.size(); k-- > 0;) {
    ResolvedConfig opened = fewer;
    opened.closures.erase(opened.closures.begin() + static_cast<std::ptrdiff_t>(k));
    const auto joints = taken_out(before, joints_in_loops(tree, opened));
    if (std::any_of(joints.begin(), joints.end(),
                    [&](std::size_t joint) { return has_joint(chains, joint); }))
      fewer = std::move(opened);
  }
  if (fewer.closures.empty() || fewer.closures.size() == resolved.closures.size()) return std::nullopt;
  leave_out(taken_out(before, joints_in_loops(tree, fewer)), fewer);
  std::string unused;
  const bool drives = fewer.actuated_joints.variables.size() < resolved.actuated_joints.variables.size();
  return drives || !recognise_passive_chain({chains, false}, unused) ? std::optional(fewer) : std::nullopt;
}

Note names_of(const Tree& tree, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t joint : joints) names.push_back(tree.joint_of(joint).name);
  return listed_names(std::move(names));
}

}  // namespace

std::optional<Note> leave_out_idle_chains(const std::shared_ptr<const Tree>& tree, const SourceNames& files,
                                          ResolvedConfig& resolved) {
  ResolvedConfig fewer = resolved;
  std::vector<std::size_t> idle;
  for (const std::vector<Chain>& chains : idle_chains(tree, resolved, files)) {
    const std::vector<std::size_t> motors = motors_in(chains, fewer);
    if (auto left = without(chains, tree, fewer)) {
      fewer = std::move(*left);
    } else {
      leave_out(motors, fewer);
      idle.insert(idle.end(), motors.begin(), motors.end());
    }
  }
  if (!is_actuation_count(fewer.actuated_joints.variables.size())) return std::nullopt;
  if (fewer.closures.size() == resolved.closures.size()) {
    if (idle.empty()) return std::nullopt;
    resolved = std::move(fewer);
    return files.urdf +
           " hangs the platform on a chain that takes nothing from it, even with its actuated joints locked; "
           "these move nothing else and are not taken as actuated: " +
           names_of(*tree, idle) + ".";
  }
  const std::vector<bool> before = joints_in_loops(tree, resolved);
  resolved = std::move(fewer);
  return files.urdf +
         " has a chain between base and platform that takes nothing from the platform, even with "
         "its actuated joints locked; it is left out: " +
         names_of(*tree, taken_out(before, joints_in_loops(tree, resolved))) + ".";
}

}  // namespace parallel_aspects
