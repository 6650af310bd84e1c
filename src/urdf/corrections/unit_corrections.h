// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_UNIT_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_UNIT_CORRECTIONS_H

#include "urdf/corrections/correction.h"
#include "urdf/corrections/loop_joints.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// Where slides have limits far beyond the robot, or all lengths are far beyond a robot's: millimetres. Where
/// origins are turned by angles beyond a full turn, or that are whole or half degrees, read as radians:
/// degrees. The same of the frames of closures that the YAML lists. `size`: of the robot [m].
Corrections unit_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                             double size, const SourceNames& files);

/// The same of a robot that loads as it is, as notes.
std::vector<std::string> unit_notes(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                                    double size, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_UNIT_CORRECTIONS_H
