// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_MAP_CHOICE_H
#define PARALLEL_ASPECTS_TOOLS_MAP_CHOICE_H

#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Which map a question is asked of, as text from the command line; empty where not given.
struct MapChoice {
  std::string resolution, slice, load_file, save_file;
};

/// `--resolution R`, `--slice "z=1"`, `--load FILE` and `--save FILE`, which fill `choice`.
std::vector<Option> map_choice_options(MapChoice& choice);

/// The map of that choice in these working modes, or all of them where there are none, from the file where it
/// fits, else computed, with a progress bar on a terminal; it is saved where that is asked for. Throws
/// `Interrupted`, or `InvalidDescription` where it is refused.
ask::FoundMap choose_map(const std::shared_ptr<const Manipulator>& manipulator, const MapChoice& choice,
                         const std::optional<MapSlice>& slice, const Surroundings& surroundings,
                         const std::vector<WorkingMode>& modes = {});

/// Tells where the map is from: `loaded` in JSON, and a line where a file was named.
void report_source(const MapChoice& choice, const ask::FoundMap& chosen, Report& report);

/// That line.
std::string source_text(const ask::MapSource& source, bool loaded);

/// Writes a map with the gates between its aspects, which `aspects plan --load` then need not look for; an
/// empty name is none. Throws `Interrupted`, or `InvalidDescription` where it cannot.
void save_with_gates(const AspectMap& map, const std::string& file, const Surroundings& surroundings);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_MAP_CHOICE_H
