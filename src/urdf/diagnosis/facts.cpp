// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/closing/freedom.h"
#include "urdf/corrections/edit.h"
#include "urdf/diagnosis/diagnosis.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double printed_axis = 1e-4;  // digits of directions in messages

// So many actuated joints are not meant to move one degree of freedom, whatever closures leave.
constexpr std::size_t drives_of_more = 3;

constexpr const char* treated =
    "only a platform on a slide (T1) or on a hinge (R1) of the base, which one leg moves, is treated.";

// Where it is open which joints are actuated: the closures that leave the mechanism one degree of freedom by
// their axes, if with balls in their place it has as many as some robot.
std::optional<std::string> misfit_types(const std::shared_ptr<const Tree>& tree,
                                        const ResolvedConfig& resolved, const Eigen::VectorXd& values,
                                        const SourceNames& files) {
  if (resolved.actuation_origin.empty()) return std::nullopt;
  std::string names;
  std::vector<Closure> closures = resolved.closures;
  for (Closure& closure : closures) {
    if (closure.type != ClosureType::point) names += (names.empty() ? "'" : ", '") + closure.name + "'";
    closure.type = ClosureType::point;
  }
  const ClosureSystem balls(tree, resolved.base, closures);
  const auto freedom = static_cast<std::size_t>(loop_motions(balls, values).motions.cols());
  if (names.empty() || freedom < 2 || !is_actuation_count(freedom)) return std::nullopt;
  return file_of_closures(resolved, files) + " closes loops of " + files.urdf +
         " by types that leave it one degree of freedom, as their axes are not along those of its joints; "
         "write " +
         type_text(resolved, ClosureType::point) + " for " + names + ", which leaves it " +
         std::to_string(freedom) + ".";
}

class OneFreedom {
 public:
  OneFreedom(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
             const AssemblyResult& assembled, const SourceNames& files)
      : tree_(tree),
        resolved_(resolved),
        assembled_(assembled),
        files_(files),
        platform_(resolved.actuated_joints.platform_link),
        balls_(tree, resolved.base, as_balls(resolved.closures)) {}

  // With the one joint that is actuated, or each of several that move together.
  std::optional<std::string> find() const {
    if (moves_in_one_way(assembled_)) {
      if (auto message = misfit_types(tree_, resolved_, assembled_.assembly->values, files_)) return message;
    } else if (!is_held_still()) {
      return std::nullopt;
    }
    if (resolved_.actuated_joints.variables.size() >= drives_of_more) return std::nullopt;
    const std::string point = operational_point_text(*tree_, platform_, files_);
    if (const auto slide = slide_below_platform())
      return legs_at_platform() < 2
                 ? std::nullopt
                 : std::optional<std::string>(files_.urdf + " is a linkage of one degree of freedom, whose " +
                                              point + " moves on slide '" + tree_->joints[*slide].name +
                                              "' and is held by several legs; of those " + treated);
    return files_.urdf + " is a linkage of one degree of freedom, as a four-bar, and its " + point +
           " is on neither; of those " + treated;
  }

 private:
  static std::vector<Closure> as_balls(std::vector<Closure> closures) {
    for (Closure& closure : closures) closure.type = ClosureType::point;
    return closures;
  }

  static bool moves_in_one_way(const AssemblyResult& assembled) {
    return assembled.assembly && assembled.assembly->motions.cols() == 1;
  }

  // As by revolute closures about other axes than those of the joints.
  bool is_held_still() const {
    const auto& joints = resolved_.actuated_joints.variables;
    return joints.size() == 1 && moves_in_one_way(assemble(balls_, joints, platform_));
  }

  // That carries the platform on the base.
  std::optional<std::size_t> slide_below_platform() const {
    const auto joint = tree_->joint_above[body_of(*tree_, platform_)];
    const bool is_one = joint && tree_->joints[*joint].motion == JointMotion::prismatic &&
                        body_of(*tree_, tree_->joints[*joint].parent) == body_of(*tree_, resolved_.base);
    return is_one ? joint : std::nullopt;
  }

