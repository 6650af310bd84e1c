// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CULPRITS_CROSSED_ENDS_H
#define PARALLEL_ASPECTS_URDF_CULPRITS_CROSSED_ENDS_H

#include "urdf/closing/resolved_config.h"
#include "urdf/culprits/attempt.h"
#include "urdf/description/source_names.h"

#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Closures of a robot that loads whose ends are exchanged, as their names say, or the places of their ends
/// while all joints are zero; with the list for the YAML that has them in order.
Notes crossed_ends_notes(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                         const SourceNames& files, const Attempt& attempt);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CULPRITS_CROSSED_ENDS_H
