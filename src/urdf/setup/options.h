// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_OPTIONS_H
#define PARALLEL_ASPECTS_URDF_SETUP_OPTIONS_H

#include "urdf/setup/setup_config.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// A word of a command line, in quotation marks where a shell needs them.
std::string shell_word(const std::string& word);

/// The option of `aspects setup` that gives these values, as "--actuated 'a b'"; a name of its own key where
/// the YAML alone can say it.
std::string option_for(const std::string& key, const std::vector<std::string>& values);

/// Those that ask for what the draft says.
std::string options_for(const SetupDraft& draft);

/// What the loader says of the keys of a YAML that was never written, said of the options.
std::string said_of_options(const std::string& problem, const std::string& config_name);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_OPTIONS_H
