// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/reading/description_file.h"

#include "urdf/description/messages.h"
#include "urdf/description/text_file.h"
#include "urdf/reading/console_capture.h"
#include "urdf/reading/robot_graph.h"

#include <tinyxml2.h>

#include <cctype>
#include <dlfcn.h>
#include <filesystem>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

namespace fs = std::filesystem;

// The name of the first element; empty where there is none.
std::string root_element(const std::string& text) {
  for (std::size_t k = text.find('<'); k != std::string::npos; k = text.find('<', k + 1)) {
    if (text.compare(k, 4, "<!--") == 0) {
      k = text.find("-->", k);
      if (k == std::string::npos) return "";
    } else if (k + 1 < text.size() && std::isalpha(static_cast<unsigned char>(text[k + 1])) != 0) {
      return text.substr(k + 1, text.find_first_of(" \t\r\n/>", k) - k - 1);
    }
  }
  return "";
}

std::string lower_case(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

// Nothing for any other text.
std::optional<std::string> graph_format(const std::string& text) {
  const std::string root = root_element(text);
  if (root == "sdf") return "SDF";
  if (root == "mujoco") return "MJCF";
  return std::nullopt;
}

// Of the library or program that holds this code; empty where it is not known. A program may be called by a
// name that is no path.
fs::path own_folder() {
  Dl_info here{};
  std::error_code error;
  if (dladdr(reinterpret_cast<const void*>(&read_description_file), &here) == 0) return {};
  const fs::path file = here.dli_fname;
  const fs::path whole = fs::canonical(file.has_parent_path() ? file : fs::path("/proc/self/exe"), error);
  return error ? fs::path() : whole.parent_path();
}

// Beside that, or in the library folder next to it; else where the system searches for libraries.
std::vector<std::string> places_of(const std::string& library) {
  std::vector<std::string> places;
  std::error_code error;
  if (const fs::path folder = own_folder(); !folder.empty())
    for (const fs::path& place : {folder, folder / ".." / "lib", folder / ".."})
      if (fs::exists(place / library, error)) places.push_back((place / library).string());
  places.push_back(library);
  return places;
}

// Stays loaded, as what it reads with may have threads. Null where it was not built, or cannot be loaded for
// this `fault`.
ReadRobotGraph loaded_reader(const std::string& format, std::string& fault) {
  const std::string library = "libparallel_aspects_" + lower_case(format) + ".so";
  for (const std::string& place : places_of(library)) {
    void* handle = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr && place != library) fault = dlerror();
    if (handle == nullptr) continue;
    if (void* function = dlsym(handle, read_robot_graph_symbol))
      return reinterpret_cast<ReadRobotGraph>(function);
  }
  return nullptr;
}

// `text` is what the file holds.
std::optional<std::string> read_graph(const std::string& format, const std::string& file,
                                      const std::string& text, Problems& problems) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    problems.push_back(file + " is not well-formed XML near line " + std::to_string(document.ErrorLineNum()) +
                       " (" + tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID()) +
                       "); correct it there.");
    return std::nullopt;
  }
  std::string fault;
  const ReadRobotGraph read = loaded_reader(format, fault);
  if (read == nullptr) {
    problems.push_back(
        file + " is in " + format +
        (fault.empty()
             ? ", and this program was built without " + format + "; build it with -DPARALLEL_ASPECTS_" +
                   format + "=ON, or give a URDF."
             : ", whose reader cannot be loaded (" + fault + "); install what it names, or give a URDF."));
    return std::nullopt;
  }
  RobotGraph graph;
  {
    const ConsoleCapture console;  // sdformat tries as URDF what it refuses as SDF
    read(file, graph);
  }
  std::string urdf = graph.problems.empty() ? urdf_text(graph, file) : std::string();
  problems.insert(problems.end(), graph.problems.begin(), graph.problems.end());
  if (!graph.problems.empty()) return std::nullopt;
  return urdf;
}

}  // namespace

bool is_urdf_file(const std::string& file) {
  Problems of_reading;
  const auto text = read_text_file(file, of_reading);
  return !text || !graph_format(*text);
}

std::string xacro_command(const std::string& file) {
  fs::path expanded = fs::path(file).filename();
  if (expanded.extension() == ".xacro") expanded.replace_extension();
  if (expanded == fs::path(file).filename()) expanded.replace_extension(".expanded.urdf");
  if (expanded.extension() != ".urdf") expanded += ".urdf";
  return "'xacro " + shell_word(file) + " > " + shell_word(expanded.string()) + "'";
}

std::optional<std::string> read_description_file(const std::string& file, Problems& problems) {
  auto text = read_text_file(file, problems);
  if (!text) return std::nullopt;
  if (fs::path(file).extension() == ".xacro") {
    problems.push_back(file + " is a xacro file, which is expanded first; type " + xacro_command(file) +
                       " and give that file.");
    return std::nullopt;
  }
  const auto format = graph_format(*text);
  return format ? read_graph(*format, file, *text, problems) : std::move(text);
}

}  // namespace parallel_aspects
