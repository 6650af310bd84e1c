// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_MISFIT_AXES_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_MISFIT_AXES_H

#include "urdf/description/closure.h"
#include "urdf/description/tree.h"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Joints whose axes stand out from those of the others, and the tree with these put right.
struct AxisCorrection {
  std::shared_ptr<const Tree> tree;
  std::string fault;   ///< "turns joint 'a' 0.1 rad away from ..."
  std::string remedy;  ///< "write <axis xyz=...> for joint 'a'"
};

/// Of joints in the loops at these joint values, which need not close them: axes that miss a direction that
/// most share, the direction of some that is near, or the point that most go through. A guess each: whether
/// it is the fault shows where the corrected tree is recognised.
std::vector<AxisCorrection> find_axis_corrections(const ClosureSystem& system, const Eigen::VectorXd& values);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_MISFIT_AXES_H
