// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_ROBOT_REPORT_REACH_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_ROBOT_REPORT_REACH_REPORT_H

#include "parallel_aspects/urdf/mechanism.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// `Mechanism::home` as `--pose` takes it, with as many digits as it takes to be solved by `aspects ik`.
Report report_home(const Mechanism& mechanism);

/// Where the workspace is: what the legs reach about the home pose and at seeded random poses, and where the
/// platform turns, how far each coordinate moves alone.
Report report_reach(const Mechanism& mechanism);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_ROBOT_REPORT_REACH_REPORT_H
