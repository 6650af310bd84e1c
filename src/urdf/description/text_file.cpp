// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/text_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace parallel_aspects {

std::optional<std::string> read_text_file(const std::string& file, Problems& problems) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (stream && !std::filesystem::is_directory(file, error))
    return std::string(std::istreambuf_iterator<char>(stream), {});
  const std::string problem = "File '" + file + "' cannot be read; give one that exists and is readable.";
  if (std::find(problems.begin(), problems.end(), problem) == problems.end()) problems.push_back(problem);
  return std::nullopt;
}

}  // namespace parallel_aspects
