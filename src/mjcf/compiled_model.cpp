// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/compiled_model.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <regex>
#include <vector>

namespace parallel_aspects::mjcf {
namespace {

void add_lines(const tinyxml2::XMLElement& element, std::vector<int>& lines) {
  lines.push_back(element.GetLineNum());
  for (const auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    add_lines(*child, lines);
}

// What MuJoCo says, in one line, with the place in the file that people wrote.
std::string in_source(std::string message, const KinematicElements& elements) {
  tinyxml2::XMLDocument document;
  document.Parse(elements.text.c_str());
  std::vector<int> lines;
  add_lines(*document.RootElement(), lines);
  static const std::regex line_number("line( =)? ([0-9]+)(, column = -?[0-9]+)?");
  std::smatch match;
  if (std::regex_search(message, match, line_number)) {
    const auto found = std::find(lines.begin(), lines.end(), std::stoi(match[2]));
    const auto index = static_cast<std::size_t>(found - lines.begin());
    const std::string place =
        index < elements.lines.size()
            ? "line " + std::to_string(elements.lines[index].line) + " of " + elements.lines[index].file
            : "";
    message = match.prefix().str() + place;
  }
  message = std::regex_replace(message, std::regex("Object name = , id = -?[0-9]+"), "");
  message = std::regex_replace(message, std::regex("Object name = ([^,]*), id = -?[0-9]+"), "named '$1'");
  message = std::regex_replace(message, std::regex("^(XML )?Error: |Schema violation: "), "");
  message = std::regex_replace(message, std::regex("\\s*\n\\s*"), ", ");
  return std::regex_replace(message, std::regex("(, )+"), ", ");
}

struct FreeFiles {
  void operator()(mjVFS* files) const {
    mj_deleteVFS(files);
    delete files;
  }
};

}  // namespace

std::unique_ptr<mjModel, Free> compiled(const KinematicElements& elements, const std::string& file,
                                        Problems& problems) {
  constexpr const char* name = "robot.xml";
  const std::unique_ptr<mjVFS, FreeFiles> files(new mjVFS);
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(elements.text.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], elements.text.data(), elements.text.size());
  std::array<char, 1000> error{};
  std::unique_ptr<mjModel, Free> model(
      mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size())));
  if (!model)
    problems.push_back(file + " is refused by MuJoCo: " + in_source(error.data(), elements) +
                       "; correct it there.");
  return model;
}

}  // namespace parallel_aspects::mjcf
