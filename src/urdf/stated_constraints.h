// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_STATED_CONSTRAINTS_H
#define PARALLEL_ASPECTS_URDF_STATED_CONSTRAINTS_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "urdf/closing/chain.h"
#include "urdf/config/constraints_config.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/mechanism_contents.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Puts the nearest symmetric robot in the place of the manipulator, within the tolerance of `config` in
/// sizes of the robot and rad, and keeps its motions; changes neither where there is none, or no tolerance.
/// Limits of actuated joints that bound no map may be as they like. A note says what was moved by how much,
/// or that nothing was.
void symmetrize_legs(Mechanism::Contents& contents, const MechanismConfig& config, const SourceNames& files);

/// Says so of a robot whose maps would be symmetric if its numbers were not rounded, and that the YAML can
/// have it so. Nothing where it has, or of six degrees of freedom.
std::optional<std::string> note_on_symmetry(const Mechanism::Contents& contents,
                                            const MechanismConfig& config, const SourceNames& files);

/// Makes the constraints of a robot symmetric, too, under the motions of its legs. Notes say what was moved
/// by how much, and what keeps maps from using the symmetry.
void symmetrize_constraints(ManipulatorDescription& robot, const SymmetricLegs& legs, double size,
                            double tolerance, const SourceNames& files, Notes& notes);

/// Whether limits lack so little of a full turn that none are meant, as -3.14 to 3.14 [rad].
bool leaves_nearly_a_turn(const JointLimits& limits);

/// Gives the manipulator the constraints of the YAML. Limits that the URDF states, which it has by now, hold
/// unless the YAML says otherwise; what is wrong is added to `problems`. All are made symmetric within the
/// tolerance that the legs were made so, if there is one.
void add_stated_constraints(const ConstraintsConfig& config, std::optional<double> symmetrize,
                            const SourceNames& files, Mechanism::Contents& contents, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_STATED_CONSTRAINTS_H
