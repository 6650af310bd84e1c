// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "urdf/mechanism_recognition.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr unsigned trial_seed = 5;
constexpr int trials = 60;  // up to half the size of the robot away, so that many are in reach
// Over the size; roundings grow away from the assembled configuration.
constexpr double trial_tolerance = 1e-3;
constexpr double exact_closure = 1e-11;  // over the size, and rad

void scale_translations(const Manipulator& manipulator, TaskVector& step) {
  const auto angles = static_cast<Eigen::Index>(rotational_degrees_of_freedom(manipulator.task_space()));
  step.tail(step.size() - angles) *= 0.5 * manipulator.size();
}

Pose trial_pose(const Mechanism::Contents& contents, double spread, std::mt19937& random) {
  const Manipulator& manipulator = *contents.manipulator;
  std::uniform_real_distribution<double> entries(-spread, spread);
  TaskVector step(static_cast<Eigen::Index>(manipulator.leg_count()));
  for (double& entry : coefficients_of(step)) entry = entries(random);
  scale_translations(manipulator, step);
  return displaced(manipulator.motions(), contents.completion.reference_pose(), step);
}

std::string open_at(const Manipulator& manipulator, const Pose& pose, double gap, const SourceNames& files) {
  return files.urdf + " was recognised as " + std::string(name(manipulator.task_space())) +
         " with distance legs, but at " + to_string(manipulator.task_space(), pose) +
         " its loops stay open by " + number_text(gap, 3) +
         " m; its legs do more than keep a distance, which is not supported.";
}

// Three digits that bound the value.
std::string bound_text(double value) {
  if (!(value > 0.0)) return "0";
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return number_text(std::ceil(value / unit * (1.0 - 1e-12)) * unit, 3);
}

std::string open_by_rounding(const LoopGap& widest, double size, const SourceNames& files) {
  std::string gaps;
  if (widest.distance > exact_closure * size) gaps = bound_text(widest.distance) + " m";
  if (widest.angle > exact_closure || gaps.empty())
    gaps += (gaps.empty() ? "" : " and ") + bound_text(widest.angle) + " rad";
  return files.urdf + " closes its loops only to within " + gaps +
         ", as with rounded angles; the robot is taken as the ideal one nearest to it.";
}

}  // namespace

void close_trial_poses(Mechanism::Contents& contents, const SourceNames& files, Problems& problems) {
  const Manipulator& manipulator = *contents.manipulator;
  const Completion& completion = contents.completion;
  const double size = completion.system().size();
  const std::vector<WorkingMode> modes = working_modes(manipulator);
  std::mt19937 random(trial_seed);
  const Eigen::VectorXd assembled =
      completion.joint_values(completion.reference_pose(), completion.reference_joints());
  double worst = completion.residual(assembled);
  LoopGap widest = completion.system().widest_gaps(assembled);
  for (int trial = 0; trial < trials; ++trial) {
    const Pose pose = trial_pose(contents, static_cast<double>(trial) / trials, random);
    const InverseSolution solution = inverse(manipulator, pose, modes[random() % modes.size()]);
    if (solution.status == InverseStatus::out_of_reach) continue;
    const Eigen::VectorXd values = completion.joint_values(pose, solution.q);
    const double residual = completion.residual(values);
    worst = std::max(worst, residual);
    widest = widest.with(completion.system().widest_gaps(values));
    if (residual < trial_tolerance) continue;
    problems.push_back(open_at(manipulator, pose, residual * size, files));
    return;
  }
  if (worst < exact_closure) return;
  contents.accepted_residual = 3.0 * worst;
  contents.notes.push_back(open_by_rounding(widest, size, files));
}

}  // namespace parallel_aspects