  std::ptrdiff_t legs_at_platform() const {
    const std::size_t body = body_of(*tree_, platform_);
    return std::count_if(resolved_.closures.begin(), resolved_.closures.end(), [&](const Closure& closure) {
      return body_of(*tree_, closure.frames[0].link) == body ||
             body_of(*tree_, closure.frames[1].link) == body;
    });
  }

  const std::shared_ptr<const Tree>& tree_;
  const ResolvedConfig& resolved_;
  const AssemblyResult& assembled_;
  const SourceNames& files_;
  std::size_t platform_;
  ClosureSystem balls_;
};

}  // namespace

std::optional<std::string> linkage_of_one_degree_of_freedom(const std::shared_ptr<const Tree>& tree,
                                                            const ResolvedConfig& resolved,
                                                            const AssemblyResult& assembled,
                                                            const SourceNames& files) {
  return OneFreedom(tree, resolved, assembled, files).find();
}

std::optional<std::string> actuated_joints_that_move_nothing(const ClosureSystem& system,
                                                             const AssemblyResult& assembled,
                                                             const ActuatedJoints& actuated_joints,
                                                             const SourceNames& files) {
  if (!assembled.assembly) return std::nullopt;
  std::vector<std::string> names;
  for (const std::size_t joint :
       idle_joints(system, *assembled.assembly, actuated_joints.platform_link, actuated_joints.variables))
    names.push_back(system.tree().joint_of(joint).name);
  if (names.empty()) return std::nullopt;
  return files.config + " actuates joints that move nothing of " +
         operational_point_text(system.tree(), actuated_joints.platform_link, files) + ": " +
         listed_names(names).text() + "; take them out of " + files.key("actuated_joints") +
         ", and list one of each leg.";
}

namespace {

// "'a' about (0, 0, 1) of 'rod_2', of 'b' about ..."
std::string turning_text(const ClosureSystem& balls, const Assembly& free,
                         const std::vector<Closure>& closures) {
  const Poses poses = link_poses(balls.tree(), balls.base(), free.values);
  std::string text;
  for (const Closure& closure : closures) {
    if (closure.type == ClosureType::point || closure.type == ClosureType::automatic) continue;
    std::string axes;
    const Eigen::MatrixXd found = axes_between(balls, poses, free.motions, closure.frames);
    for (Eigen::Index k = 0; k < found.cols(); ++k) {
      const Eigen::Vector3d axis = poses[closure.frames[1].link].linear().transpose() * found.col(k);
      axes += (axes.empty() ? "" : " and ") +
              in_brackets((axis / printed_axis).array().round().matrix() * printed_axis);
    }
    if (!axes.empty())
      text += (text.empty() ? "'" : ", of '") + closure.name + "' about " + axes + " of '" +
              balls.tree().links[closure.frames[1].link] + "'";
  }
  return text;
}

}  // namespace

std::optional<std::string> closures_that_hold_too_much(const std::shared_ptr<const Tree>& tree,
                                                       const ResolvedConfig& resolved,
                                                       const AssemblyResult& assembled,
                                                       const SourceNames& files) {
  const std::vector<std::size_t>& joints = resolved.actuated_joints.variables;
  const auto count = static_cast<Eigen::Index>(joints.size());
  const Eigen::Index left = assembled.assembly ? assembled.assembly->motions.cols() : 0;
  if (left >= count || !resolved.actuation_origin.empty()) return std::nullopt;
  const ClosureSystem balls(tree, resolved.base, with_type(resolved.closures, ClosureType::point));
  const auto free = assemble(balls, joints, resolved.actuated_joints.platform_link).assembly;
  if (!free || free->motions.cols() < count) return std::nullopt;
  const std::string turning = turning_text(balls, *free, resolved.closures);
  if (turning.empty()) return std::nullopt;
  return file_of_closures(resolved, files) + " closes loops of " + files.urdf + " so that they leave " +
         std::to_string(left) + " degrees of freedom to " + std::to_string(count) +
         " actuated joints, and with balls in the place of all " + std::to_string(free->motions.cols()) +
         "; then the links of closure " + turning + " turn, which its type and axis are to allow.";
}

