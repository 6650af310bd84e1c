// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_MECHANISM_RECOGNITION_H
#define PARALLEL_ASPECTS_URDF_MECHANISM_RECOGNITION_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/description/closure.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"
#include "urdf/load_mechanism.h"
#include "urdf/mechanism_contents.h"

#include <cstddef>
#include <memory>

namespace parallel_aspects {

/// Six for each leg of a hexapod, and twenty; the time to assemble a mechanism grows with their third power.
inline constexpr std::ptrdiff_t max_joints_in_loops = 120;

/// Whether there are some, and not too many; `problems` where not.
bool check_joints_in_loops(const ClosureSystem& system, const SourceNames& files, Problems& problems);

/// Everything after names and types of closures: assembles the mechanism, recognises it and proves the result
/// on random poses. Nothing, and `problems`, where it is no manipulator.
std::unique_ptr<Mechanism::Contents> recognise_mechanism(const std::shared_ptr<const Tree>& tree,
                                                         const MechanismConfig& config,
                                                         const ResolvedConfig& resolved,
                                                         const SourceNames& files, const LoadSearch& search,
                                                         Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_MECHANISM_RECOGNITION_H
