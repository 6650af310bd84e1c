// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/still_joints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

// A joint that moves less [rad or sizes of the robot] while the mechanism moves by the step stays still.
constexpr double stillness = 1e-3;
constexpr double step_length = 0.1;

// Of all motions together; a step that closes its loops again and is far enough to tell.
bool moves_in_a_step(const ClosureSystem& system, const Assembly& assembly, std::size_t joint,
                     const std::vector<Eigen::VectorXd>& steps) {
  const auto row = static_cast<Eigen::Index>(joint);
  const bool prismatic = system.tree().joint_of(joint).motion == JointMotion::prismatic;
  const double unit = prismatic ? system.size() : 1.0;
  return std::any_of(steps.begin(), steps.end(), [&](const Eigen::VectorXd& values) {
    return std::abs(values[row] - assembly.values[row]) > stillness * unit;
  });
}

std::vector<Eigen::VectorXd> steps_along_motions(const ClosureSystem& system, const Assembly& assembly) {
  const std::vector<bool> none_held(system.in_loop().size(), false);
  std::vector<Eigen::VectorXd> steps;
  for (Eigen::Index k = 0; k < assembly.motions.cols(); ++k) {
    const Eigen::VectorXd values =
        close_loops(system, assembly.values + step_length * assembly.motions.col(k), none_held);
    const double error = system.residual(values).lpNorm<Eigen::Infinity>();
    if (error < closing_tolerance * system.size()) steps.push_back(values);
  }
  return steps;
}

}  // namespace

std::vector<bool> still_joints(const ClosureSystem& system, const Assembly& assembly) {
  std::vector<bool> still = system.in_loop();
  const std::vector<Eigen::VectorXd> steps = steps_along_motions(system, assembly);
  if (steps.empty()) return std::vector<bool>(still.size(), false);
  for (std::size_t joint = 0; joint < still.size(); ++joint)
    still[joint] = still[joint] && !moves_in_a_step(system, assembly, joint, steps);
  return still;
}

}  // namespace parallel_aspects
