// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PATHS_PATH_TIMING_H
#define PARALLEL_ASPECTS_TOOLS_PATHS_PATH_TIMING_H

#include "parallel_aspects/motion/time_path.h"
#include "tools/report/report.h"
#include "tools/shipped_robots.h"
#include "tools/subcommands.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Whether and how a planned path is timed, as options say.
struct TimingArguments {
  std::string trajectory_file, acceleration;
};

/// The options for them.
std::vector<Option> timing_options(TimingArguments& arguments);

/// The acceleration limits, of the option or else of the YAML of the robot; nothing where paths cannot be
/// timed. Where either option is given, or another one that needs them, `needed_by`, which may be empty, what
/// keeps them from that is added to `problems`, and so is what keeps the file from being written.
std::optional<JointVector> parse_timing(const TimingArguments& arguments, const std::string& needed_by,
                                        const RobotChoice& robot, const Manipulator& manipulator,
                                        Problems& problems);

/// Adds to the report what is known of the path in time, and writes it where that is asked for: unknown where
/// there is none then.
void report_timing(const Manipulator& manipulator, const TimingArguments& arguments, const TimedPath& timed,
                   Report& report);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PATHS_PATH_TIMING_H
