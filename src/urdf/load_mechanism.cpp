// SPDX-License-Identifier: BSD-3-Clause
#include "model/coefficients.h"
#include "model/number_text.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/description/yaml_document.h"
#include "urdf/mechanism_contents.h"
#include "urdf/reading/tree_reader.h"
#include "urdf/recognition/leg_recognition.h"
#include "urdf/recognition/passive_limits.h"
#include "urdf/recognition/platform_motion.h"

#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

namespace parallel_aspects {
namespace {

// Of these all combinations of two types are tried.
constexpr std::size_t most_mixed_closures = 5;

// Six for each leg of a hexapod, and twenty; the time to assemble a mechanism grows with their third power.
constexpr std::size_t most_closures = 36;
constexpr std::ptrdiff_t most_joints_in_loops = 120;

std::string number(double value) { return number_text(value, 3); }

std::vector<Closure> with_type(std::vector<Closure> closures, ClosureType type) {
  for (Closure& closure : closures)
    if (closure.type == ClosureType::automatic) closure.type = type;
  return closures;
}

// Everything after names: assembles the mechanism, recognises it and proves the result on random poses.
class Recogniser {
 public:
  Recogniser(std::shared_ptr<const Tree> tree, const MechanismConfig& config, const ResolvedConfig& resolved,
             const SourceNames& files)
      : tree_(std::move(tree)), config_(config), resolved_(resolved), files_(files) {}

  /// With closures of these types; nothing, and `problems`, where they do not make a manipulator.
  std::unique_ptr<Mechanism::Contents> recognise(const std::vector<Closure>& closures,
                                                 Problems& problems) const {
    const ClosureSystem system(tree_, resolved_.base, closures);
    if (!check_joints_in_loops(system, problems)) return nullptr;
    const AssemblyResult assembled = assemble(system, resolved_.actuated_joints.variables);
    if (!assembled.assembly) {
      report_gap(system, assembled.closest, problems);
      return nullptr;
    }
    return recognise(system, *assembled.assembly, problems);
  }

 private:
  bool check_joints_in_loops(const ClosureSystem& system, Problems& problems) const {
    const auto count = std::count(system.in_loop().begin(), system.in_loop().end(), true);
    if (count == 0)
      problems.push_back(files_.config + " closes only frames that no joint of " + files_.urdf +
                         " moves against one another; name frames at the two ends of each loop.");
    if (count > most_joints_in_loops)
      problems.push_back(files_.urdf + " has " + std::to_string(count) +
                         " movable joints in its loops, and at most " + std::to_string(most_joints_in_loops) +
                         " are treated; fix those that hardly move.");
    return count > 0 && count <= most_joints_in_loops;
  }

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
    const auto chains = find_legs(mechanism, resolved_.actuated_joints, files_, problems);
    if (!problems.empty()) return nullptr;
    const auto motion = find_platform_motion(system, assembly, resolved_.actuated_joints, files_, problems);
    if (!motion) return nullptr;
    const auto legs = recognise_legs(chains, system, assembly.values, *motion, problems);
    check_task_space(*motion, problems);
    if (!problems.empty()) return nullptr;
    auto contents = build(system, assembly, *motion, legs, problems);
    if (contents) prove(*contents, problems);
    return problems.empty() ? std::move(contents) : nullptr;
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
    if (gap > closing_tolerance * system.size())
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

  std::unique_ptr<Mechanism::Contents> build(const ClosureSystem& system, const Assembly& assembly,
                                             const PlatformMotion& motion,
                                             const std::vector<RecognisedLeg>& legs,
                                             Problems& problems) const {
    ManipulatorDescription description;
    description.name = config_.name.empty() ? tree_->name : config_.name;
    description.task_space = motion.space;
    description.base_frame =
        (config_.frame_prefix.empty() ? "" : config_.frame_prefix + "/") + tree_->links[resolved_.base];
    description.task_frame = motion.task_frame;
    for (const RecognisedLeg& leg : legs) description.legs.push_back(leg.leg);
    const FoundPassiveLimits passive = find_passive_limits(system, assembly.values, motion, legs);
    description.constraints.passive_limits = passive.limits;
    description.constraints.passive_cones = passive.cones;
    description.constraints.missing_joints = passive.missing;
    try {
      auto contents = std::unique_ptr<Mechanism::Contents>(new Mechanism::Contents{
          std::make_shared<const Manipulator>(description),
          tree_->links[resolved_.actuated_joints.platform_link],
          {},
          {},
          {},
          static_cast<int>(motion.mobility),
          static_cast<int>(motion.idle),
          assembly.residual,
          Completion(system, assembly.values, motion, legs, resolved_.actuated_joints.variables),
          motion.point_platform});
      for (const std::size_t joint : tree_->movable) {
        contents->joint_names.push_back(tree_->joints[joint].name);
        contents->joint_limits.push_back(tree_->joints[joint].limits);
      }
      return contents;
    } catch (const InvalidDescription& invalid) {
      for (const std::string& problem : invalid.problems()) problems.push_back(files_.urdf + ": " + problem);
      return nullptr;
    }
  }

