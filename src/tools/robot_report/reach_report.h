// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_ROBOT_REPORT_REACH_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_ROBOT_REPORT_REACH_REPORT_H

#include "parallel_aspects/ask/robot_description.h"

#include <string>

namespace parallel_aspects::tools {

/// The home pose as `--pose` takes it, with as many digits as it takes to be solved by `aspects ik`.
std::string home_text(const ask::RobotDescription& description);

/// Where the workspace is, and where the platform turns, how far each coordinate moves alone.
std::string reach_text(const ask::RobotDescription& description);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_ROBOT_REPORT_REACH_REPORT_H
