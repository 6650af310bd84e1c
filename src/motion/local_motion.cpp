// SPDX-License-Identifier: BSD-3-Clause
#include "motion/local_motion.h"

#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr int corners = 360;
constexpr double shrink = 0.8;
constexpr double margin = 0.35;  // of each index at the middle of the figure that must be left everywhere

// Whole turns of each degree of freedom in one round; all are at zero where a round begins.
constexpr std::array<int, max_legs> turns{1, 2, 3, 3, 1, 2};

class LocalPlanner {
 public:
  LocalPlanner(const Manipulator& robot, const Pose& middle, const WorkingMode& mode,
               const ConfigurationFilter& allowed)
      : robot_(robot), middle_(middle), mode_(mode), allowed_(allowed) {}

  std::vector<JointVector> plan(double widest) {
    const InverseSolution start = inverse(robot_, middle_, mode_);
    if (start.status != InverseStatus::solved || !allowed_(middle_, start.q)) return {};
    indices_ = singularity_indices(robot_, middle_, start.q);
    for (double amplitude = widest; amplitude >= narrowest_local_motion; amplitude *= shrink) {
      std::vector<JointVector> joint_values = figure({middle_, start.q}, amplitude);
      if (!joint_values.empty()) return joint_values;
    }
    return {};
  }

 private:
  std::vector<JointVector> figure(const Place& start, double amplitude) const {
    std::vector<JointVector> joint_values{start.q};
    Place at = start;
    for (int i = 1; i <= corners; ++i) {
      const auto next = place(amplitude, static_cast<double>(i) / corners);
      if (!next) return {};
      const JointVector change = joint_change(robot_, at.q, next->q);
      if (!straight_motion_exists(robot_, at, change, next->pose)) return {};
      joint_values.push_back(joint_values.back() + change);
      at = *next;
    }
    return joint_values;
  }

  std::optional<Place> place(double amplitude, double share) const {
    const auto degrees_of_freedom = static_cast<Eigen::Index>(robot_.leg_count());
    const auto rotations = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot_.task_space()));
    TaskVector twist(degrees_of_freedom);
    for (Eigen::Index i = 0; i < degrees_of_freedom; ++i) {
      const double unit = i < rotations ? 2.0 : robot_.size();
      twist[i] = amplitude * unit * std::sin(2.0 * EIGEN_PI * turns[static_cast<std::size_t>(i)] * share);
    }
    const Pose pose = displaced(robot_.task_space(), middle_, twist);
    const InverseSolution solution = inverse(robot_, pose, mode_);
    if (solution.status != InverseStatus::solved || !clear(pose, solution.q)) return std::nullopt;
    if (!allowed_(pose, solution.q)) return std::nullopt;
    return Place{pose, solution.q};
  }

  bool clear(const Pose& pose, const JointVector& q) const {
    const SingularityIndices here = singularity_indices(robot_, pose, q);
    if (here.smallest_singular_value < margin * indices_.smallest_singular_value) return false;
    for (Eigen::Index j = 0; j < here.inverse_diagonal.size(); ++j)
      if (std::abs(here.inverse_diagonal[j]) < margin * std::abs(indices_.inverse_diagonal[j])) return false;
    return true;
  }

  const Manipulator& robot_;
  const Pose middle_;
  const WorkingMode mode_;
  const ConfigurationFilter& allowed_;
  SingularityIndices indices_;  // at the middle
};

}  // namespace

std::vector<JointVector> plan_local_motion(const Manipulator& manipulator, const Pose& pose,
                                           const WorkingMode& mode, const ConfigurationFilter& allowed,
                                           double widest) {
  return LocalPlanner(manipulator, pose, mode, allowed).plan(widest);
}

}  // namespace parallel_aspects
