// SPDX-License-Identifier: BSD-3-Clause
// Which room may include which, and what else holds of the folders of the package.
#ifndef PARALLEL_ASPECTS_TEST_TOOLS_LAYER_RULES_H
#define PARALLEL_ASPECTS_TEST_TOOLS_LAYER_RULES_H

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace parallel_aspects::test {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

// From the bottom to the top; each may include itself and those before it. A room is a folder of src/, and
// has the public headers of its sources. A public header without a source is in the lowest room of its layer.
inline const Strings rooms{"model",
                           "kinematics",
                           "kinematics/homotopy",
                           "kinematics/direct",
                           "singularity",
                           "interval",
                           "legs",
                           "aspects/tree",
                           "aspects/constraints",
                           "aspects/boxes",
                           "aspects/simd",
                           "aspects/star_sets",
                           "aspects/symmetry",
                           "aspects/components",
                           "aspects/map",
                           "aspects/graph",
                           "aspects/workspace",
                           "aspects/design",
                           "aspects/persistence",
                           "aspects/zeros",
                           "aspects/cusps",
                           "aspects/enclosures",
                           "aspects/solutions",
                           "aspects/regions",
                           "aspects/uniqueness",
                           "aspects/roadmap",
                           "aspects/file",
                           "aspects/shards",
                           "arms",
                           "distance",
                           "tracking",
                           "motion",
                           "motion/check",
                           "motion/plan",
                           "motion/timing",
                           "motion/choose",
                           "motion/guard",
                           "urdf/description",
                           "urdf/config",
                           "urdf/reading",
                           "urdf/dialects",
                           "urdf/closing",
                           "urdf/recognition",
                           "urdf/corrections",
                           "urdf/diagnosis",
                           "urdf",
                           "urdf/setup",
                           "draw/plane",
                           "draw/surface",
                           "draw/scene",
                           "draw/page",
                           "ask",
                           "tools/report",
                           "tools/robot_report",
                           "tools/motion_report",
                           "tools/drawing",
                           "tools",
                           "tools/paths",
                           "tools/sweep",
                           "tools/subcommands",
                           "mjcf",
                           "sdf",
                           "mpi",
                           "ompl",
                           "python",
                           "ros/parameters",
                           "ros/messages",
                           "ros/joint_states",
                           "ros/monitor",
                           "ros/pictures",
                           "ros/probe",
                           "ros/questions",
                           "ros/node",
                           "ros/programs",
                           "rviz/link",
                           "rviz/shapes",
                           "rviz/display",
                           "rviz/panel"};

inline constexpr std::size_t max_files_in_a_folder = 30;
inline constexpr std::size_t max_public_headers = 37;

inline bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

// Layers that a build may leave out, so that none but themselves may include them.
inline const Strings optional_layers{"mjcf", "ompl", "python", "rviz", "sdf"};

inline std::string layer_of(const std::string& room) { return room.substr(0, room.find('/')); }

// What a layer below ros/ may include besides the standard library and lower rooms.
inline const Strings& libraries(const std::string& layer) {
  static const Strings eigen{"Eigen/"};
  static const Strings aspects{"Eigen/", "tbb/", "zlib.h", "fcntl.h", "sys/stat.h", "unistd.h"};
  static const Strings arms{"Eigen/", "boost/multiprecision/"};
  static const Strings distance{"Eigen/", "tbb/"};
  static const Strings draw{"Eigen/", "tbb/", "cairo.h"};
  static const Strings urdf{"Eigen/",          "boost/locale/",   "urdf_parser/", "urdf_model/",
                            "urdf_world/",     "urdf_exception/", "yaml-cpp/",    "tinyxml2.h",
                            "console_bridge/", "dlfcn.h"};
  static const Strings mjcf{"Eigen/", "mujoco/", "tinyxml2.h"};
  static const Strings sdf{"Eigen/", "sdf/"};
  static const Strings mpi{"mpi.h", "nlohmann/", "sys/resource.h", "unistd.h"};
  static const Strings tools{"Eigen/",     "boost/",   "fcntl.h",   "nlohmann/",
                             "sys/file.h", "unistd.h", "yaml-cpp/", "zlib.h"};
  static const Strings ompl{"Eigen/", "ompl/"};
  static const Strings python{"Eigen/", "nlohmann/", "pybind11/"};
  return layer == "aspects"    ? aspects
         : layer == "arms"     ? arms
         : layer == "distance" ? distance
         : layer == "urdf"     ? urdf
         : layer == "draw"     ? draw
         : layer == "tools"    ? tools
         : layer == "mjcf"     ? mjcf
         : layer == "sdf"      ? sdf
         : layer == "mpi"      ? mpi
         : layer == "ompl"     ? ompl
         : layer == "python"   ? python
                               : eigen;
}

inline bool is_optional(const std::string& layer) {
  return std::find(optional_layers.begin(), optional_layers.end(), layer) != optional_layers.end();
}

inline std::ptrdiff_t height(const std::string& room) {
  return std::find(rooms.begin(), rooms.end(), room) - rooms.begin();
}

inline bool is_layer(const std::string& name) {
  return std::any_of(rooms.begin(), rooms.end(),
                     [&](const std::string& room) { return layer_of(room) == name; });
}

// Where the source of a public header is, which is named as "LAYER/NAME.h".
inline std::string room_of_public(const fs::path& root, const fs::path& header) {
  const std::string layer = header.parent_path();
  const std::string source = header.stem().string() + ".cpp";
  std::string lowest;
  for (const std::string& room : rooms) {
    if (layer_of(room) != layer) continue;
    if (fs::exists(root / "src" / room / source)) return room;
    if (lowest.empty()) lowest = room;
  }
  return lowest;
}

// Empty for what is none of the package's own headers.
inline std::string room_of_include(const fs::path& root, const std::string& header) {
  static const std::string own = "parallel_aspects/";
  const bool is_public = starts_with(header, own);
  const fs::path path = is_public ? header.substr(own.size()) : header;
  if (is_public) return path.has_parent_path() ? room_of_public(root, path) : "";
  return fs::exists(root / "src" / path) ? path.parent_path().string() : "";
}

inline bool is_standard(const std::string& header) { return header.find_first_of("./") == std::string::npos; }

inline bool is_allowed(const fs::path& root, const std::string& room, const std::string& header) {
  const std::string other = room_of_include(root, header);
  const std::string layer = layer_of(room);
  if (!other.empty())
    return height(other) <= height(room) && (layer_of(other) == layer || !is_optional(layer_of(other)));
  const Strings& allowed = libraries(layer);
  return layer == "ros" || layer == "rviz" || is_standard(header) ||
         std::any_of(allowed.begin(), allowed.end(),
                     [&](const std::string& start) { return starts_with(header, start); });
}

// A file of data beside the source, which is checked like it.
inline bool is_neighbor(const fs::path& file, const std::string& header) {
  return header.find('/') == std::string::npos && fs::path(header).extension() == ".inc" &&
         fs::exists(file.parent_path() / header);
}

inline Strings includes_of(const fs::path& file) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::ifstream stream(file);
  Strings headers;
  std::smatch match;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_search(line, match, include)) headers.push_back(match[1]);
  return headers;
}

