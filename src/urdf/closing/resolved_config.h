// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_RESOLVED_CONFIG_H
#define PARALLEL_ASPECTS_URDF_CLOSING_RESOLVED_CONFIG_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/chain.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/description/closure.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"
#include "urdf/dialects/closure_dialects.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// What a robot's YAML and URDF say together, by index instead of name.
struct ResolvedConfig {
  std::size_t base = 0;  ///< link
  ActuatedJoints actuated_joints;
  std::vector<Closure> closures;
  std::string closure_dialect;  ///< in which closures are described, if they are; those added come last
  /// Where the actuated joints are described, if not in a list of the YAML; they may be too many then.
  std::string actuation_origin;
};

/// The name of the file that describes the closures.
const std::string& file_of_closures(const ResolvedConfig& resolved, const SourceNames& files);

/// Looks up the names of `config` in the tree. Closures that the YAML does not list come from the dialects of
/// `source`; actuated joints that it does not list come from there too, or else from `<ros2_control>` and
/// transmissions; `notes` say so. What is wrong is added to `problems`.
ResolvedConfig resolve_config(const MechanismConfig& config, const LoopSource& source, Problems& problems,
                              Notes& notes);

/// Leaves out closures that are listed before, with a note where there are any.
std::optional<Note> leave_out_repeated(ResolvedConfig& resolved, const SourceNames& files);

/// Makes an operational point that is not a link one: a link of its own at the end of `tree`, fixed to that
/// in whose frame it is given. A name that is taken is added to `problems`; a link that does not exist is
/// left to `resolve_config`.
void add_operational_point(ConfiguredFrame& point, const SourceNames& files, Tree& tree, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_RESOLVED_CONFIG_H
