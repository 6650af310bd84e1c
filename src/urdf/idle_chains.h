// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_IDLE_CHAINS_H
#define PARALLEL_ASPECTS_URDF_IDLE_CHAINS_H

#include "urdf/closing/resolved_config.h"
#include "urdf/description/messages.h"

#include <memory>
#include <optional>

namespace parallel_aspects {

/// Opens chains that take nothing from the platform even with their actuated joints locked, as a telescopic
/// shaft to a tool that is on it: their closures go, and what they drive is no actuated joint of the robot.
/// Passive chains that are recognised stay. A note where there were any and as many actuated joints are left
/// as a robot has; else nothing is changed.
std::optional<Note> leave_out_idle_chains(const std::shared_ptr<const Tree>& tree, const SourceNames& files,
                                          ResolvedConfig& resolved);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_IDLE_CHAINS_H
