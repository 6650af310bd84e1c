// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SYMMETRIZING_H
#define PARALLEL_ASPECTS_URDF_SYMMETRIZING_H

#include "parallel_aspects/model/manipulator.h"
#include "urdf/closing/chain.h"
#include "urdf/mechanism_contents.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Puts the nearest symmetric robot in the place of the manipulator, within a tolerance in sizes of the robot
/// and rad, and keeps its motions; changes neither where there is none, or no tolerance. A note says what was
/// moved by how much, or that nothing was.
void symmetrize_legs(Mechanism::Contents& contents, std::optional<double> tolerance,
                     const SourceNames& files);

/// Makes the constraints of a robot symmetric, too, under the motions of its legs. Notes say what was moved
/// by how much, and what keeps maps from using the symmetry.
void symmetrize_constraints(ManipulatorDescription& robot, const SymmetricLegs& legs, double size,
                            double tolerance, const SourceNames& files, std::vector<std::string>& notes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SYMMETRIZING_H
