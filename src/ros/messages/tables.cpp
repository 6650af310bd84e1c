// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/tables.h"

#include <cstdio>

namespace parallel_aspects {

std::string aspect_table(const AspectMap& map) {
  const TaskSpace space = map.manipulator()->task_space();
  const std::string unit(measure_unit(space));
  char line[160];
  std::snprintf(line, sizeof line, "%7s  %-16s %-6s %14s  %s\n", "aspect", "working mode", "det A",
                ("size [" + unit + "]").c_str(), "deepest pose");
  std::string table = line;
  for (const Aspect& aspect : map.aspects()) {
    std::snprintf(line, sizeof line, "%7d  %-16s %-6s %14.5g  ", aspect.id, to_string(aspect.mode).c_str(),
                  aspect.determinant_sign > 0 ? "> 0" : "< 0", aspect.measure);
    table += line + to_string(space, aspect.deepest) + "\n";
  }
  return table;
}

}  // namespace parallel_aspects
