// SPDX-License-Identifier: BSD-3-Clause
#include "tools/output_file.h"

#include "aspects/file/whole_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace parallel_aspects::tools {
namespace {

/// However the two are written, and by a link too.
bool are_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (a.empty() || b.empty()) return false;
  if (std::filesystem::equivalent(a, b, error)) return true;
  const std::filesystem::path one = std::filesystem::weakly_canonical(std::filesystem::absolute(a), error);
  return !error && one == std::filesystem::weakly_canonical(std::filesystem::absolute(b), error) && !error;
}

}  // namespace

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

void check_distinct_files(const std::vector<NamedFile>& outputs, std::vector<NamedFile> inputs,
                          Problems& problems) {
  for (const NamedFile& output : outputs) {
    const auto same = std::find_if(inputs.begin(), inputs.end(), [&output](const NamedFile& other) {
      return are_same_file(output.file, other.file);
    });
    if (same != inputs.end())
      problems.push_back(output.option + " is '" + output.file + "', which is the file of " + same->option +
                         " too and would be overwritten; give another.");
    inputs.push_back(output);
  }
}

void write_output_file(const std::string& what, const std::string& file, const std::string& text) {
  const std::string problem = replace_file(file, Bytes(text.begin(), text.end()));
  if (!problem.empty())
    throw InvalidDescription({what + " '" + file + "' is not written, since " + problem +
                              "; give a file in a folder that can be written to and has room."});
}

}  // namespace parallel_aspects::tools
