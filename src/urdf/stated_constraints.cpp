// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/stated_constraints.h"

#include <memory>
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

}  // namespace

void add_stated_constraints(const ConstraintsConfig& config, const SourceNames& files,
                            Mechanism::Contents& contents, Problems& problems) {
  const std::size_t before = problems.size();
  ManipulatorDescription description = contents.manipulator->description();
  const Constraints limits = description.constraints;
  const ConstrainedRobot robot{description.task_space, description.legs.size(), contents.point_platform};
  description.constraints = resolve_constraints(config, robot, files.config, problems);
  if (config.passive_limits) {
    description.constraints.passive_limits = limits.passive_limits;
    description.constraints.passive_cones = limits.passive_cones;
    description.constraints.missing_joints = limits.missing_joints;
    if (limits.workspace)
      intersect(*limits.workspace, description.task_space, files, description.constraints.workspace,
                problems);
  }
  if (!config.actuated_limits)
    for (Leg& leg : description.legs) leg.limits = {};
  if (problems.size() > before) return;
  try {
    contents.manipulator = std::make_shared<const Manipulator>(std::move(description));
  } catch (const InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems()) problems.push_back(files.config + ": " + problem);
  }
}

}  // namespace parallel_aspects