inline bool is_source(const fs::path& file) {
  static const Strings endings{".h", ".hpp", ".cpp", ".cc", ".cxx", ".ipp", ".inl"};
  return std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
}

// With those in the folders below.
inline std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> sources;
  if (!fs::exists(folder)) return sources;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_source(entry.path())) sources.push_back(entry.path());
  return sources;
}

inline std::string folder_of(const fs::path& file, const fs::path& root) {
  return file.parent_path().lexically_relative(root);
}

inline void check_file(const fs::path& root, const fs::path& file, const std::string& room,
                       Strings& violations) {
  for (const std::string& header : includes_of(file))
    if (!is_allowed(root, room, header) && !is_neighbor(file, header))
      violations.push_back(file.string() + " in " + room + " includes " + header);
}

inline Strings violations_in(const fs::path& root) {
  Strings violations;
  for (const std::string& room : rooms)
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "src" / room))
      if (is_source(entry.path())) check_file(root, entry.path(), room, violations);
  const fs::path headers = root / "include" / "parallel_aspects";
  for (const fs::path& header : sources_in(headers))
    check_file(root, header, room_of_public(root, header.lexically_relative(headers)), violations);
  return violations;
}

// Sources in folders that are no rooms would escape the check.
inline Strings strays_in(const fs::path& root) {
  Strings strays;
  for (const fs::path& source : sources_in(root / "src"))
    if (height(folder_of(source, root / "src")) == height("")) strays.push_back(source);
  const fs::path headers = root / "include" / "parallel_aspects";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(headers))
    if (entry.is_regular_file() && !is_layer(folder_of(entry.path(), headers)) &&
        entry.path().parent_path() != headers)
      strays.push_back(entry.path());
  return strays;
}

