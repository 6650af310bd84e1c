// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "parallel_aspects/urdf/assembly.h"
#include "parallel_aspects/urdf/chain.h"
#include "parallel_aspects/urdf/leg_recognition.h"
#include "parallel_aspects/urdf/mechanism_config.h"
#include "parallel_aspects/urdf/mechanism_contents.h"
#include "parallel_aspects/urdf/platform_motion.h"
#include "parallel_aspects/urdf/tree_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <sstream>
#include <utility>

namespace parallel_aspects {
namespace {

std::string metres(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << value << " m";
  return text.str();
}

// The configuration with its names looked up in the tree.
struct ResolvedConfig {
  std::size_t base = 0;
  Drives drives;
  std::vector<Closure> closures;
};

class NameResolver {
 public:
  NameResolver(const Tree& tree, const SourceNames& files, Problems& problems)
      : tree_(tree), files_(files), problems_(problems) {}

  ResolvedConfig resolve(const MechanismConfig& config) {
    ResolvedConfig result;
    if (!config.base_link.empty()) result.base = link("mechanism.base_link", config.base_link);
    if (!config.operational_point.empty())
      result.drives.platform_link = link("mechanism.operational_point", config.operational_point);
    for (const std::string& joint : config.actuated_joints) add_drive(joint, result.drives.variables);
    for (std::size_t k = 0; k < config.closures.size(); ++k)
      add_closure(k, config.closures[k], result.closures);
    return result;
  }

 private:
  std::size_t link(const std::string& key, const std::string& name) {
    if (const auto found = tree_.link_named(name)) return *found;
    problems_.push_back(files_.config + " names link '" + name + "' in " + key + ", but " + files_.urdf +
                        " has no such link; did you mean '" + nearest_name(name, tree_.links) + "'?");
    return 0;
  }

  void add_drive(const std::string& name, std::vector<std::size_t>& variables) {
    const auto found = tree_.joint_named(name);
    if (found && tree_.joints[*found].variable) {
      variables.push_back(*tree_.joints[*found].variable);
      return;
    }
    std::vector<std::string> movable;
    for (const std::size_t joint : tree_.movable) movable.push_back(tree_.joints[joint].name);
    const std::string nearest = nearest_name(name, movable);
    problems_.push_back(files_.config + " names joint '" + name + "' in mechanism.actuated_joints, but " +
                        files_.urdf +
                        (found ? " fixes that joint; drive a movable one"
                               : " has no such joint; did you mean '" + nearest + "'?") +
                        (found ? "." : ""));
  }

  void add_closure(std::size_t index, const ConfiguredClosure& configured, std::vector<Closure>& closures) {
    const std::string key = "mechanism.closures[" + std::to_string(index) + "].frames";
    Closure closure;
    closure.name = configured.frames[0] + " - " + configured.frames[1];
    closure.type = configured.type;
    for (std::size_t k = 0; k < 2; ++k) closure.frames[k].link = link(key, configured.frames[k]);
    if (configured.frames[0] == configured.frames[1])
      problems_.push_back(files_.config + " closes link '" + configured.frames[0] + "' with itself in " +
                          key + "; name two different links.");
    closures.push_back(closure);
  }

  const Tree& tree_;
  const SourceNames& files_;
  Problems& problems_;
};

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
    const AssemblyResult assembled = assemble(system, resolved_.drives.variables);
    if (!assembled.assembly) {
      report_gap(system, assembled.closest, problems);
      return nullptr;
    }
    const Assembly& assembly = *assembled.assembly;
    const auto chains = find_legs(system, assembly.values, resolved_.drives, files_, problems);
    if (!problems.empty()) return nullptr;
    const auto motion = find_platform_motion(system, assembly, resolved_.drives, files_, problems);
    if (!motion) return nullptr;
    const auto legs = recognise_legs(chains, system, assembly.values, *motion, problems);
    check_task_space(*motion, problems);
    if (!problems.empty()) return nullptr;
    auto contents = build(system, assembly, *motion, legs, problems);
    if (contents) prove(*contents, problems);
    return problems.empty() ? std::move(contents) : nullptr;
  }

 private:
  void report_gap(const ClosureSystem& system, const Eigen::VectorXd& closest, Problems& problems) const {
    const auto [gap, index] = system.widest_gap(closest);
    const std::string& closure = system.closures()[index].name;
    problems.push_back(
        files_.urdf + " cannot be closed as " + files_.config + " asks: the frames of closure '" + closure +
        "' come no nearer than " + metres(gap) +
        (gap < closing_tolerance * system.size()
             ? " without a wrong direction; check the axes of the two frames and the type of the closure."
             : "; check the lengths, the joint limits and the frames of its loop."));
  }

