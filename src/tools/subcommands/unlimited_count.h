// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_UNLIMITED_COUNT_H
#define PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_UNLIMITED_COUNT_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "tools/command.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// Where joints have limits: adds how many aspects there are without them in the region of the map, which had
/// these options, and in the text, where it is another number, what leaves the limits out. Nothing where
/// there are none, or where the region has so many boxes that it may take longer than the map, unless it is
/// `asked_for`. Throws Interrupted at Ctrl-C.
void add_count_without_limits(const AspectMap& map, MapOptions options, bool asked_for,
                              const Surroundings& surroundings, Report& report);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_UNLIMITED_COUNT_H
