// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_UNIT_CORRECTIONS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_UNIT_CORRECTIONS_H

#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"

namespace parallel_aspects {

/// Where slides have limits far beyond the robot, lengths are far beyond a robot's, or places of closures far
/// beyond the lengths: millimetres. Where origins are turned by angles far beyond a full turn: degrees, of
/// those angles alone, or of whole numbers beside them, too. The same of the frames of closures that the YAML
/// lists. `size`: of the robot [m].
Corrections unit_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                             double size, const SourceNames& files);

/// The same of a robot that loads as it is.
Corrections unit_doubts(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                        double size, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_UNIT_CORRECTIONS_H
