// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CULPRITS_SINGULAR_EVERYWHERE_H
#define PARALLEL_ASPECTS_URDF_CULPRITS_SINGULAR_EVERYWHERE_H

#include "urdf/closing/resolved_config.h"
#include "urdf/description/source_names.h"

#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {

/// That a robot has legs and a platform that moves, but that its actuated joints do not hold this in any of
/// the random poses in which it was assembled.
std::optional<std::string> singular_everywhere(const std::shared_ptr<const Tree>& tree,
                                               const ResolvedConfig& resolved, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CULPRITS_SINGULAR_EVERYWHERE_H
