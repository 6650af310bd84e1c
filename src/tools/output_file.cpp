// SPDX-License-Identifier: BSD-3-Clause
#include "tools/output_file.h"

#include "aspects/file/whole_file.h"

#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace parallel_aspects::tools {

void check_output_file(const std::string& option, const std::string& file, Problems& problems) {
  if (file.empty()) return;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0)
    problems.push_back(option + " is '" + file +
                       "', which is in no folder that can be written to; give another.");
  else if (std::error_code error;
           std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
    problems.push_back(option + " is '" + file + "', which is not a regular file; give another.");
}

void write_output_file(const std::string& what, const std::string& file, const std::string& text) {
  const std::string problem = replace_file(file, Bytes(text.begin(), text.end()));
  if (!problem.empty())
    throw InvalidDescription({what + " '" + file + "' is not written, since " + problem +
                              "; give a file in a folder that can be written to and has room."});
}

}  // namespace parallel_aspects::tools
