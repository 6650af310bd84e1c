// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/freedom.h"

#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

// The loops are closed from so many configurations, the first at zero, until enough are found.
constexpr int max_starts = 16;
constexpr std::size_t enough = 4;
constexpr unsigned freedom_seed = 7;

// The tree is owned elsewhere.
std::shared_ptr<const Tree> borrowed(const Tree& tree) { return {std::shared_ptr<const Tree>(), &tree}; }

}  // namespace

Freedom::Freedom(const Tree& tree, std::size_t base, std::vector<Closure> closures)
    : system_(borrowed(tree), base, std::move(closures)) {
  const std::vector<bool> none_held(system_.in_loop().size(), false);
  std::mt19937 random(freedom_seed);
  Eigen::VectorXd start = Eigen::VectorXd::Zero(tree.variables());
  for (int k = 0; k < max_starts && samples_.size() < enough; ++k) {
    add(close_loops(system_, start, none_held));
    start = random_start(system_, random);
  }
}

void Freedom::add(const Eigen::VectorXd& values) {
  if (!(system_.residual(values).lpNorm<Eigen::Infinity>() < closing_tolerance * system_.size())) return;
  samples_.push_back(
      {link_poses(system_.tree(), system_.base(), values), loop_motions(system_, values).motions});
}

std::size_t Freedom::of(std::size_t link) const {
  std::size_t most = 0;
  for (const Sample& sample : samples_) {
    if (sample.motions.cols() == 0) continue;
    const Eigen::MatrixXd twists = link_twists(system_, sample.poses, link, sample.motions);
    const auto rank = (singular_values(twists).array() > velocity_tolerance).count();
    most = std::max(most, static_cast<std::size_t>(rank));
  }
  return most;
}

}  // namespace parallel_aspects
