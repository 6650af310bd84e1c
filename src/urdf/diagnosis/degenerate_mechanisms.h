// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_DEGENERATE_MECHANISMS_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_DEGENERATE_MECHANISMS_H

#include "urdf/closing/assembly.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/description/messages.h"

#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {

/// Of a mechanism that is not recognised: that it is a linkage of one degree of freedom, as a four-bar, and
/// not one in T1. `assembled`: with its closures as stated. One actuated joint that closures hold still by
/// their axes counts as free.
std::optional<std::string> linkage_of_one_degree_of_freedom(const std::shared_ptr<const Tree>& tree,
                                                            const ResolvedConfig& resolved,
                                                            const AssemblyResult& assembled,
                                                            const SourceNames& files);

/// That a robot has legs and a platform that moves, but that its actuated joints do not hold this in any of
/// the random poses in which it was assembled.
std::optional<std::string> singular_everywhere(const std::shared_ptr<const Tree>& tree,
                                               const ResolvedConfig& resolved, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_DEGENERATE_MECHANISMS_H
