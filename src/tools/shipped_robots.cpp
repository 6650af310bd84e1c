// SPDX-License-Identifier: BSD-3-Clause
#include "tools/shipped_robots.h"

#include "parallel_aspects/model/wings.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"
#include "urdf/arm_reading.h"
#include "urdf/description/text_file.h"
#include "urdf/reading/description_file.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace parallel_aspects::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* share_variable = "PARALLEL_ASPECTS_SHARE";

fs::path urdf_path(const fs::path& share, const std::string& name) {
  return share / "urdf" / (name + ".urdf");
}

fs::path config_folder(const fs::path& share) { return share / "config" / "robots"; }

fs::path arm_folder(const fs::path& share) { return share / "config" / "arms"; }

bool holds_robots(const fs::path& share) {
  std::error_code error;
  return fs::is_directory(config_folder(share), error);
}

// The program is installed as PREFIX/bin/aspects or, by catkin, as PREFIX/lib/parallel_aspects/aspects.
std::vector<fs::path> usual_folders() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  return {folder / ".." / "share" / "parallel_aspects", folder / ".." / ".." / "share" / "parallel_aspects",
          PARALLEL_ASPECTS_SOURCE_DIR};
}

/// The n-th of the words, counted from 0; empty where there are fewer.
std::string word_of(const RobotChoice& choice, std::size_t n) {
  std::istringstream words(choice.words);
  std::string word;
  for (std::size_t i = 0; i <= n; ++i)
    if (!std::getline(words, word)) return "";
  return word;
}

/// Which of the words is the YAML.
std::size_t place_of_config(const RobotChoice& choice) { return choice.urdf_option.empty() ? 1 : 0; }

/// That of the option, else that of the words.
std::string file_of(const RobotChoice& choice, const std::string& option, std::size_t n) {
  if (!option.empty() || !choice.name().empty()) return option;
  return word_of(choice, n);
}

RobotChoice shipped_files(const std::string& name) {
  const fs::path share = share_folder();
  const std::vector<std::string> known = shipped_robots(share);
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw InvalidDescription({no_such_robot(name, known, "ROBOT.urdf ROBOT.yaml")});
  return {"", urdf_path(share, name).string(), (config_folder(share) / (name + ".yaml")).string()};
}

/// Which argument is missing, or has no place; empty where all is well.
std::string misplaced_argument(const RobotChoice& choice) {
  const std::string extra = word_of(choice, choice.name().empty() ? place_of_config(choice) + 1 : 1);
  if (!extra.empty()) return "'" + extra + "': there is no place for it";
  const std::string urdf = choice.urdf_file(), config = choice.config_file();
  if (!choice.name().empty() || (!urdf.empty() && !config.empty())) return "";
  if (urdf.empty() && config.empty())
    return "ROBOT is required; name a shipped robot, or give ROBOT.urdf ROBOT.yaml";
  const std::string remedy =
      wings::setup ? "`aspects setup " + urdf + "` writes it" : "give it as the next word";
  return config.empty() ? "its YAML is required behind '" + urdf + "'; " + remedy
                        : "--urdf is required with --config; give the URDF of the robot";
}

Problems problems_of(const RobotChoice& choice) {
  const std::string name = choice.name();
  const bool has_urdf = !choice.urdf_option.empty(), has_config = !choice.config_option.empty();
  if (!name.empty() && (has_urdf || has_config))
    return {"Robot '" + name + "' is named and files are given too; give a name, or ROBOT.urdf ROBOT.yaml."};
  if (has_config && !word_of(choice, place_of_config(choice)).empty())
    return {"A file is given twice, as a word and by its option; give ROBOT.urdf ROBOT.yaml."};
  const fs::path urdf = choice.urdf_file(), config = choice.config_file();
  if (config.extension() == ".urdf" && urdf.extension() != ".urdf")
    return {"'" + config.string() + "' is given as the YAML of '" + urdf.string() +
            "'; give the URDF first, then the YAML."};
  return {};
}

void throw_any(Problems problems) {
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
}

