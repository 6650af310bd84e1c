// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/mechanism_recognition.h"

#include "model/message_text.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/closing/freedom.h"
#include "urdf/recognition/leg_recognition.h"
#include "urdf/recognition/passive_chain.h"
#include "urdf/recognition/passive_limits.h"
#include "urdf/recognition/platform_motion.h"
#include "urdf/stated_constraints.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

class Recogniser {
 public:
  Recogniser(std::shared_ptr<const Tree> tree, const MechanismConfig& config, const ResolvedConfig& resolved,
             const SourceNames& files, const LoadSearch& search)
      : tree_(std::move(tree)), config_(config), resolved_(resolved), files_(files), search_(search) {}

  std::unique_ptr<Mechanism::Contents> recognise(Problems& problems) const {
    search_.checkpoint();
    const ClosureSystem system(tree_, resolved_.base, resolved_.closures);
    if (!check_joints_in_loops(system, files_, problems)) return nullptr;
    const AssemblyResult assembled =
        assemble(system, resolved_.actuated_joints.variables, resolved_.actuated_joints.platform_link);
    if (!assembled.assembly) {
      report_gap(system, assembled.closest, problems);
      return nullptr;
    }
    return recognise(system, *assembled.assembly, problems);
  }

 private:
  // As it is; and where that makes no manipulator, with joints that cannot move taken as fixed.
  std::unique_ptr<Mechanism::Contents> recognise(const ClosureSystem& system, const Assembly& assembly,
                                                 Problems& problems) const {
    const std::vector<bool> none(system.in_loop().size(), false);
    auto contents = recognise({system, assembly.values, none}, assembly, problems);
    Problems of_motion;
    if (contents || !find_platform_motion(system, assembly, resolved_.actuated_joints, files_, of_motion))
      return contents;
    const std::vector<bool> still = still_passive_joints(system, assembly);
    if (std::none_of(still.begin(), still.end(), [](bool joint) { return joint; })) return nullptr;
    problems.clear();
    contents = recognise({system, assembly.values, still}, assembly, problems);
    if (contents) note_still_joints(still, *contents);
    return contents;
  }

  std::unique_ptr<Mechanism::Contents> recognise(const AssembledMechanism& mechanism,
                                                 const Assembly& assembly, Problems& problems) const {
    const ClosureSystem& system = mechanism.system;
    const FoundLegs found = find_legs(mechanism, resolved_.actuated_joints, files_, problems);
    Problems of_motion;
    const auto motion = problems.empty() ? find_platform_motion(system, assembly, resolved_.actuated_joints,
                                                                files_, of_motion)
                                         : std::nullopt;
    const auto passive = recognise_passive(found.passive, motion.has_value(), problems);
    if (problems.empty()) problems = of_motion;
    if (!motion || !problems.empty()) return nullptr;
    const auto legs = recognise_legs(found.legs, system, assembly.values, *motion, problems);
    if (!problems.empty()) explain_turning(found.legs, system, *motion, problems);
    check_task_space(*motion, problems);
    if (!problems.empty()) return nullptr;
    auto contents = build(system, assembly, *motion, legs, passive, problems);
    if (contents) close_trial_poses(*contents, files_, problems);
    return problems.empty() ? std::move(contents) : nullptr;
  }

  // Legs with rods in pairs are to hold the orientation; where they do not, their joints meet in no point,
  // but that is not what is wrong.
  void explain_turning(const std::vector<LegChains>& legs, const ClosureSystem& system,
                       const PlatformMotion& motion, Problems& problems) const {
    if (motion.space != TaskSpace::T3 || !motion.point_platform) return;
    if (const auto reason = reason_to_turn(legs, system.size()))
      problems = {
          files_.urdf +
          " lets the platform turn while it moves, since rods in pairs hold its orientation only where "
          "they are parallelograms: " +
          *reason + "."};
  }

  // Where the platform does not move as the actuated joints ask, a chain that couples coordinates is a leg
  // whose actuated joint is not listed.
  std::vector<PassiveChain> recognise_passive(const std::vector<PassiveChains>& found, bool moves,
                                              Problems& problems) const {
    std::vector<PassiveChain> chains;
    for (const PassiveChains& one : found) {
      std::string reason;
      if (auto chain = recognise_passive_chain(one, reason)) {
        chains.push_back(*chain);
        continue;
      }
      const std::string names = joint_names_of(one.chains.front()).text();
      if (!moves)
        problems.push_back(files_.config + " actuates none of the joints " + names +
                           ", which make one leg; add one of them to " + files_.key("actuated_joints") +
                           ", or take the leg out of the URDF.");
      else
        problems.push_back(files_.urdf +
                           " joins the platform to the base by a chain without actuated joint, " + names +
                           ", that " + reason +
                           "; write it as slides along fixed directions first, then revolute joints about "
                           "different axes, three of them orthogonal one to the next, or one ball joint.");
    }
    return chains;
  }

