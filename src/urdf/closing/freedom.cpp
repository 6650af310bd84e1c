// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/freedom.h"

#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace parallel_aspects {

PlatformFreedom platform_freedom(const ClosureSystem& system, const Assembly& assembly, std::size_t link,
                                 std::size_t actuated_joints) {
  if (assembly.motions.cols() == 0) return {};
  const Poses poses = link_poses(system.tree(), system.base(), assembly.values);
  const Eigen::MatrixXd twists = link_twists(system, poses, link, assembly.motions);
  PlatformFreedom freedom{0, 0, std::numeric_limits<double>::infinity()};
  const auto rank = [&](const Eigen::MatrixXd& rows) {
    const Eigen::VectorXd values = singular_values(rows);
    const Eigen::Index found =
        std::min(static_cast<Eigen::Index>(actuated_joints), (values.array() > velocity_tolerance).count());
    if (found > 0) freedom.conditioning = std::min(freedom.conditioning, values[found - 1]);
    return found;
  };
  freedom.translations = rank(twists.bottomRows(3));
  freedom.motions = rank(twists);
  return freedom;
}

Eigen::MatrixXd axes_between(const ClosureSystem& system, const Poses& poses, const Eigen::MatrixXd& motions,
                             const std::array<LinkFrame, 2>& frames) {
  if (motions.cols() == 0) return Eigen::MatrixXd(3, 0);
  const auto turning = [&](std::size_t link) {
    return link_twists(system, poses, link, motions).topRows<3>().eval();
  };
  const auto svd = singular_value_decomposition(turning(frames[1].link) - turning(frames[0].link));
  return svd.u.leftCols(svd.rank_above(velocity_tolerance));
}

std::vector<std::size_t> idle_joints(const ClosureSystem& system, const Assembly& assembly, std::size_t link,
                                     const std::vector<std::size_t>& joints) {
  if (assembly.motions.cols() == 0) return {};
  const Poses poses = link_poses(system.tree(), system.base(), assembly.values);
  const Eigen::MatrixXd twists = link_twists(system, poses, link, assembly.motions);
  const Eigen::MatrixXd rates = actuated_rates(system, assembly.motions, joints);
  std::vector<std::size_t> idle;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    Eigen::MatrixXd others = rates;
    others.row(static_cast<Eigen::Index>(j)).setZero();
    const auto svd = singular_value_decomposition(others);
    const Eigen::MatrixXd alone = svd.null_space(svd.rank_above(velocity_tolerance));
    const bool moves = product(rates.row(static_cast<Eigen::Index>(j)), alone).norm() > velocity_tolerance;
    if (moves && product(twists, alone).norm() < velocity_tolerance) idle.push_back(joints[j]);
  }
  return idle;
}

std::size_t freedom_of(const ClosureSystem& system, const std::vector<Eigen::VectorXd>& closed,
                       std::size_t link) {
  std::size_t most = 0;
  for (const Eigen::VectorXd& values : closed) {
    const Poses poses = link_poses(system.tree(), system.base(), values);
    const Eigen::MatrixXd motions = loop_motions(system, values).motions;
    if (motions.cols() == 0) continue;
    const Eigen::VectorXd twists = singular_values(link_twists(system, poses, link, motions));
    most = std::max(most, static_cast<std::size_t>((twists.array() > velocity_tolerance).count()));
  }
  return most;
}

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
namespace {

constexpr double opposite = -1.0 + 1e-6;  // the cosine of an angle, at most

// 1 for closures of other types.
std::vector<double> pin_cosines(const ClosureSystem& system, const Eigen::VectorXd& values) {
  const Poses poses = link_poses(system.tree(), system.base(), values);
  const auto axis = [&](const LinkFrame& frame) -> Eigen::Vector3d {
    return poses[frame.link].linear() * frame.in_link.linear().col(2);
  };
  std::vector<double> cosines;
  for (const Closure& closure : system.closures())
    cosines.push_back(
        closure.type == ClosureType::revolute ? axis(closure.frames[0]).dot(axis(closure.frames[1])) : 1.0);
  return cosines;
}

}  // namespace

PinDirections::PinDirections(const ClosureSystem& system)
    : system_(system), drawn_(pin_cosines(system, Eigen::VectorXd::Zero(system.tree().variables()))) {}

std::size_t PinDirections::turned_over(const Eigen::VectorXd& values) const {
  const std::vector<double> cosines = pin_cosines(system_, values);
  std::size_t count = 0;
  for (std::size_t k = 0; k < cosines.size(); ++k)
    count += (drawn_[k] < opposite) != (cosines[k] < 0.0) ? 1 : 0;
  return count;
}

}  // namespace parallel_aspects
