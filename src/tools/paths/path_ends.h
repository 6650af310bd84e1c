// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PATHS_PATH_ENDS_H
#define PARALLEL_ASPECTS_TOOLS_PATHS_PATH_ENDS_H

#include "parallel_aspects/motion/plan_path.h"
#include "tools/subcommands.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// One end of a path as text from the command line; empty where not given.
struct PathEndArguments {
  std::string pose, mode, joints, aspect;
};

/// `--from POSE`, `--from-mode`, `--from-joints` and `--from-aspect`, or with another name the same; they
/// fill `arguments`.
std::vector<Option> path_end_options(const std::string& option, PathEndArguments& arguments);

/// The end that a pose or values of the actuated joints give: of these the assembly mode next to the pose,
/// where they have several. Of an aspect its number is all that is looked at. Throws `UsageError` where
/// nothing says where it is.
PathEnd parse_path_end(const std::string& option, const Manipulator& manipulator,
                       const PathEndArguments& arguments, Problems& problems);

/// Puts the deepest configuration of the aspect in place of `end` where an aspect is asked for.
void place_in_aspect(const std::string& option, const AspectMap& map, const PathEndArguments& arguments,
                     PathEnd& end, Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PATHS_PATH_ENDS_H
