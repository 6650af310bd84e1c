// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PATH_TIMING_H
#define PARALLEL_ASPECTS_TOOLS_PATH_TIMING_H

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

/// The acceleration limits, of the option or else of the YAML of the robot; nothing where no trajectory is
/// asked for. What keeps paths from being timed, and files from being written, is added to `problems`.
std::optional<JointVector> parse_timing(const TimingArguments& arguments, const RobotChoice& robot,
                                        const Manipulator& manipulator, Problems& problems);

/// Writes the trajectory, where there is one, and adds to the report what is known of it.
void report_timing(const Manipulator& manipulator, const TimingArguments& arguments, const TimedPath& timed,
                   Report& report);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PATH_TIMING_H
