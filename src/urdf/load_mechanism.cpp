// SPDX-License-Identifier: BSD-3-Clause
#include "model/number_text.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/closing/ends_of_loops.h"
#include "urdf/closing/planar_layers.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/corrections/culprit.h"
#include "urdf/corrections/unit_corrections.h"
#include "urdf/description/yaml_document.h"
#include "urdf/load_search.h"
#include "urdf/mechanism_contents.h"
#include "urdf/open_choices.h"
#include "urdf/reading/tree_reader.h"
#include "urdf/recognition/leg_recognition.h"
#include "urdf/recognition/passive_chain.h"
#include "urdf/recognition/passive_limits.h"
#include "urdf/recognition/platform_motion.h"
#include "urdf/stated_constraints.h"
#include "urdf/symmetrizing.h"
#include "urdf/trial_poses.h"

#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

// Six for each leg of a hexapod, and twenty; the time to assemble a mechanism grows with their third power.
constexpr std::size_t max_closures = 36;
constexpr std::ptrdiff_t max_joints_in_loops = 120;

std::string number(double value) { return number_text(value, 3); }

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

// Everything after names: assembles the mechanism, recognises it and proves the result on random poses.
class Recogniser {
 public:
  Recogniser(std::shared_ptr<const Tree> tree, const MechanismConfig& config, const ResolvedConfig& resolved,
             const SourceNames& files, const LoadSearch& search)
      : tree_(std::move(tree)), config_(config), resolved_(resolved), files_(files), search_(search) {}

