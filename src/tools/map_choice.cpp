// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map_choice.h"

#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/question_options.h"

#include <utility>

namespace parallel_aspects::tools {

std::vector<Option> map_choice_options(MapChoice& choice) {
  return {{"--resolution", "R",
           "Longest edge of an undecided leaf of the base map [m or rad]; by default what suits the robot",
           &choice.resolution},
          {"--slice", "\"z=1\"",
           "Stay in a line, plane or volume of poses: what is held, with its value [m or rad]; the rest is "
           "free. In "
           "SE2 an actuated joint may be held, such as \"strut_1_joint=15\"",
           &choice.slice, false, Words::assignments},
          {"--load", "FILE", "Take the map from this file if it is of this robot and these options",
           &choice.load_file, false, Words::one, FileUse::loaded},
          {"--save", "FILE", "Write the map to this file, with its gates, for --load", &choice.save_file,
           false, Words::one, FileUse::saved}};
}

ask::FoundMap choose_map(const std::shared_ptr<const Manipulator>& manipulator, const MapChoice& choice,
                         const std::optional<MapSlice>& slice, const Surroundings& surroundings,
                         const std::vector<WorkingMode>& modes) {
  Problems problems;
  ask::MapSource source{{}, slice, choice.load_file, choice.save_file};
  if (!choice.resolution.empty())
    source.resolution = parse_positive("--resolution", choice.resolution, problems);
  check_map_output("--save", choice.save_file, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  ask::ProblemList refused;
  const ShownAnswering shown(surroundings);
  ask::FoundMap found = ask::Session(manipulator).map(source, modes, shown.control(), refused);
  if (!refused.empty()) refuse(refused);
  if (!found.map) throw Interrupted{};
  return found;
}

void report_source(const MapChoice& choice, const ask::FoundMap& chosen, Report& report) {
  report.json["loaded"] = chosen.loaded;
  report.text += source_text({{}, {}, choice.load_file, choice.save_file}, chosen.loaded);
}

std::string source_text(const ask::MapSource& source, bool loaded) {
  std::string text;
  if (!source.load.empty())
    text += loaded ? "the map is that of " + source.load + "\n"
                   : "the map was computed, as " + source.load + " does not have it\n";
  if (!source.save.empty()) text += "the map is saved to " + source.save + "\n";
  return text;
}

void save_with_gates(const AspectMap& map, const std::string& file, const Surroundings& surroundings) {
  if (file.empty()) return;
  ask::ProblemList problems;
  if (ask::save_with_gates(map, file, control_of(surroundings), problems)) return;
  if (!problems.empty()) refuse(problems);
  throw Interrupted{};
}

}  // namespace parallel_aspects::tools
