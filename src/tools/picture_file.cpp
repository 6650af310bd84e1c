// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture_file.h"

#include "tools/output_file.h"

#include <filesystem>

namespace parallel_aspects::tools {
namespace {

constexpr double png_scale = 1.6;  // so that small text is sharp

std::string ending_of(const std::string& file) { return std::filesystem::path(file).extension(); }

}  // namespace

void check_picture_file(const std::string& option, const std::string& file, Problems& problems) {
  if (file.empty()) return;
  check_output_file(option, file, problems);
  if (ending_of(file) != ".svg" && ending_of(file) != ".png")
    problems.push_back(option + " is '" + file +
                       "', which ends neither with .svg nor with .png; give a name that does.");
}

void check_svg_file(const std::string& option, const std::string& file, Problems& problems) {
  if (file.empty()) return;
  check_output_file(option, file, problems);
  if (ending_of(file) != ".svg")
    problems.push_back(option + " is '" + file + "', which does not end with .svg; give a name that does.");
}

void write_picture_file(const std::string& file, const Picture& picture) {
  write_output_file("Picture", file,
                    ending_of(file) == ".png" ? as_png(picture, png_scale) : as_svg(picture));
}

}  // namespace parallel_aspects::tools