std::shared_ptr<const Mechanism> load(const RobotChoice& choice) {
  throw_any(problems_of(choice));
  const std::string name = choice.name();
  const RobotChoice files = name.empty() ? choice : shipped_files(name);
  return load_mechanism_files(files.urdf_file(), files.config_file());
}

}  // namespace

std::string no_such_robot(const std::string& name, const std::vector<std::string>& known,
                          const std::string& otherwise) {
  const std::string meant = did_you_mean(name, known);
  return "There is no shipped robot '" + name + "'" +
         (meant.empty() ? "; take one of: " + joined(known, ", ") + "; or give " + otherwise + "." : meant);
}

bool names_file(const std::string& word) { return word.find_first_of("./") != std::string::npos; }

std::string RobotChoice::name() const {
  const std::string first = word_of(*this, 0);
  return names_file(first) ? "" : first;
}

std::string RobotChoice::urdf_file() const { return file_of(*this, urdf_option, 0); }

std::string RobotChoice::config_file() const { return file_of(*this, config_option, place_of_config(*this)); }

fs::path share_folder() {
  const char* chosen = std::getenv(share_variable);
  if (chosen != nullptr && *chosen != '\0') {
    if (holds_robots(chosen)) return chosen;
    throw InvalidDescription({std::string("Environment variable ") + share_variable + " names '" + chosen +
                              "', where there is no folder config/robots; correct or unset it."});
  }
  for (const fs::path& folder : usual_folders())
    if (holds_robots(folder)) return folder.lexically_normal();
  throw InvalidDescription({std::string("The shipped robots were not found; set the environment variable ") +
                            share_variable + " to the folder that holds urdf/ and config/robots/."});
}

namespace {

std::vector<std::string> names_in(const fs::path& folder, const fs::path& share) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".yaml" && fs::exists(urdf_path(share, name), error))
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::vector<std::string> shipped_robots(const fs::path& share) {
  return names_in(config_folder(share), share);
}

std::vector<std::string> shipped_arms(const fs::path& share) { return names_in(arm_folder(share), share); }

namespace {

/// Where the YAML of the robot stands, and its text; empty where `load_robot` reports what is wrong.
std::string config_text(const RobotChoice& choice, std::string& file) {
  if (!misplaced_argument(choice).empty() || !problems_of(choice).empty()) return "";
  const std::string name = choice.name();
  file = name.empty() ? choice.config_file() : (config_folder(share_folder()) / (name + ".yaml")).string();
  Problems reported_by_load_robot;
  return read_text_file(file, reported_by_load_robot).value_or("");
}

}  // namespace

MapSection load_map_section(const RobotChoice& choice, Problems& problems) {
  MapSection section;
  const std::string text = config_text(choice, section.file);
  section.config = read_map_config(text, section.file, problems);
  return section;
}

std::shared_ptr<const SerialArm> load_arm(const RobotChoice& choice) {
  if (!misplaced_argument(choice).empty() || !problems_of(choice).empty()) return nullptr;
  std::string urdf = choice.urdf_file(), config = choice.config_file();
  if (const std::string name = choice.name(); !name.empty()) {
    const fs::path share = share_folder();
    const std::vector<std::string> arms = shipped_arms(share);
    if (std::find(arms.begin(), arms.end(), name) == arms.end()) return nullptr;
    urdf = urdf_path(share, name).string();
    config = (arm_folder(share) / (name + ".yaml")).string();
  }
  Problems problems;
  const auto urdf_text = read_description_file(urdf, problems),
             config_text = read_text_file(config, problems);
  if (!urdf_text || !config_text) return nullptr;
  return read_arm(*urdf_text, urdf, *config_text, config);
}

std::shared_ptr<const Mechanism> load_robot(const RobotChoice& choice, Problems known) {
  if (const std::string missing = misplaced_argument(choice); !missing.empty()) throw UsageError(missing);
  try {
    auto mechanism = load(choice);
    if (known.empty()) return mechanism;
  } catch (const InvalidDescription& invalid) {
    known.insert(known.end(), invalid.problems().begin(), invalid.problems().end());
  }
  throw InvalidDescription(std::move(known));
}

}  // namespace parallel_aspects::tools
