// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SYMMETRIZING_H
#define PARALLEL_ASPECTS_URDF_SYMMETRIZING_H

#include "parallel_aspects/model/manipulator.h"
#include "urdf/closing/chain.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The symmetric robot nearest to `robot`, within a tolerance in sizes of the robot and rad; `robot` itself
/// where there is none, or no tolerance. A note says what was moved by how much, or that nothing was.
std::shared_ptr<const Manipulator> symmetrized(std::shared_ptr<const Manipulator> robot,
                                               std::optional<double> tolerance, const SourceNames& files,
                                               std::vector<std::string>& notes);

/// Makes the constraints of a robot symmetric, too, whose legs were made so. Notes say what was moved by how
/// much, and what keeps maps from using the symmetry.
void symmetrize_constraints(ManipulatorDescription& robot, double size, double tolerance,
                            const SourceNames& files, std::vector<std::string>& notes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SYMMETRIZING_H
