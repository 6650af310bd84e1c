// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_DESCRIPTION_FILE_H
#define PARALLEL_ASPECTS_URDF_READING_DESCRIPTION_FILE_H

#include "parallel_aspects/model/problems.h"

#include <optional>
#include <string>

namespace parallel_aspects {

/// A robot's description as the text of a URDF, from a URDF, or from SDF or MJCF, which libraries of their
/// own read that are loaded when they are needed. Nothing, and problems, where it cannot be read.
std::optional<std::string> read_description_file(const std::string& file, Problems& problems);

/// Whether the file has neither SDF nor MJCF.
bool is_urdf_file(const std::string& file);

/// What to type so that a file with xacro becomes a URDF, in quotation marks.
std::string xacro_command(const std::string& file);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_DESCRIPTION_FILE_H