std::optional<std::string> chain_that_holds_too_much(const ClosureSystem& system,
                                                     const Eigen::VectorXd& values,
                                                     const ActuatedJoints& actuated_joints,
                                                     const SourceNames& files) {
  const auto count = static_cast<Eigen::Index>(actuated_joints.variables.size());
  const std::vector<bool> none(system.in_loop().size(), false);
  for (const JoiningPart& part : joining_parts({system, values, none}, actuated_joints, files))
    if (!part.is_actuated && part.freedom < count && !part.chains.empty())
      return files.urdf + " joins the platform to the base by the chain of " +
             joint_names_of(part.chains.front()).text() + ", without actuated joint, which lets it move in " +
             std::to_string(part.freedom) + (part.freedom == 1 ? " way" : " ways") + " only, while " +
             std::to_string(count) +
             " joints are actuated; give the chain the joints that it lacks, or hang the platform on a leg.";
  return std::nullopt;
}

namespace {

// det A is analytic in the pose: where it is zero in one random pose, it is zero in all. Several poses rule
// out that rounding says so, and not every start closes.
constexpr int starts_of_poses = 24;
constexpr std::size_t most_poses = 12, least_poses = 6;

// Elsewhere mobility beyond that of the platform is a fault of its own.
constexpr std::size_t drives_of_spinning_rods = 6;

bool has_legs(const ClosureSystem& system, const Eigen::VectorXd& values, const ActuatedJoints& joints,
              const SourceNames& files) {
  const std::vector<bool> none(system.in_loop().size(), false);
  Problems problems;
  const FoundLegs found = find_legs({system, values, none}, joints, files, problems);
  return found.legs.size() == joints.variables.size() && problems.empty();
}

// Whether each leg has its actuated joint, all of these move, and the platform in as many ways; but some of
// them with all actuated joints locked.
bool is_lost(const ClosureSystem& system, const Eigen::VectorXd& values, const ActuatedJoints& joints,
             const SourceNames& files) {
  const LoopMotions loops = loop_motions(system, values);
  const std::size_t count = joints.variables.size();
  const bool has_idle = loops.motions.cols() > static_cast<Eigen::Index>(count);
  if (has_idle && count != drives_of_spinning_rods) return false;
  if (!platform_freedom(system, {values, loops.motions, 0.0}, joints.platform_link, count).is_full(count))
    return false;
  const Eigen::MatrixXd rates = actuated_rates(system, loops.motions, joints.variables);
  const bool all_move = rates.rowwise().norm().minCoeff() > velocity_tolerance;
  return all_move && singular_values(rates).minCoeff() < rank_tolerance &&
         has_legs(system, values, joints, files);
}

}  // namespace

std::optional<std::string> singular_everywhere(const std::shared_ptr<const Tree>& tree,
                                               const ResolvedConfig& resolved, const SourceNames& files) {
  const ActuatedJoints& joints = resolved.actuated_joints;
  if (joints.variables.size() < 2) return std::nullopt;
  const ClosureSystem system(tree, resolved.base, with_type(resolved.closures, ClosureType::point));
  const auto poses = closed_configurations(system, starts_of_poses, most_poses);
  if (poses.size() < least_poses || !std::all_of(poses.begin(), poses.end(), [&](const auto& values) {
        return is_lost(system, values, joints, files);
      }))
    return std::nullopt;
  return files.urdf + " is assembled, but singular in every pose: det A is zero to rounding in all " +
         std::to_string(poses.size()) +
         " random poses that were tried, so that its actuated joints never hold " +
         operational_point_text(*tree, joints.platform_link, files) +
         "; change the places of the joints on base or platform, which are, for instance, two similar "
         "hexagons joined corner to corner, or struts that stay parallel.";
}

}  // namespace parallel_aspects
