// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURES_ENTRY_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURES_ENTRY_H

#include "urdf/description/closure.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"

#include <vector>

namespace parallel_aspects {

/// "closures: [{frames: [a, b], type: point}] under mechanism in robot.yaml", or as an option, which has no
/// types.
Note closures_entry(const Tree& tree, const std::vector<Closure>& closures, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_CLOSURES_ENTRY_H
