// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_LOOPS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_LOOPS_H

#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <memory>
#include <random>
#include <stdexcept>
#include <string>

namespace parallel_aspects::test {

/// `text` with every `old` replaced. Throws when there is none, so that a test cannot miss its change.
inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
  std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::invalid_argument("no '" + old + "' in the text");
  for (; at != std::string::npos; at = text.find(old, at + by.size())) text.replace(at, old.size(), by);
  return text;
}

inline std::shared_ptr<const Mechanism> load(const std::string& urdf, const std::string& config) {
  return load_mechanism(urdf, "robot.urdf", config, "robot.yaml");
}

/// The messages that refuse a description; none when it is accepted.
inline Problems refusal(const std::string& urdf, const std::string& config) {
  try {
    load(urdf, config);
  } catch (const InvalidDescription& invalid) {
    return invalid.problems();
  }
  return {};
}

/// How many of the configurations in all working modes, at random poses about the assembled one, leave a loop
/// open; -1 when none could be tried.
inline int open_loops(const Mechanism& mechanism, double spread = 0.2) {
  const Manipulator& manipulator = *mechanism.manipulator();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism.joint_names().size()));
  int tried = 0, open = 0;
  for (int trial = 0; trial < 100; ++trial) {
    TaskVector step(static_cast<Eigen::Index>(manipulator.leg_count()));
    for (double& entry : coefficients_of(step)) entry = spread * manipulator.size() * number(random);
    if (has_rotation(manipulator.task_space())) step.head(step.size() / 2) /= manipulator.size();
    const Pose pose = displaced(manipulator.motions(), mechanism.assembled().pose, step);
    for (const InverseSolution& solution : inverse_in_all_modes(manipulator, pose)) {
      if (solution.status == InverseStatus::out_of_reach) continue;
      ++tried;
      if (!mechanism.complete(pose, solution.q, positions)) ++open;
    }
  }
  return tried > 0 ? open : -1;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_LOOPS_H