  std::vector<bool> still_passive_joints(const ClosureSystem& system, const Assembly& assembly) const {
    std::vector<bool> still = still_joints(system, assembly);
    for (const std::size_t actuation : resolved_.actuated_joints.variables) still[actuation] = false;
    return still;
  }

  void note_still_joints(const std::vector<bool>& still, Mechanism::Contents& contents) const {
    std::vector<std::string> names;
    for (std::size_t joint = 0; joint < still.size(); ++joint)
      if (still[joint]) names.push_back(tree_->joint_of(joint).name);
    contents.notes.push_back("The loops of " + files_.urdf +
                             " hold joints still, which are taken as fixed: " + listed_names(names) + ".");
  }

  void report_gap(const ClosureSystem& system, const Eigen::VectorXd& closest, Problems& problems) const {
    const auto [gap, index] = system.widest_gap(closest);
    const double error = system.residual(closest).lpNorm<Eigen::Infinity>() / system.size();
    const std::string cannot = files_.urdf + " cannot be closed as " + files_.config + " asks: ";
    const std::string& closure = system.closures()[index].name;
    if (!std::isfinite(gap))
      problems.push_back(cannot + "the frames of closure '" + closure +
                         "' are farther apart than numbers go; check the lengths of its loop.");
    else if (gap > closing_tolerance * system.size())
      problems.push_back(cannot + "the frames of closure '" + closure + "' come no nearer than " +
                         number_text(gap, 3) +
                         " m; check the lengths, the joint limits and the frames of its loop.");
    else
      problems.push_back(cannot + "the frames of the closures meet, but their directions stay " +
                         number_text(error, 3) +
                         " rad apart; check the axes of the frames and the types of the closures.");
  }

  std::vector<RecognisedLeg> recognise_legs(const std::vector<LegChains>& legs, const ClosureSystem& system,
                                            const Eigen::VectorXd& values, const PlatformMotion& motion,
                                            Problems& problems) const {
    std::vector<RecognisedLeg> recognised;
    NamesByReason refused;  // a leg by one of its chains
    for (const LegChains& leg : legs) {
      const std::size_t variable = resolved_.actuated_joints.variables[leg.actuation];
      const LegSetting setting{&motion, system.size(), values[static_cast<Eigen::Index>(variable)],
                               tree_->joint_of(variable).limits, "leg_" + std::to_string(leg.actuation + 1)};
      std::string reason;
      if (auto found = recognise_leg(leg, variable, setting, reason)) {
        recognised.push_back(*found);
        continue;
      }
      add_name(reason, names_of(leg.chains.front()), refused);
    }
    for (const auto& [reason, names] : refused)
      problems.push_back(files_.urdf + " has " +
                         (names.size() == 1 ? "a leg through " + names.front() + " that "
                                            : std::to_string(names.size()) + " legs, as that through " +
                                                  names.front() + ", each of which ") +
                         reason +
                         (names.size() == 1 ? "; it is not a distance leg" : "; they are no distance legs") +
                         " and cannot be treated.");
    return recognised;
  }

  void check_task_space(const PlatformMotion& motion, Problems& problems) const {
    if (config_.task_space && *config_.task_space != motion.space)
      problems.push_back(files_.config + " states mechanism.task_space " +
                         std::string(name(*config_.task_space)) + ", but the platform moves in " +
                         std::string(name(motion.space)) + "; correct it or leave it out.");
  }

  // Without constraints.
  ManipulatorDescription describe(const PlatformMotion& motion,
                                  const std::vector<RecognisedLeg>& legs) const {
    ManipulatorDescription description;
    description.name = config_.name.empty() ? tree_->name : config_.name;
    description.task_space = motion.space;
    description.base_frame =
        (config_.frame_prefix.empty() ? "" : config_.frame_prefix + "/") + tree_->links[resolved_.base];
    description.task_frame = motion.task_frame;
    description.hinges = motion.hinges;
    for (const RecognisedLeg& leg : legs) description.legs.push_back(leg.leg);
    return description;
  }

