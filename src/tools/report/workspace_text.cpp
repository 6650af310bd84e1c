// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/constraint_clearance.h"
#include "aspects/roadmap/pose_sampler.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "tools/report/reports.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace parallel_aspects::tools {
namespace {

constexpr int samples = 4000, most_samples = 40000;
constexpr int enough = 100;  // reached poses, to tell their ranges
constexpr std::uint64_t seed = 1;

struct ReachedPoses {
  int drawn = 0, count = 0;
  Eigen::AlignedBox3d positions;
};

// Of passive joints too, and all else that bounds the robot; margins are of what happens there.
bool keeps_constraints(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const ConstraintKinds kinds = manipulator.constraint_kinds();
  return std::all_of(all_constraint_kinds.begin(), all_constraint_kinds.end(), [&](ConstraintKind kind) {
    return !kinds[index_of(kind)] || kind == ConstraintKind::margins ||
           constraint_clearance(manipulator, kind, pose, q) >= 0.0;
  });
}

bool is_reached(const Manipulator& manipulator, const Pose& pose) {
  const auto solutions = inverse_in_all_modes(manipulator, pose);
  return std::any_of(solutions.begin(), solutions.end(), [&](const InverseSolution& solution) {
    return solution.status == InverseStatus::solved && keeps_constraints(manipulator, pose, solution.q);
  });
}

ReachedPoses reached_poses(const Manipulator& manipulator, PoseSampler& sampler) {
  ReachedPoses reached;
  for (; reached.drawn < samples || (reached.count < enough && reached.drawn < most_samples);
       ++reached.drawn) {
    const std::optional<Pose> pose = sampler.draw();
    if (!pose || !is_reached(manipulator, *pose)) continue;
    ++reached.count;
    reached.positions.extend(pose->position);
  }
  return reached;
}

std::string ranges_text(const Manipulator& manipulator, const Eigen::AlignedBox3d& positions) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::string text;
  for (std::size_t i = 0; i < directions(manipulator.task_space()); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    text += (text.empty() ? "" : ", ") + std::string(axes[i]) + " from " + shown_briefly(positions.min()[k]) +
            " to " + shown_briefly(positions.max()[k]);
  }
  return text + " m";
}

}  // namespace

std::string workspace_text(const std::shared_ptr<const Manipulator>& manipulator, const Pose& home) {
  PoseSampler sampler(manipulator, seed, std::nullopt, EIGEN_PI);
  if (!sampler.is_bounded())
    return "workspace: not bounded by the legs; limit the actuated joints, or give a workspace or a region\n";
  ReachedPoses reached = reached_poses(*manipulator, sampler);
  if (reached.count > 0 && is_reached(*manipulator, home)) reached.positions.extend(home.position);
  const std::string share =
      std::to_string(reached.count) + " of " + std::to_string(reached.drawn) + " random poses";
  if (reached.count == 0 || directions(manipulator->task_space()) == 0)
    return "workspace: the legs reach " + share + "\n";
  return "workspace: " + ranges_text(*manipulator, reached.positions) + ", about; the legs reach " + share +
         " there\n";
}

}  // namespace parallel_aspects::tools
