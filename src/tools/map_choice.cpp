// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map_choice.h"

#include "parallel_aspects/aspects/map_file.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/report/numbers.h"

#include <utility>

namespace parallel_aspects::tools {

std::vector<Option> map_choice_options(MapChoice& choice) {
  return {
      {"--resolution", "R",
       "Longest edge of an undecided leaf of the base map [m or rad]; by default what suits the robot",
       &choice.resolution},
      {"--slice", "\"z=1\"",
       "Stay in a line, plane or volume of poses: what is held, with its value [m or rad]; the rest is free",
       &choice.slice},
      {"--load", "FILE", "Take the map from this file if it is of this robot and these options",
       &choice.load_file}};
}

std::shared_ptr<const AspectMap> choose_map(const std::shared_ptr<const Manipulator>& manipulator,
                                            const MapChoice& choice, const Surroundings& surroundings) {
  Problems problems;
  MapOptions options;
  if (!choice.resolution.empty())
    options.resolution = parse_positive("--resolution", choice.resolution, problems);
  if (!choice.slice.empty()) options.slice = parse_slice("--slice", *manipulator, choice.slice, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  if (!choice.load_file.empty()) {
    const MapResult loaded = load_map(manipulator, options, choice.load_file);
    if (loaded) return loaded.map;
    surroundings.messages << loaded.message << std::endl;
  }
  return completed(
             surroundings,
             [&](const MapControl& control) { return compute_aspect_map(manipulator, options, control); })
      .map;
}

}  // namespace parallel_aspects::tools