  /// With closures of these types; nothing, and `problems`, where they do not make a manipulator.
  std::unique_ptr<Mechanism::Contents> recognise(const std::vector<Closure>& closures,
                                                 Problems& problems) const {
    search_.checkpoint();
    const ClosureSystem system(tree_, resolved_.base, closures);
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
    check_task_space(*motion, problems);
    if (!problems.empty()) return nullptr;
    auto contents = build(system, assembly, *motion, legs, passive, problems);
    if (contents) close_trial_poses(*contents, files_, problems);
    return problems.empty() ? std::move(contents) : nullptr;
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
      const std::string names = joint_names_of(one.chains.front());
      if (!moves)
        problems.push_back(
            files_.config + " actuates none of the joints " + names +
            ", which make one leg; add one of them to actuated_joints, or take the leg out of the "
            "URDF.");
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
    std::string names;
    for (std::size_t joint = 0; joint < still.size(); ++joint)
      if (still[joint]) names += (names.empty() ? "'" : ", '") + tree_->joint_of(joint).name + "'";
    contents.notes.push_back("The loops of " + files_.urdf +
                             " hold joints still, which are taken as fixed: " + names + ".");
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
                         number(gap) + " m; check the lengths, the joint limits and the frames of its loop.");
    else
      problems.push_back(cannot + "the frames of the closures meet, but their directions stay " +
                         number(error) +
                         " rad apart; check the axes of the frames and the types of the closures.");
  }

  std::vector<RecognisedLeg> recognise_legs(const std::vector<LegChains>& legs, const ClosureSystem& system,
                                            const Eigen::VectorXd& values, const PlatformMotion& motion,
                                            Problems& problems) const {
    std::vector<RecognisedLeg> recognised;
    for (const LegChains& leg : legs) {
      const std::size_t variable = resolved_.actuated_joints.variables[leg.actuation];
      const LegSetting setting{&motion, system.size(), values[static_cast<Eigen::Index>(variable)],
                               tree_->joint_of(variable).limits, "leg_" + std::to_string(leg.actuation + 1)};
      if (auto found = recognise_leg(leg, variable, setting, files_.urdf, problems))
        recognised.push_back(*found);
    }
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
    for (const RecognisedLeg& leg : legs) description.legs.push_back(leg.leg);
    return description;
  }

  static Constraints constraints_of(const FoundPassiveLimits& limits, const SlideBounds& bounds) {
    Constraints constraints;
    constraints.passive_limits = limits.limits;
    constraints.passive_cones = limits.cones;
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
      symmetrize_legs(*contents, config_.symmetrize, files_);
      add_joints(*contents);
      return contents;
    } catch (const InvalidDescription& invalid) {
      for (const std::string& problem : invalid.problems()) problems.push_back(files_.urdf + ": " + problem);
      return nullptr;
    }
  }

  std::vector<std::string> notes_of(const std::vector<RecognisedLeg>& legs,
                                    const std::vector<PassiveChain>& passive, const SlideBounds& bounds,
                                    TaskSpace space) const {
    std::vector<std::string> notes = notes_on(passive, bounds, *tree_, space);
    for (const RecognisedLeg& leg : legs) {
      const double range = leg.leg.limits.upper - leg.leg.limits.lower;
      if (range > locked_range) continue;
      notes.push_back(files_.urdf + " lets actuated joint '" + leg.leg.actuated_joint + "' move by only " +
                      number(range) + (leg.leg.actuated_by_angle() ? " rad" : " m") +
                      ", which leaves next to nothing for a map; widen its limits, or fix the joint and take "
                      "it out of actuated_joints.");
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

void check_closures(const std::vector<Closure>& closures, const SourceNames& files, Problems& problems) {
  if (closures.size() > max_closures)
    problems.push_back(files.config + " and " + files.urdf + " describe " + std::to_string(closures.size()) +
                       " closures, and at most " + std::to_string(max_closures) +
                       " are treated; a robot needs one for each loop.");
}

// Which joints are in the loops does not depend on the types.
ClosureSystem loops_of(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved) {
  return {tree, resolved.base, with_type(resolved.closures, ClosureType::point)};
}

// Of those that are in no loop.
std::optional<std::string> joints_left_out(const ClosureSystem& loops, const SourceNames& files) {
  std::string names;
  for (std::size_t joint = 0; joint < loops.in_loop().size(); ++joint)
    if (!loops.in_loop()[joint])
      names += (names.empty() ? "'" : ", '") + loops.tree().joint_of(joint).name + "'";
  if (names.empty()) return std::nullopt;
  return files.urdf +
         " has joints that no closure puts in a loop, which are no part of the robot here: " + names + ".";
}

// What shows before anything is assembled. Of the joints that a URDF calls actuated, those outside of the
// loops may be of something else, as a gripper.
void check_ends(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                const SourceNames& files, const LoadSearch& search, const Attempt& attempt) {
  ActuatedJoints listed = resolved.actuated_joints;
  if (!resolved.actuation_origin.empty()) listed.variables.clear();
  Problems problems;
  const ClosureSystem loops = loops_of(tree, resolved);
  const WrongEnds wrong =
      check_joints_in_loops(loops, files, problems) ? find_wrong_ends(loops, listed, files) : WrongEnds{};
  if (problems.empty() && wrong.found.empty()) return;
  const auto joints = std::count(loops.in_loop().begin(), loops.in_loop().end(), true);
  if (search.looks_for_remedies && !resolved.closures.empty() && joints <= max_joints_in_loops) {
    const Problems culprits = find_culprit_of_ends(tree, resolved, wrong, files, attempt);
    if (!culprits.empty()) throw InvalidDescription(culprits);
  }
  throw InvalidDescription(problems.empty() ? wrong.problems() : problems);
}

// Throws where there is none.
std::unique_ptr<Mechanism::Contents> recognise(const std::shared_ptr<const Tree>& tree,
                                               const MechanismConfig& config, const ResolvedConfig& resolved,
                                               const SourceNames& files, const LoadSearch& search) {
  const auto recognise_in = [&](const std::shared_ptr<const Tree>& in, const ResolvedConfig& open,
                                Problems& problems) {
    const Recognise each = [&](const ResolvedConfig& chosen, Problems& found) {
      return Recogniser(in, config, chosen, files, search).recognise(chosen.closures, found);
    };
    return recognise_open(in, open, each, files, problems);
  };
  const Attempt attempt = [&](const auto& changed_tree, const ResolvedConfig& changed) {
    Problems ignored;
    const auto contents = recognise_in(changed_tree, changed, ignored);
    return contents ? std::optional<std::string>(name(contents->manipulator->task_space())) : std::nullopt;
  };
  check_ends(tree, resolved, files, search, attempt);
  Problems problems;
  if (auto contents = recognise_in(tree, resolved, problems)) return contents;
  if (!search.looks_for_remedies) throw InvalidDescription(problems);
  if (const auto culprit = find_culprit(tree, resolved, files, attempt)) throw InvalidDescription({*culprit});
  throw InvalidDescription(problems);
}

// Both texts have been read once, so that they are known to parse, or the problem is known.
ResolvedConfig resolved_names(const Tree& tree, const MechanismConfig& config, const std::string& urdf_text,
                              const std::string& config_text, const SourceNames& files, Problems& problems,
                              std::vector<std::string>& notes) {
  tinyxml2::XMLDocument document;
  document.Parse(urdf_text.data(), urdf_text.size());
  YAML::Node yaml;
  try {
    yaml = yaml_document(config_text);
  } catch (const YAML::Exception&) {
    return {};
  }
  return resolve_config(config, {*document.FirstChildElement("robot"), yaml, tree, files}, problems, notes);
}

// For maps alone: a robot that runs is followed by the numbers of its description.
void take_tolerance(double share, const SourceNames& files, Mechanism::Contents& contents) {
  if (share == 0.0) return;
  contents.mapped_manipulator = contents.mapped_manipulator->with_tolerance(share);
  contents.notes.push_back("By mechanism.tolerance: " + number(share) + " of " + files.config +
                           " maps hold for every robot whose points and lengths are within " +
                           number(contents.mapped_manipulator->tolerance()) + " m of those of " + files.urdf +
                           ".");
}

}  // namespace

SharedMechanism load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                               const std::string& config_text, const std::string& config_name,
                               const std::string& frame_prefix) {
  return load_mechanism(urdf_text, urdf_name, config_text, config_name, frame_prefix, LoadSearch{});
}