// Tests that lie in no folder of test/ named as a room, or as a layer for what concerns all of it.
inline Strings stray_tests_in(const fs::path& root) {
  Strings strays;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "test")) {
    const std::string folder = folder_of(entry.path(), root / "test");
    const bool is_test = entry.path().stem().string().find("_test") != std::string::npos &&
                         entry.path().extension() != ".pyc";  // which Python writes beside it
    if (is_test && entry.is_regular_file() && height(folder) == height("") && !is_layer(folder))
      strays.push_back(entry.path());
  }
  return strays;
}

// A test that is named as a source lies where that is.
inline Strings misplaced_tests_in(const fs::path& root) {
  std::map<std::string, std::string> room_of_source;
  const fs::path headers = root / "include" / "parallel_aspects";
  for (const fs::path& header : sources_in(headers))
    room_of_source[header.stem()] = room_of_public(root, header.lexically_relative(headers));
  for (const fs::path& source : sources_in(root / "src"))
    room_of_source[source.stem()] = folder_of(source, root / "src");
  Strings misplaced;
  for (const fs::path& test : sources_in(root / "test")) {
    const std::string stem = test.stem();
    const auto source = room_of_source.find(stem.substr(0, stem.rfind("_test")));
    if (stem.rfind("_test") == std::string::npos || source == room_of_source.end()) continue;
    if (folder_of(test, root / "test") != source->second)
      misplaced.push_back(test.string() + " tests a source of " + source->second);
  }
  return misplaced;
}

// Public headers are what clients compile: they include none that is private, and there are few of them.
inline Strings private_includes_in(const fs::path& root) {
  Strings found;
  for (const fs::path& file : sources_in(root / "include"))
    for (const std::string& header : includes_of(file))
      if (fs::exists(root / "src" / header)) found.push_back(file.string() + " includes " + header);
  return found;
}

// Where one kind of leg is searched for, the compiler does not ask for a new one.
inline Strings single_kinds_in(const fs::path& root) {
  static const std::regex single(R"((get|get_if|holds_alternative)<\w*Actuation>)");
  Strings found;
  for (const fs::path& source : sources_in(root / "src")) {
    std::ifstream stream(source);
    bool any = false;
    for (std::string line; std::getline(stream, line);) any = any || std::regex_search(line, single);
    if (any) found.push_back(source);
  }
  return found;
}

inline std::map<std::string, std::size_t> files_by_folder(const fs::path& folder) {
  std::map<std::string, std::size_t> counts;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) ++counts[entry.path().parent_path()];
  return counts;
}

// Names that are there twice make an #include, or an error message, name either.
inline Strings repeated_names_in(const fs::path& root) {
  std::map<std::string, std::size_t> counts;
  for (const fs::path& folder : {root / "src", root / "include"})
    for (const fs::path& source : sources_in(folder)) ++counts[source.filename()];
  Strings repeated;
  for (const auto& [name, count] : counts)
    if (count > 1) repeated.push_back(name);
  return repeated;
}

inline std::string listed(const Strings& items) {
  std::string text;
  for (const std::string& item : items) text += item + '\n';
  return text;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_TOOLS_LAYER_RULES_H
