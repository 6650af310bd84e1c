// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_HOME_CONFIGURATION_H
#define PARALLEL_ASPECTS_URDF_HOME_CONFIGURATION_H

#include "urdf/config/mechanism_config.h"
#include "urdf/description/messages.h"
#include "urdf/mechanism_contents.h"

namespace parallel_aspects {

/// Says where `Mechanism::home` is, once all of the robot is known. A note where the stated start is beyond
/// reach.
void find_home(const MechanismConfig& config, const SourceNames& files, Mechanism::Contents& contents);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_HOME_CONFIGURATION_H