SharedMechanism load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                               const std::string& config_text, const std::string& config_name,
                               const std::string& frame_prefix, const LoadSearch& search) {
  Problems problems;
  std::vector<std::string> notes;
  const SourceNames files{urdf_name, config_name};
  MechanismConfig config = read_mechanism_config(config_text, config_name, problems);
  config.frame_prefix = frame_prefix;
  auto tree = read_tree(urdf_text, urdf_name, problems, notes);
  if (!tree) throw InvalidDescription(problems);
  add_operational_point(config.operational_point, files, *tree, problems);
  ResolvedConfig resolved = resolved_names(*tree, config, urdf_text, config_text, files, problems, notes);
  check_closures(resolved.closures, files, problems);
  if (!problems.empty()) throw InvalidDescription(problems);
  for (const std::string& note : leave_out_repeated(resolved.closures, files)) notes.push_back(note);
  for (const std::string& note :
       join_layers(*tree, resolved.actuated_joints.platform_link, files, resolved.closures))
    notes.push_back(note);
  const auto open_tree = std::make_shared<const Tree>(std::move(*tree));
  auto contents = recognise(open_tree, config, resolved, files, search);
  const ClosureSystem loops = loops_of(open_tree, resolved);
  if (const auto note = joints_left_out(loops, files)) notes.push_back(*note);
  for (const std::string& note :
       unit_notes(*open_tree, LoopJoints(*open_tree, resolved.closures, loops.size()), loops.size(), files))
    notes.push_back(note);
  Problems of_constraints;
  add_stated_constraints(config.constraints, config.symmetrize, files, *contents, of_constraints);
  if (!of_constraints.empty()) throw InvalidDescription(of_constraints);
  take_tolerance(config.tolerance, files, *contents);
  contents->notes.insert(contents->notes.begin(), notes.begin(), notes.end());
  return SharedMechanism(std::make_shared<const Mechanism>(std::move(contents)));
}

}  // namespace parallel_aspects