  // Random poses, near and far, in random working modes: each must close every loop.
  void prove(Mechanism::Contents& contents, Problems& problems) const {
    const Manipulator& manipulator = *contents.manipulator;
    const Completion& completion = contents.completion;
    const std::vector<WorkingMode> modes = working_modes(manipulator);
    std::mt19937 random(trial_seed);
    double worst = completion.residual(
        completion.joint_values(completion.reference_pose(), completion.reference_joints()));
    for (int trial = 0; trial < trials; ++trial) {
      const Pose pose = trial_pose(contents, static_cast<double>(trial) / trials, random);
      const InverseSolution solution = inverse(manipulator, pose, modes[random() % modes.size()]);
      if (solution.status == InverseStatus::out_of_reach) continue;
      const double residual = completion.residual(completion.joint_values(pose, solution.q));
      worst = std::max(worst, residual);
      if (residual < trial_tolerance) continue;
      problems.push_back(files_.urdf + " was recognised as " + std::string(name(manipulator.task_space())) +
                         " with distance legs, but at " + to_string(manipulator.task_space(), pose) +
                         " its loops stay open by " + number(residual * completion.system().size()) +
                         " m; its legs do more than keep a distance, which is not supported.");
      return;
    }
    if (worst < exact_closure) return;
    contents.accepted_residual = 3.0 * worst;
    contents.notes.push_back(
        files_.urdf + " closes its loops only to within " + number(worst * completion.system().size()) +
        " m, as with rounded angles; the robot is taken as the ideal one nearest to it.");
  }

  static Pose trial_pose(const Mechanism::Contents& contents, double spread, std::mt19937& random) {
    const Manipulator& manipulator = *contents.manipulator;
    std::uniform_real_distribution<double> entries(-spread, spread);
    TaskVector step(static_cast<Eigen::Index>(manipulator.leg_count()));
    for (double& entry : coefficients_of(step)) entry = entries(random);
    scale_translations(manipulator, step);
    return displaced(manipulator.task_space(), contents.completion.reference_pose(), step);
  }

  static void scale_translations(const Manipulator& manipulator, TaskVector& step) {
    const auto angles = static_cast<Eigen::Index>(rotational_degrees_of_freedom(manipulator.task_space()));
    step.tail(step.size() - angles) *= 0.5 * manipulator.size();
  }

  static constexpr unsigned trial_seed = 5;
  static constexpr int trials = 60;
  static constexpr double trial_tolerance =
      1e-3;  // over the size; roundings grow away from the assembled configuration
  static constexpr double exact_closure = 1e-11;  // over the size

  std::shared_ptr<const Tree> tree_;
  const MechanismConfig& config_;
  const ResolvedConfig& resolved_;
  const SourceNames& files_;
};

// Some of the open closures points and some revolute joints, few revolute ones first; none where there are
// many.
std::vector<std::vector<Closure>> mixtures(const std::vector<Closure>& closures) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < closures.size(); ++k)
    if (closures[k].type == ClosureType::automatic) open.push_back(k);
  if (open.size() > most_mixed_closures) return {};
  std::vector<std::bitset<most_mixed_closures>> choices;
  for (unsigned long choice = 1; choice + 1 < 1UL << open.size(); ++choice) choices.emplace_back(choice);
  std::stable_sort(choices.begin(), choices.end(),
                   [](const auto& one, const auto& other) { return one.count() < other.count(); });
  std::vector<std::vector<Closure>> result;
  for (const auto& choice : choices) {
    result.push_back(closures);
    for (std::size_t k = 0; k < open.size(); ++k)
      result.back()[open[k]].type = choice[k] ? ClosureType::revolute : ClosureType::point;
  }
  return result;
}

void check_closures(const std::vector<Closure>& closures, const SourceNames& files, Problems& problems) {
  if (closures.size() > most_closures)
    problems.push_back(files.config + " and " + files.urdf + " describe " + std::to_string(closures.size()) +
                       " closures, and at most " + std::to_string(most_closures) +
                       " are treated; a robot needs one for each loop.");
}

