// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_VIOLATION_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_VIOLATION_REPORT_H

#include "parallel_aspects/motion/check_trajectory.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {

/// "parallel_singularity", "serial_singularity", "actuated_limit", "constraint" or "none".
const char* name_of(Violation kind);

/// {"kind", "leg", "constraint", "after", "before"}.
nlohmann::json json_violation(const Manipulator& manipulator, const TrajectoryViolation& violation);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_VIOLATION_REPORT_H
