// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/freedom.h"

#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"

#include <algorithm>
#include <random>
#include <utility>

namespace parallel_aspects {
namespace {

// The loops are closed from so many configurations, the first at zero, until enough are found.
constexpr int max_starts = 16;
constexpr std::size_t enough = 4;
constexpr unsigned seed = 7;

constexpr double least_velocity = 1e-3;  // of orthonormal motions

// The tree is owned elsewhere.
std::shared_ptr<const Tree> borrowed(const Tree& tree) { return {std::shared_ptr<const Tree>(), &tree}; }

Eigen::VectorXd random_values(const ClosureSystem& system, std::mt19937& random) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(system.tree().variables());
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (std::size_t k = 0; k < system.in_loop().size(); ++k) {
    const TreeJoint& joint = system.tree().joint_of(k);
    const double range = joint.motion == JointMotion::revolute ? EIGEN_PI : system.size();
    const double lower = std::max(joint.limits.lower, -range), upper = std::min(joint.limits.upper, range);
    if (system.in_loop()[k]) values[static_cast<Eigen::Index>(k)] = lower + part(random) * (upper - lower);
  }
  return values;
}

}  // namespace

Freedom::Freedom(const Tree& tree, std::size_t base, std::vector<Closure> closures)
    : system_(borrowed(tree), base, std::move(closures)) {
  const std::vector<bool> none_held(system_.in_loop().size(), false);
  std::mt19937 random(seed);
  Eigen::VectorXd start = Eigen::VectorXd::Zero(tree.variables());
  for (int k = 0; k < max_starts && samples_.size() < enough; ++k) {
    add(close_loops(system_, start, none_held));
    start = random_values(system_, random);
  }
}

// Columns of the joints inside the loops.
Eigen::MatrixXd Freedom::scaling() const {
  const auto& in_loop = system_.in_loop();
  Eigen::MatrixXd scaling =
      Eigen::MatrixXd::Zero(system_.tree().variables(), std::count(in_loop.begin(), in_loop.end(), true));
  Eigen::Index column = 0;
  for (std::size_t k = 0; k < in_loop.size(); ++k) {
    if (!in_loop[k]) continue;
    const bool slides = system_.tree().joint_of(k).motion == JointMotion::prismatic;
    scaling(static_cast<Eigen::Index>(k), column++) = slides ? system_.size() : 1.0;
  }
  return scaling;
}

void Freedom::add(const Eigen::VectorXd& values) {
  if (!(system_.residual(values).lpNorm<Eigen::Infinity>() < closing_tolerance * system_.size())) return;
  const Eigen::MatrixXd scaled = scaling();
  const auto svd = singular_value_decomposition(system_.jacobian(values) * scaled);
  const Eigen::Index rank = svd.rank_above(rank_tolerance * svd.values[0]);
  samples_.push_back({link_poses(system_.tree(), system_.base(), values), scaled * svd.null_space(rank)});
}

std::size_t Freedom::of(std::size_t link) const {
  std::size_t most = 0;
  for (const Sample& sample : samples_) {
    if (sample.motions.cols() == 0) continue;
    Eigen::MatrixXd twists = velocity_matrix(system_.tree(), system_.base(), sample.poses, link,
                                             sample.poses[link].translation()) *
                             sample.motions;
    twists.bottomRows(3) /= system_.size();
    const auto rank = (singular_values(twists).array() > least_velocity).count();
    most = std::max(most, static_cast<std::size_t>(rank));
  }
  return most;
}

}  // namespace parallel_aspects
