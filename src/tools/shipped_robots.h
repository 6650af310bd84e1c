// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SHIPPED_ROBOTS_H
#define PARALLEL_ASPECTS_TOOLS_SHIPPED_ROBOTS_H

#include "parallel_aspects/arms/serial_arm.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/config/map_and_motion_config.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Folder of the shipped robots, with `urdf/NAME.urdf` and `config/robots/NAME.yaml`: what the environment
/// variable PARALLEL_ASPECTS_SHARE names, else the installed share folder next to the running program, else
/// the source tree it was built from. Throws `InvalidDescription` where there is none.
std::filesystem::path share_folder();

/// Names of the robots in a share folder, sorted.
std::vector<std::string> shipped_robots(const std::filesystem::path& share);

/// Names of the serial arms there, with `config/arms/NAME.yaml`, sorted.
std::vector<std::string> shipped_arms(const std::filesystem::path& share);

/// That there is none of that name among those `known`, with the one that may be meant, else with all of them
/// and how `otherwise` robots are given.
std::string no_such_robot(const std::string& name, const std::vector<std::string>& known,
                          const std::string& otherwise);

/// Whether a word is a file, not the name of a shipped robot: it has a dot or a slash.
bool names_file(const std::string& word);

/// Which robot to load, as it was typed: a shipped one by its name, or a pair of files.
struct RobotChoice {
  std::string words{};          ///< a name; or files, as words with a dot or a slash: the URDF, then the YAML
  std::string urdf_option{};    ///< in place of the first file
  std::string config_option{};  ///< in place of the second

  std::string name() const;         ///< empty for files
  std::string urdf_file() const;    ///< empty where none is named
  std::string config_file() const;  ///< likewise
};

/// Loads it. Throws `InvalidDescription` with every problem: an unknown name (the message lists the known
/// ones), a choice that names too much, files that cannot be read, and whatever `load_mechanism` finds, after
/// those that are `known` already. Throws `UsageError` where it names too little.
std::shared_ptr<const Mechanism> load_robot(const RobotChoice& choice, Problems known = {});

/// The serial arm that it names; null where it is no arm, or of no use: then `load_robot` tells. Throws
/// `InvalidDescription` where it is an arm that is refused.
std::shared_ptr<const SerialArm> load_arm(const RobotChoice& choice);

/// How the map of a robot is to be computed, as its files say.
struct MapSection {
  MapConfig config;
  std::string file;  ///< that it stands in
};

/// The section `map` of the YAML of the robot. What is wrong with it is added to `problems`; of a choice or
/// files of no use `load_robot` tells.
MapSection load_map_section(const RobotChoice& choice, Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SHIPPED_ROBOTS_H
