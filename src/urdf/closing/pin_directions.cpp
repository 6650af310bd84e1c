// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/pin_directions.h"

namespace parallel_aspects {
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