  std::vector<RecognisedLeg> recognise_legs(const std::vector<LegChains>& legs, const ClosureSystem& system,
                                            const Eigen::VectorXd& values, const PlatformMotion& motion,
                                            Problems& problems) const {
    std::vector<RecognisedLeg> recognised;
    for (const LegChains& leg : legs) {
      const std::size_t variable = resolved_.drives.variables[leg.drive];
      const LegSetting setting{&motion, system.size(), values[static_cast<Eigen::Index>(variable)],
                               tree_->joint_of(variable).limits, "leg_" + std::to_string(leg.drive + 1)};
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
    description.base_frame = tree_->links[resolved_.base];
    description.task_frame = motion.task_frame;
    for (const RecognisedLeg& leg : legs) description.legs.push_back(leg.leg);
    try {
      auto contents = std::unique_ptr<Mechanism::Contents>(new Mechanism::Contents{
          std::make_shared<const Manipulator>(description),
          tree_->links[resolved_.drives.platform_link],
          {},
          {},
          {},
          static_cast<int>(motion.mobility),
          static_cast<int>(motion.idle),
          assembly.residual,
          Completion(system, assembly.values, motion, legs, resolved_.drives.variables)});
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

  // Random poses, near and far, in the working mode of the assembled one: each must close every loop.
  void prove(const Mechanism::Contents& contents, Problems& problems) const {
    const Manipulator& manipulator = *contents.manipulator;
    const Completion& completion = contents.completion;
    const auto mode = working_mode(manipulator, completion.reference_pose(), completion.reference_drives());
    if (!mode) return;
    std::mt19937 random(trial_seed);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int trial = 0; trial < trials; ++trial) {
      TaskVector step(static_cast<Eigen::Index>(manipulator.leg_count()));
      for (double& entry : step) entry = number(random) * trial / trials;
      scale_translations(manipulator, step);
      const Pose pose = displaced(manipulator.task_space(), completion.reference_pose(), step);
      const InverseSolution solution = inverse(manipulator, pose, *mode);
      if (solution.status == InverseStatus::out_of_reach) continue;
      const double residual = completion.residual(completion.joint_values(pose, solution.q));
      if (residual < trial_tolerance) continue;
      problems.push_back(files_.urdf + " was recognised as " + std::string(name(manipulator.task_space())) +
                         " with distance legs, but at " + to_string(manipulator.task_space(), pose) +
                         " its loops stay open by " + metres(residual * completion.system().size()) +
                         "; its legs do more than keep a distance, which is not supported.");
      return;
    }
  }

  static void scale_translations(const Manipulator& manipulator, TaskVector& step) {
    const TaskSpace space = manipulator.task_space();
    const Eigen::Index angles = space == TaskSpace::SE2 ? 1 : has_rotation(space) ? 3 : 0;
    step.tail(step.size() - angles) *= 0.5 * manipulator.size();
  }

  static constexpr unsigned trial_seed = 5;
  static constexpr int trials = 60;
  static constexpr double trial_tolerance = 1e-3;  // roundings grow away from the assembled configuration

  std::shared_ptr<const Tree> tree_;
  const MechanismConfig& config_;
  const ResolvedConfig& resolved_;
  const SourceNames& files_;
};

std::vector<Closure> with_type(std::vector<Closure> closures, ClosureType type) {
  for (Closure& closure : closures)
    if (closure.type == ClosureType::automatic) closure.type = type;
  return closures;
}

bool any_automatic(const std::vector<Closure>& closures) {
  return std::any_of(closures.begin(), closures.end(),
                     [](const Closure& closure) { return closure.type == ClosureType::automatic; });
}

std::unique_ptr<Mechanism::Contents> recognise(const Recogniser& recogniser,
                                               const std::vector<Closure>& closures, const SourceNames& files,
                                               Problems& problems) {
  if (!any_automatic(closures)) return recogniser.recognise(closures, problems);
  for (const ClosureType type :
       {ClosureType::point, ClosureType::revolute, ClosureType::universal, ClosureType::fixed}) {
    Problems found;
    auto contents = recogniser.recognise(with_type(closures, type), found);
    if (contents) {
      contents->notes.push_back(files.config + " leaves the type of closures open; they are taken as " +
                                std::string(name(type)) +
                                ", under which the mobility is the number of drives.");
      return contents;
    }
    if (problems.empty()) problems = found;
  }
  return nullptr;
}

}  // namespace

std::shared_ptr<const Mechanism> load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                                                const std::string& config_text,
                                                const std::string& config_name) {
  Problems problems;
  std::vector<std::string> notes;
  const SourceNames files{urdf_name, config_name};
  const MechanismConfig config = read_mechanism_config(config_text, config_name, problems);
  auto tree = read_tree(urdf_text, urdf_name, problems, notes);
  ResolvedConfig resolved;
  if (tree) resolved = NameResolver(*tree, files, problems).resolve(config);
  if (tree && problems.empty() && resolved.closures.empty())
    problems.push_back(config_name + " has no mechanism.closures, and " + urdf_name +
                       " is an open tree without them; list the frames that each loop holds together.");
  if (!problems.empty()) throw InvalidDescription(problems);
  const Recogniser recogniser(std::make_shared<const Tree>(std::move(*tree)), config, resolved, files);
  auto contents = recognise(recogniser, resolved.closures, files, problems);
  if (!contents) throw InvalidDescription(problems);
  contents->notes.insert(contents->notes.begin(), notes.begin(), notes.end());
  return std::make_shared<const Mechanism>(std::move(contents));
}

}  // namespace parallel_aspects