  static Constraints constraints_of(const FoundPassiveLimits& limits, const SlideBounds& bounds) {
    Constraints constraints;
    constraints.passive_limits = limits.limits;
    constraints.passive_cones = limits.cones;
    constraints.hinge_limits = limits.hinges;
    constraints.missing_joints = limits.missing;
    constraints.workspace = bounds.box;
    return constraints;
  }

  std::unique_ptr<Mechanism::Contents> build(const ClosureSystem& system, const Assembly& assembly,
                                             const PlatformMotion& motion,
                                             const std::vector<RecognisedLeg>& legs,
                                             const std::vector<PassiveChain>& passive,
                                             Problems& problems) const {
    ManipulatorDescription description = describe(motion, legs);
    const SlideBounds bounds = slide_bounds(passive, system, assembly.values, motion, description.legs);
    description.constraints =
        constraints_of(find_passive_limits(system, assembly.values, motion, legs, bounds.slides), bounds);
    try {
      auto contents = std::unique_ptr<Mechanism::Contents>(new Mechanism::Contents{
          std::make_shared<const Manipulator>(description),
          nullptr,
          tree_->links[resolved_.actuated_joints.platform_link],
          config_.operational_point.name.empty() ? "platform" : config_.operational_point.name,
          {},
          {},
          notes_of(legs, passive, bounds, motion.space),
          static_cast<int>(motion.mobility),
          static_cast<int>(motion.idle),
          assembly.residual,
          Completion(system, assembly.values, motion, legs, passive, resolved_.actuated_joints.variables),
          motion.point_platform});
      symmetrize_legs(*contents, config_, files_);
      add_joints(*contents);
      return contents;
    } catch (const InvalidDescription& invalid) {
      for (const std::string& problem : invalid.problems()) problems.push_back(files_.urdf + ": " + problem);
      return nullptr;
    }
  }

  Notes notes_of(const std::vector<RecognisedLeg>& legs, const std::vector<PassiveChain>& passive,
                 const SlideBounds& bounds, TaskSpace space) const {
    Notes notes = notes_on(passive, bounds, *tree_, space);
    for (const RecognisedLeg& leg : legs) {
      const double range = leg.leg.limits.upper - leg.leg.limits.lower;
      if (range > locked_range) continue;
      notes.push_back(files_.urdf + " lets actuated joint '" + leg.leg.actuated_joint + "' move by only " +
                      number_text(range, 3) + (leg.leg.actuated_by_angle() ? " rad" : " m") +
                      ", which leaves next to nothing for a map; widen its limits, or fix the joint and take "
                      "it out of " +
                      files_.key("actuated_joints") + ".");
    }
    return notes;
  }

  void add_joints(Mechanism::Contents& contents) const {
    for (const std::size_t joint : tree_->movable) {
      contents.joint_names.push_back(tree_->joints[joint].name);
      contents.joint_limits.push_back(tree_->joints[joint].limits);
    }
  }

  static constexpr double locked_range = 1e-3;  // of an actuated joint that hardly moves [rad or m]

  std::shared_ptr<const Tree> tree_;
  const MechanismConfig& config_;
  const ResolvedConfig& resolved_;
  const SourceNames& files_;
  const LoadSearch& search_;
};

}  // namespace

bool check_joints_in_loops(const ClosureSystem& system, const SourceNames& files, Problems& problems) {
  const auto count = std::count(system.in_loop().begin(), system.in_loop().end(), true);
  if (count == 0)
    problems.push_back(files.config + " closes only frames that no joint of " + files.urdf +
                       " moves against one another; name frames at the two ends of each loop.");
  if (count > max_joints_in_loops)
    problems.push_back(files.urdf + " has " + std::to_string(count) +
                       " movable joints in its loops, and at most " + std::to_string(max_joints_in_loops) +
                       " are treated; fix those that hardly move.");
  return count > 0 && count <= max_joints_in_loops;
}

std::unique_ptr<Mechanism::Contents> recognise_mechanism(const std::shared_ptr<const Tree>& tree,
                                                         const MechanismConfig& config,
                                                         const ResolvedConfig& resolved,
                                                         const SourceNames& files, const LoadSearch& search,
                                                         Problems& problems) {
  return Recogniser(tree, config, resolved, files, search).recognise(problems);
}

}  // namespace parallel_aspects
