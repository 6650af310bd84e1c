// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/climb.h"

#include "aspects/boxes/segment_proof.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_map_dimension, 1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_map_dimension, max_map_dimension>;

/// Newton's direction for the sum of the logarithms of all conditions f, in shares of the widths of `region`;
/// empty where there is none. Damping bends it toward the steepest ascent: conditions are curved, and more so
/// the farther a step leads along a boundary.
Vector direction(const Conditions& conditions, const Box& region, double damping,
                 const ClimbPolicy& policy) noexcept {
  const auto size = static_cast<Eigen::Index>(region.dimension);
  Vector gradient = Vector::Zero(size);
  Matrix hessian = Matrix::Zero(size, size);
  for (std::size_t k = 0; k < conditions.count; ++k) {
    const Condition& condition = conditions.items[k];
    if (!(condition.value > 0.0)) return {};
    Vector relative(size);
    for (Eigen::Index i = 0; i < size; ++i)
      relative[i] = condition.slope[static_cast<std::size_t>(i)] * region.width(static_cast<std::size_t>(i)) /
                    condition.value;
    gradient += relative;
    hessian += relative * relative.transpose();
  }
  hessian.diagonal().array() += damping;
  // With H the sum of r r^T over the relative slopes r = f' / f, a step d changes no linearised f by a share
  // of more than |r.d| <= sqrt(d^T H d): where that is below 1 all of them stay positive (Dikin's ellipsoid).
  const Vector newton = hessian.ldlt().solve(gradient);
  const double length = std::sqrt(newton.dot(hessian * newton));
  if (!std::isfinite(length) || length < policy.shortest_step) return {};
  return newton * (policy.share_of_ellipsoid / std::max(length, policy.share_of_ellipsoid));
}

MapPoint moved(const MapPoint& from, const Vector& direction, const Box& region) noexcept {
  MapPoint to = from;
  for (std::size_t i = 0; i < region.dimension; ++i)
    to[i] = std::clamp(from[i] + direction[static_cast<Eigen::Index>(i)] * region.width(i), region.lower[i],
                       region.upper[i]);
  return to;
}

}  // namespace

bool Climb::step() noexcept {
  if (!has_crossed_ && cross_glued_face()) return has_crossed_ = true;
  has_crossed_ = false;
  const Box& region = space_.region();
  const Conditions conditions = classifier_.conditions(position_, mode_, sign_);
  for (int trial = 0; trial < policy_.max_trials; ++trial, damping_ *= policy_.more_damping) {
    const Vector toward = direction(conditions, region, damping_, policy_);
    if (toward.size() == 0) return false;
    const MapPoint to = moved(position_.point, toward, region);
    if (proved_sign(classifier_, region.dimension, mode_, {position_.root, to}) != sign_) continue;
    if (!segment_is_free(classifier_, region.dimension, mode_, sign_, position_, to, policy_.max_halvings))
      continue;
    position_.point = to;
    damping_ = std::max(1.0, damping_ / policy_.more_damping);
    return true;
  }
  return false;
}

/// Where the path leads to a glued face, on from its other side.
bool Climb::cross_glued_face() noexcept {
  const Box& region = space_.region();
  for (std::size_t i = 0; i < region.dimension; ++i) {
    if (position_.point[i] != region.lower[i] && position_.point[i] != region.upper[i]) continue;
    const MapPosition other_side = space_.across(position_, i);
    if (other_side.root == position_.root && other_side.point == position_.point) continue;
    position_ = other_side;
    return true;
  }
  return false;
}

}  // namespace parallel_aspects
