// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_OPTIONS_H
#define PARALLEL_ASPECTS_URDF_SETUP_OPTIONS_H

#include "urdf/description/command_options.h"
#include "urdf/setup/setup_config.h"

#include <string>

namespace parallel_aspects {

/// The options of `aspects setup` that ask for what the draft says.
std::string options_for(const SetupDraft& draft);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_OPTIONS_H
