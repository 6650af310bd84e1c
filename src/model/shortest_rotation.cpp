// SPDX-License-Identifier: BSD-3-Clause
// Without decompositions, so that readers of formats have it too.
#include "model/angles.h"
#include "model/linear_algebra.h"

namespace parallel_aspects {

Eigen::Quaterniond shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const Eigen::Vector3d middle = a + b;
  // Half a turn about any axis across; so near to it, the direction of the middle would be rounding.
  if (middle.norm() < 1e-7) return Eigen::Quaterniond(Eigen::AngleAxisd(pi, a.unitOrthogonal()));
  const Eigen::Vector3d half = middle.normalized(), axis = a.cross(half);
  return Eigen::Quaterniond(a.dot(half), axis.x(), axis.y(), axis.z()).normalized();
}

}  // namespace parallel_aspects
