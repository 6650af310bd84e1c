// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_TEXT_FILE_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_TEXT_FILE_H

#include "parallel_aspects/model/problems.h"

#include <optional>
#include <string>

namespace parallel_aspects {

/// The whole file; nothing, and one problem a file, where it cannot be read.
std::optional<std::string> read_text_file(const std::string& file, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_TEXT_FILE_H
