// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/stated_constraints.h"

#include "urdf/description/nearest_name.h"
#include "urdf/symmetrizing.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

// The workspace of the YAML, as far as slides let the operational point go there.
void intersect(const WorkspaceBox& slides, TaskSpace space, const SourceNames& files,
               std::optional<WorkspaceBox>& workspace, Problems& problems) {
  if (!workspace) workspace = slides;
  workspace->lower = workspace->lower.cwiseMax(slides.lower);
  workspace->upper = workspace->upper.cwiseMin(slides.upper);
  const auto count = static_cast<Eigen::Index>(directions(space));
  if ((workspace->lower.head(count).array() >= workspace->upper.head(count).array()).any())
    problems.push_back(files.config +
                       " has a constraints.workspace that the limits of the passive slides in " + files.urdf +
                       " leave no room in; widen one of them.");
}

// What limits may lack of a full turn where none are meant [rad].
constexpr double nearly_a_turn = 0.01;

constexpr double unlimited = std::numeric_limits<double>::infinity();

// Takes limits of revolute joints that leave nearly a full turn as none of the aspects.
class FullTurns {
 public:
  explicit FullTurns(const Mechanism::Contents& contents) : tree_(contents.completion.system().tree()) {}

  void leave_out(ManipulatorDescription& description) {
    for (Leg& leg : description.legs)
      if (leg.limits.limited() && is_left_out(leg.actuated_joint))
        leg.limits = {-unlimited, unlimited, leg.limits.velocity};
    auto& limits = description.constraints.passive_limits;
    limits.erase(std::remove_if(limits.begin(), limits.end(),
                                [this](const PassiveLimit& limit) { return is_left_out(limit.joint); }),
                 limits.end());
    auto& cones = description.constraints.passive_cones;
    cones.erase(std::remove_if(cones.begin(), cones.end(),
                               [this](const PassiveCone& cone) { return is_left_out(cone.joint); }),
                cones.end());
    auto& missing = description.constraints.missing_joints;
    missing.erase(std::remove_if(missing.begin(), missing.end(),
                                 [this](const std::string& joint) { return is_left_out(joint); }),
                  missing.end());
  }

  bool any() const { return !names_.empty(); }

  Note note(const SourceNames& files) const {
    Note note = files.urdf +
                " limits joints to less than 0.01 rad below a full turn, which bounds no aspect: " +
                listed_names(names_) + "; constraints: {strict_limits: true} in " + files.config +
                " takes the limits as they are.";
    note.is_on_limits_left_out = true;
    return note;
  }

 private:
  bool turns(const std::string& name) const {
    const auto joint = tree_.joint_named(name);
    return joint && tree_.joints[*joint].motion == JointMotion::revolute &&
           leaves_nearly_a_turn(tree_.joints[*joint].limits);
  }

  bool is_left_out(const std::string& joint) {
    if (!turns(joint)) return false;
    if (!contains(names_, joint)) names_.push_back(joint);
    return true;
  }

  const Tree& tree_;
  std::vector<std::string> names_;
};

// Those that the loader found; a workspace that slides leave bounds the stated one.
void keep_passive_limits(const Constraints& found, TaskSpace space, const SourceNames& files,
                         Constraints& constraints, Problems& problems) {
  constraints.passive_limits = found.passive_limits;
  constraints.passive_cones = found.passive_cones;
  constraints.missing_joints = found.missing_joints;
  if (found.workspace) intersect(*found.workspace, space, files, constraints.workspace, problems);
}

}  // namespace

bool leaves_nearly_a_turn(const JointLimits& limits) {
  const double lacking = 2.0 * EIGEN_PI - (limits.upper - limits.lower);
  return 0.0 < lacking && lacking < nearly_a_turn;
}

void add_stated_constraints(const ConstraintsConfig& config, std::optional<double> symmetrize,
                            const SourceNames& files, Mechanism::Contents& contents, Problems& problems) {
  const std::size_t before = problems.size();
  ManipulatorDescription description = contents.manipulator->description();
  const Constraints found = description.constraints;
  const ConstrainedRobot robot{description.task_space, description.legs.size(), contents.point_platform};
  description.constraints = resolve_constraints(config, robot, files.config, problems);
  if (config.passive_limits)
    keep_passive_limits(found, description.task_space, files, description.constraints, problems);
  if (!config.actuated_limits)
    for (Leg& leg : description.legs) leg.limits = {};
  if (problems.size() > before) return;
  ManipulatorDescription mapped = description;
  FullTurns full_turns(contents);
  if (!config.strict_limits) full_turns.leave_out(mapped);
  try {
    contents.manipulator = std::make_shared<const Manipulator>(description);
    if (!contents.symmetric.motions.empty()) {
      Notes unused;  // what bounds maps is reported, and what rounding moves is not
      const double size = contents.manipulator->size(), tolerance = symmetrize.value_or(rounding_of_decimals);
      symmetrize_constraints(description, contents.symmetric, size, tolerance, files, unused);
      symmetrize_constraints(mapped, contents.symmetric, size, tolerance, files,
                             symmetrize ? contents.notes : unused);
      contents.manipulator = std::make_shared<const Manipulator>(description);
    }
  } catch (const InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems()) problems.push_back(files.config + ": " + problem);
  }
  contents.mapped_manipulator = contents.manipulator;
  if (problems.size() > before || !full_turns.any()) return;
  contents.mapped_manipulator = std::make_shared<const Manipulator>(std::move(mapped));
  contents.notes.push_back(full_turns.note(files));
}

}  // namespace parallel_aspects
