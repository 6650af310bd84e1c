// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_OUTPUT_FILE_H
#define PARALLEL_ASPECTS_TOOLS_OUTPUT_FILE_H

#include "parallel_aspects/model/problems.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Adds a problem where the file that an option names cannot be written, so that no long computation is lost
/// to that. An empty name is none.
void check_output_file(const std::string& option, const std::string& file, Problems& problems);

/// A file, and the option that names it; an empty name is none.
struct NamedFile {
  std::string option, file;
};

/// Adds a problem for each output that is the file of an input or of an output before it.
void check_distinct_files(const std::vector<NamedFile>& outputs, std::vector<NamedFile> inputs,
                          Problems& problems);

/// Replaces a file by this text. Throws `InvalidDescription` where it cannot; `what` begins that sentence.
void write_output_file(const std::string& what, const std::string& file, const std::string& text);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_OUTPUT_FILE_H
