// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_RESOLVED_CONFIG_H
#define PARALLEL_ASPECTS_URDF_CLOSING_RESOLVED_CONFIG_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/chain.h"
#include "urdf/closing/closure_dialects.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/description/closure.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// What a robot's YAML and URDF say together, by index instead of name.
struct ResolvedConfig {
  std::size_t base = 0;  ///< link
  ActuatedJoints actuated_joints;
  std::vector<Closure> closures;
};

/// Looks up the names of `config` in the tree. Closures that the YAML does not list come from the dialects of
/// `source`; actuated joints that it does not list come from there too, or else from transmissions; `notes`
/// say so. What is wrong is added to `problems`.
ResolvedConfig resolve_config(const MechanismConfig& config, const LoopSource& source, Problems& problems,
                              std::vector<std::string>& notes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_RESOLVED_CONFIG_H
