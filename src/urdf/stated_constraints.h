// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_STATED_CONSTRAINTS_H
#define PARALLEL_ASPECTS_URDF_STATED_CONSTRAINTS_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/chain.h"
#include "urdf/config/constraints_config.h"
#include "urdf/mechanism_contents.h"

#include <optional>

namespace parallel_aspects {

/// Whether limits lack so little of a full turn that none are meant, as -3.14 to 3.14 [rad].
bool leaves_nearly_a_turn(const JointLimits& limits);

/// Gives the manipulator the constraints of the YAML. Limits that the URDF states, which it has by now, hold
/// unless the YAML says otherwise; what is wrong is added to `problems`. All are made symmetric within the
/// tolerance that the legs were made so, if there is one.
void add_stated_constraints(const ConstraintsConfig& config, std::optional<double> symmetrize,
                            const SourceNames& files, Mechanism::Contents& contents, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_STATED_CONSTRAINTS_H
