// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/text_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_bytes = 100'000'000;  // some files, such as /dev/zero, have no end

/// All of it, or a little more than `max_bytes`.
std::string text_of(std::istream& stream) {
  std::string text;
  for (std::array<char, 65536> block; stream && text.size() <= max_bytes;) {
    stream.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

}  // namespace

std::optional<std::string> read_text_file(const std::string& file, Problems& problems) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  std::string problem = "File '" + file + "' cannot be read; give one that exists and is readable.";
  if (stream && !std::filesystem::is_directory(file, error)) {
    std::string text = text_of(stream);
    if (text.size() <= max_bytes) return text;
    problem = "File '" + file + "' has more than " + std::to_string(max_bytes / 1'000'000) +
              " MB; give a smaller one.";
  }
  if (std::find(problems.begin(), problems.end(), problem) == problems.end()) problems.push_back(problem);
  return std::nullopt;
}

}  // namespace parallel_aspects
