// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/platform_freedom.h"

#include "model/linear_algebra.h"

#include <algorithm>
#include <limits>

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

}  // namespace parallel_aspects
