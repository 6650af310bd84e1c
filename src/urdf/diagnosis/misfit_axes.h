// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_MISFIT_AXES_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_MISFIT_AXES_H

#include "urdf/corrections/correction.h"
#include "urdf/description/closure.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {

/// Of joints in the loops at these joint values, which need not close them: axes that miss a direction that
/// most share, the direction of some that is near, or the point that most go through. A guess each: whether
/// it is the fault shows where the corrected tree is recognised.
Corrections find_axis_corrections(const ClosureSystem& system, const Eigen::VectorXd& values,
                                  const SourceNames& files);

/// Of a mechanism with one degree of freedom at these joint values, where it is open which joints are
/// actuated: the closures that leave it so few by their axes, if with balls in their place it has as many as
/// some robot.
std::optional<std::string> misfit_types(const std::shared_ptr<const Tree>& tree,
                                        const ResolvedConfig& resolved, const Eigen::VectorXd& values,
                                        const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_MISFIT_AXES_H