// "point ('a - b') and revolute ('c - d', 'e - f')", of the closures whose types were open.
std::string listed_types(const std::vector<Closure>& open, const std::vector<Closure>& taken) {
  std::string text;
  for (const ClosureType type : {ClosureType::point, ClosureType::revolute}) {
    std::string names;
    for (std::size_t k = 0; k < open.size(); ++k)
      if (open[k].type == ClosureType::automatic && taken[k].type == type)
        names += (names.empty() ? "'" : ", '") + taken[k].name + "'";
    if (!names.empty()) text += (text.empty() ? "" : " and ") + std::string(name(type)) + " (" + names + ")";
  }
  return text;
}

bool any_automatic(const std::vector<Closure>& closures) {
  return std::any_of(closures.begin(), closures.end(),
                     [](const Closure& closure) { return closure.type == ClosureType::automatic; });
}

// The first closures that make a manipulator, of those whose types were open.
std::unique_ptr<Mechanism::Contents> recognise_open(const Recogniser& recogniser,
                                                    const std::vector<Closure>& closures,
                                                    const SourceNames& files, Problems& problems) {
  const std::string start = files.config + " leaves the type of closures open; they are taken as ";
  const std::string end = ", under which the mobility is the number of actuated joints.";
  for (const ClosureType type :
       {ClosureType::point, ClosureType::revolute, ClosureType::universal, ClosureType::fixed}) {
    Problems found;
    if (auto contents = recogniser.recognise(with_type(closures, type), found)) {
      contents->notes.push_back(start + std::string(name(type)) + end);
      return contents;
    }
    if (problems.empty()) problems = found;
  }
  for (const std::vector<Closure>& mixed : mixtures(closures)) {
    Problems found;
    if (auto contents = recogniser.recognise(mixed, found)) {
      contents->notes.push_back(start + listed_types(closures, mixed) + end);
      return contents;
    }
  }
  return nullptr;
}

std::unique_ptr<Mechanism::Contents> recognise(const Recogniser& recogniser,
                                               const std::vector<Closure>& closures, const SourceNames& files,
                                               Problems& problems) {
  return any_automatic(closures) ? recognise_open(recogniser, closures, files, problems)
                                 : recogniser.recognise(closures, problems);
}

// Limits that the URDF states hold unless the YAML says otherwise; the rest is in the YAML alone.
void add_constraints(const MechanismConfig& config, const SourceNames& files, Mechanism::Contents& contents,
                     Problems& problems) {
  const std::size_t before = problems.size();
  ManipulatorDescription description = contents.manipulator->description();
  const Constraints limits = description.constraints;
  const ConstrainedRobot robot{description.task_space, description.legs.size(), contents.point_platform};
  description.constraints = resolve_constraints(config.constraints, robot, files.config, problems);
  if (config.constraints.passive_limits) {
    description.constraints.passive_limits = limits.passive_limits;
    description.constraints.passive_cones = limits.passive_cones;
    description.constraints.missing_joints = limits.missing_joints;
  }
  if (!config.constraints.actuated_limits)
    for (Leg& leg : description.legs) leg.limits = {};
  if (problems.size() > before) return;
  try {
    contents.manipulator = std::make_shared<const Manipulator>(std::move(description));
  } catch (const InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems()) problems.push_back(files.config + ": " + problem);
  }
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

}  // namespace

SharedMechanism load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                               const std::string& config_text, const std::string& config_name,
                               const std::string& frame_prefix) {
  Problems problems;
  std::vector<std::string> notes;
  const SourceNames files{urdf_name, config_name};
  MechanismConfig config = read_mechanism_config(config_text, config_name, problems);
  config.frame_prefix = frame_prefix;
  auto tree = read_tree(urdf_text, urdf_name, problems, notes);
  if (!tree) throw InvalidDescription(problems);
  const ResolvedConfig resolved =
      resolved_names(*tree, config, urdf_text, config_text, files, problems, notes);
  check_closures(resolved.closures, files, problems);
  if (!problems.empty()) throw InvalidDescription(problems);
  const Recogniser recogniser(std::make_shared<const Tree>(std::move(*tree)), config, resolved, files);
  auto contents = recognise(recogniser, resolved.closures, files, problems);
  if (!contents) throw InvalidDescription(problems);
  Problems of_constraints;
  add_constraints(config, files, *contents, of_constraints);
  if (!of_constraints.empty()) throw InvalidDescription(of_constraints);
  contents->notes.insert(contents->notes.begin(), notes.begin(), notes.end());
  return SharedMechanism(std::make_shared<const Mechanism>(std::move(contents)));
}

}  // namespace parallel_aspects
