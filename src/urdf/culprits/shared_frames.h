// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CULPRITS_SHARED_FRAMES_H
#define PARALLEL_ASPECTS_URDF_CULPRITS_SHARED_FRAMES_H

#include "urdf/closing/resolved_config.h"
#include "urdf/description/tree.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// What looks like a slip, though it may be meant: a link that several closures hold, while one of its body
/// with such a name is in none; or one that a closure holds at its own joint, where another leg is, while a
/// frame of its body is in none. `size`: of the robot [m].
std::vector<std::string> shared_frame_notes(const Tree& tree, const ResolvedConfig& resolved, double size);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CULPRITS_SHARED_FRAMES_H
