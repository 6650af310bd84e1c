// SPDX-License-Identifier: BSD-3-Clause
#include "tools/output_file.h"

#include "aspects/file/bytes.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "tools/shipped_robots.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

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

void add_problem(const std::string& option, const std::string& file, const std::string& why,
                 Problems& problems) {
  if (!why.empty()) problems.push_back(option + " is '" + file + "', which " + why + "; give another.");
}

/// A file, and the option that names it.
struct NamedFile {
  std::string option, file;
  FileUse use;
};

bool is_written(FileUse use) { return use == FileUse::saved || use == FileUse::written; }

// A map that is saved to the same file is computed the first time, and loaded from then on.
bool is_missing(const NamedFile& input, const std::vector<NamedFile>& files) {
  std::error_code error;
  return input.use == FileUse::loaded && !std::filesystem::is_regular_file(input.file, error) &&
         std::none_of(files.begin(), files.end(), [&](const NamedFile& other) {
           return other.use == FileUse::saved && are_same_file(other.file, input.file);
         });
}

bool are_at_odds(const NamedFile& output, const NamedFile& other) {
  return output.use != FileUse::saved || other.use != FileUse::loaded;
}

std::vector<NamedFile> files_of(const Subcommand& subcommand) {
  std::vector<NamedFile> files;
  for (const Option& option : subcommand.options) {
    if (option.file == FileUse::none) continue;
    std::istringstream words(*option.value);
    for (std::string word; std::getline(words, word);)
      if (option.file != FileUse::robot || names_file(word))
        files.push_back({option.name, word, option.file});
  }
  return files;
}

}  // namespace

void check_output_file(const std::string& option, const std::string& file, Problems& problems) {
  if (!file.empty()) add_problem(option, file, problem_of_writing(file), problems);
}

void check_map_output(const std::string& option, const std::string& file, Problems& problems) {
  if (!file.empty()) add_problem(option, file, problem_of_saving(file), problems);
}

void check_option_files(const Subcommand& subcommand) {
  Problems problems;
  const std::vector<NamedFile> files = files_of(subcommand);
  for (const NamedFile& input : files)
    if (is_missing(input, files))
      problems.push_back(input.option + " is '" + input.file +
                         "', which is no file; write one by `aspects map --save`, or leave out " +
                         input.option + ".");
  for (auto output = files.begin(); output != files.end(); ++output) {
    if (!is_written(output->use)) continue;
    const auto same = std::find_if(files.begin(), files.end(), [&](const NamedFile& other) {
      return &other != &*output && are_at_odds(*output, other) && are_same_file(output->file, other.file);
    });
    if (same != files.end() && (!is_written(same->use) || same < output))
      problems.push_back(output->option + " is '" + output->file + "', which is the file of " + same->option +
                         " too and would be overwritten; give another.");
  }
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
}

void write_output_file(const std::string& what, const std::string& file, const std::string& text) {
  const std::string problem = replace_file(file, Bytes(text.begin(), text.end()));
  if (!problem.empty())
    throw InvalidDescription({what + " '" + file + "' is not written, since " + problem +
                              "; give a file in a folder that can be written to and has room."});
}

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

void write_picture_file(const std::string& file, const PagePicture& picture) {
  write_output_file("Picture", file,
                    ending_of(file) == ".png" ? as_png(picture, png_scale) : as_svg(picture));
}

}  // namespace parallel_aspects::tools
