// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PICTURE_FILE_H
#define PARALLEL_ASPECTS_TOOLS_PICTURE_FILE_H

#include "parallel_aspects/model/problems.h"
#include "tools/drawing/page_elements.h"

#include <string>

namespace parallel_aspects::tools {

/// As `check_output_file`, and the file must end with .svg or .png.
void check_picture_file(const std::string& option, const std::string& file, Problems& problems);

/// As `check_output_file`, and the file must end with .svg, since the picture is drawn as that alone.
void check_svg_file(const std::string& option, const std::string& file, Problems& problems);

/// Replaces the file by the picture, as SVG or PNG as its name ends. Throws `InvalidDescription` where it
/// cannot.
void write_picture_file(const std::string& file, const Picture& picture);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PICTURE_FILE_H
