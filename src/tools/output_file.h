// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_OUTPUT_FILE_H
#define PARALLEL_ASPECTS_TOOLS_OUTPUT_FILE_H

#include "draw/page/page_elements.h"
#include "parallel_aspects/model/problems.h"
#include "tools/subcommands.h"

#include <string>

namespace parallel_aspects::tools {

/// Adds a problem where the file that an option names cannot be written, so that no long computation is lost
/// to that. An empty name is none.
void check_output_file(const std::string& option, const std::string& file, Problems& problems);

/// The same of a file for a map, which is not written over what is no map.
void check_map_output(const std::string& option, const std::string& file, Problems& problems);

/// Throws `InvalidDescription` with a problem for each file of the options of a subcommand that would be
/// written over another one of them, and for each map that is to be loaded and is not there.
void check_option_files(const Subcommand& subcommand);

/// Replaces a file by this text. Throws `InvalidDescription` where it cannot; `what` begins that sentence.
void write_output_file(const std::string& what, const std::string& file, const std::string& text);

/// As `check_output_file`, and the file must end with .svg or .png.
void check_picture_file(const std::string& option, const std::string& file, Problems& problems);

/// As `check_output_file`, and the file must end with .svg, since the picture is drawn as that alone.
void check_svg_file(const std::string& option, const std::string& file, Problems& problems);

/// Replaces the file by the picture, as SVG or PNG as its name ends. Throws `InvalidDescription` where it
/// cannot.
void write_picture_file(const std::string& file, const PagePicture& picture);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_OUTPUT_FILE_H
