// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_MISSING_JOINTS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_MISSING_JOINTS_H

#include "urdf/corrections/correction.h"

namespace parallel_aspects {

/// Of legs that have one passive joint less than two others or more, which are alike: that joint, where these
/// have it.
Corrections missing_joint_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                      const ClosureSystem& system, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_MISSING_JOINTS_H
